#include "slam/core/loops/place_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/angles.h"
#include "slam/core/map/grid_key.h"

namespace bole::slam {
namespace {

constexpr double cell_size = 0.3, reach = 25, height = 5, point_spacing = 0.4;
constexpr int steps_ahead = 10, steps_aside = 3, steps_up = 1, steps_turn = 3;  // to each side
constexpr double step_turn_rad = radians(2);

// Occupied cells around a place. Offsets are whole cells, so that a shift is an addition to an index; the margin holds
// what a shift moves out of the grid. A cell also holds the bits of the cells below and above it.
class Occupancy {
 public:
  explicit Occupancy(const Eigen::Vector3d& middle)
      : middle_(middle), taken_(static_cast<std::size_t>(stride_up * (n_up + 2 * margin_up))) {}

  Eigen::Vector3i cell(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d c = (p - middle_) / cell_size;
    return {static_cast<int>(std::floor(c.x())) + n / 2, static_cast<int>(std::floor(c.y())) + n / 2,
            static_cast<int>(std::floor(c.z())) + n_up / 2};
  }
  void take(const Eigen::Vector3i& c) {
    if (!inside(c, 0, 0)) return;
    for (int up = -steps_up; up <= steps_up; ++up)
      taken_[static_cast<std::size_t>(index(c) - up * stride_up)] |= static_cast<std::uint8_t>(1 << (up + steps_up));
  }
  // Whether a shift can bring the cell into the grid.
  bool within_reach(const Eigen::Vector3i& c) const { return inside(c, margin / 2, steps_up); }
  static int index(const Eigen::Vector3i& c) {
    return (c.z() + margin_up) * stride_up + (c.y() + margin) * stride + c.x() + margin;
  }
  static int offset(const Eigen::Vector2i& shift) { return shift.y() * stride + shift.x(); }

  // How many of the cells are occupied when all are shifted by `offset` and up by -steps_up to steps_up.
  std::array<int, 2 * steps_up + 1> hits(const std::vector<int>& indices, int offset) const {
    constexpr int bits = 21;
    static constexpr auto counts = [] {
      std::array<std::uint64_t, 1 << (2 * steps_up + 1)> of_mask{};
      for (std::size_t mask = 0; mask < of_mask.size(); ++mask)
        for (int k = 0; k <= 2 * steps_up; ++k)
          if (mask >> k & 1) of_mask[mask] += std::uint64_t{1} << (k * bits);
      return of_mask;
    }();
    std::uint64_t sum = 0;
    for (const int i : indices) {
      const int at = i + offset;
      sum += counts[taken_[static_cast<std::size_t>(at)]];
    }
    std::array<int, 2 * steps_up + 1> out{};
    for (int k = 0; k <= 2 * steps_up; ++k)
      out[static_cast<std::size_t>(k)] = static_cast<int>(sum >> (k * bits) & ((1u << bits) - 1));
    return out;
  }

 private:
  static constexpr int n = 2 * static_cast<int>(reach / cell_size), n_up = 2 * static_cast<int>(height / cell_size);
  static constexpr int margin = 2 * (steps_ahead + steps_aside), margin_up = 2 * steps_up;
  static constexpr int stride = n + 2 * margin, stride_up = stride * stride;

  static bool inside(const Eigen::Vector3i& c, int beyond, int beyond_up) {
    return c.x() >= -beyond && c.x() < n + beyond && c.y() >= -beyond && c.y() < n + beyond && c.z() >= -beyond_up &&
           c.z() < n_up + beyond_up;
  }

  Eigen::Vector3d middle_;
  std::vector<std::uint8_t> taken_;  // bit k: the cell k - steps_up above
};

std::vector<Eigen::Vector3d> points_of(const Keyframe& keyframe) {
  GridKeySet seen(keyframe.edges.size() + keyframe.planes.size());
  std::vector<Eigen::Vector3d> out;
  for (const auto* part : {&keyframe.edges, &keyframe.planes})
    for (const auto& p : *part)
      if (p.norm() < reach && seen.insert(grid_key(Eigen::Vector3d(p.cast<double>() / point_spacing))))
        out.push_back(p.cast<double>());
  return out;
}

}  // namespace

PlaceGuess place_on_stretch(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last,
                            const Keyframe& keyframe, const Pose& guess) {
  Occupancy occupancy(guess.translation());
  for (std::size_t k = first; k <= last; ++k)
    for (const auto* part : {&keyframes[k].edges, &keyframes[k].planes})
      for (const auto& p : *part) occupancy.take(occupancy.cell(keyframes[k].T_map_keyframe * p.cast<double>()));

  const auto points = points_of(keyframe);
  const double heading = std::atan2(guess.linear()(1, 0), guess.linear()(0, 0));
  PlaceGuess best{guess, -1};
  std::vector<int> indices;
  for (int turn = -steps_turn; turn <= steps_turn; ++turn) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(turn * step_turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * guess.linear();
    indices.clear();
    for (const auto& p : points)
      if (const auto cell = occupancy.cell(R * p + guess.translation()); occupancy.within_reach(cell))
        indices.push_back(Occupancy::index(cell));
    for (int ahead = -steps_ahead; ahead <= steps_ahead; ++ahead)
      for (int aside = -steps_aside; aside <= steps_aside; ++aside) {
        const double c = std::cos(heading), s = std::sin(heading);
        const Eigen::Vector2i shift(static_cast<int>(std::lround(ahead * c - aside * s)),
                                    static_cast<int>(std::lround(ahead * s + aside * c)));
        const auto hits = occupancy.hits(indices, Occupancy::offset(shift));
        for (int up = -steps_up; up <= steps_up; ++up) {
          const int level = up + steps_up;
          const double share = static_cast<double>(hits[static_cast<std::size_t>(level)]) /
                               static_cast<double>(std::max<std::size_t>(1, points.size()));
          if (share <= best.score) continue;
          best.score = share;
          best.T_map_keyframe.linear() = R;
          best.T_map_keyframe.translation() =
              guess.translation() + cell_size * Eigen::Vector3d(shift.x(), shift.y(), up);
        }
      }
  }
  return best;
}

}  // namespace bole::slam
