#include "slam/core/place_guess.h"

#include <cmath>
#include <numbers>

#include "slam/core/grid_key.h"

namespace bole {
namespace {

constexpr double cell_m = 0.3, reach_m = 25, height_m = 5, point_spacing_m = 0.4;
constexpr int steps_ahead = 10, steps_aside = 3, steps_up = 1, steps_turn = 3;  // to each side
constexpr double step_turn_rad = 2 * std::numbers::pi / 180;

// Which cells about a place are taken; offsets are whole cells, so that a shift is an addition.
class Occupancy {
 public:
  explicit Occupancy(const Eigen::Vector3d& middle)
      : middle_(middle), n_(2 * static_cast<int>(reach_m / cell_m)), n_up_(2 * static_cast<int>(height_m / cell_m)) {
    taken_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_up_), 0);
  }
  Eigen::Vector3i cell(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d c = (p - middle_) / cell_m;
    return {static_cast<int>(std::floor(c.x())) + n_ / 2, static_cast<int>(std::floor(c.y())) + n_ / 2,
            static_cast<int>(std::floor(c.z())) + n_up_ / 2};
  }
  void take(const Eigen::Vector3i& c) {
    if (inside(c)) taken_[index(c)] = 1;
  }
  int at(const Eigen::Vector3i& c) const { return inside(c) ? taken_[index(c)] : 0; }

 private:
  bool inside(const Eigen::Vector3i& c) const {
    return c.x() >= 0 && c.x() < n_ && c.y() >= 0 && c.y() < n_ && c.z() >= 0 && c.z() < n_up_;
  }
  std::size_t index(const Eigen::Vector3i& c) const {
    return (static_cast<std::size_t>(c.z()) * static_cast<std::size_t>(n_) + static_cast<std::size_t>(c.y())) *
               static_cast<std::size_t>(n_) +
           static_cast<std::size_t>(c.x());
  }
  Eigen::Vector3d middle_;
  int n_, n_up_;
  std::vector<std::uint8_t> taken_;
};

std::vector<Eigen::Vector3d> points_of(const Keyframe& keyframe) {
  GridKeySet seen(keyframe.edges.size() + keyframe.planes.size());
  std::vector<Eigen::Vector3d> out;
  for (const auto* part : {&keyframe.edges, &keyframe.planes})
    for (const auto& p : *part)
      if (p.norm() < reach_m && seen.insert(grid_key(Eigen::Vector3d(p.cast<double>() / point_spacing_m))))
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
  std::vector<Eigen::Vector3i> cells(points.size());
  for (int turn = -steps_turn; turn <= steps_turn; ++turn) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(turn * step_turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * guess.linear();
    for (std::size_t i = 0; i < points.size(); ++i) cells[i] = occupancy.cell(R * points[i] + guess.translation());
    for (int ahead = -steps_ahead; ahead <= steps_ahead; ++ahead)
      for (int aside = -steps_aside; aside <= steps_aside; ++aside)
        for (int up = -steps_up; up <= steps_up; ++up) {
          const double c = std::cos(heading), s = std::sin(heading);
          const Eigen::Vector3i shift(static_cast<int>(std::lround(ahead * c - aside * s)),
                                      static_cast<int>(std::lround(ahead * s + aside * c)), up);
          int hits = 0;
          for (const auto& cell : cells) hits += occupancy.at(cell + shift);
          const double score = points.empty() ? 0 : static_cast<double>(hits) / static_cast<double>(points.size());
          if (score <= best.score) continue;
          best.score = score;
          best.T_map_keyframe.linear() = R;
          best.T_map_keyframe.translation() = guess.translation() + cell_m * shift.cast<double>();
        }
  }
  return best;
}

}  // namespace bole
