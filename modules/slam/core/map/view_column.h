// The grid that thins a map: columns along the view instead of cubes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "slam/core/map/grid_key.h"

namespace bole::slam {

// In a cube as small as the noise of the ranges, which return comes first depends on that noise: the middle of the
// scatter fills up, its rims keep all they get, and the outer rim of a round stem has more cubes than the inner one.
// Stems come out thicker for it, by 3 cm at 2.5 cm of noise. So a cell is as wide as asked for across the view, and far
// longer than any noise along it: what is kept then does not depend on the range. Views are told apart by sectors of
// their direction, since a column belongs to one direction.
class ViewColumns {
 public:
  explicit ViewColumns(double width_m) : per_m_(1 / width_m) {
    for (int border = 1; border < elevations; ++border) {
      cos_[static_cast<std::size_t>(border - 1)] = std::cos(border * step);
      sin_[static_cast<std::size_t>(border - 1)] = std::sin(border * step);
    }
    for (int azimuth = 0; azimuth < azimuths; ++azimuth)
      for (int elevation = 0; elevation < elevations; ++elevation) {
        const double a = (azimuth + 0.5) * step - std::numbers::pi,
                     e = (elevation + 0.5) * step - 0.5 * std::numbers::pi;
        const int direction = azimuth * elevations + elevation;
        auto& axes = axes_[static_cast<std::size_t>(direction)];
        axes.row(0) << -std::sin(a), std::cos(a), 0;
        axes.row(1) << -std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e);
        axes.row(2) << std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e);
      }
  }

  // Mixed bits: to be told apart further by hashing them again.
  std::uint64_t key(const Eigen::Vector3d& position, const Eigen::Vector3d& sensor) const {
    const Eigen::Vector3d ray = position - sensor;
    const bool left = ray.y() >= 0;
    const int azimuth = left ? elevations + sector(ray.x(), ray.y()) : sector(-ray.x(), -ray.y()),
              elevation = sector(-ray.z(), ray.head<2>().norm());
    const int view = azimuth * elevations + elevation;
    const Eigen::Vector3d p = axes_[static_cast<std::size_t>(view)] * position;
    const auto u = static_cast<std::int64_t>(std::floor(p.x() * per_m_)),
               v = static_cast<std::int64_t>(std::floor(p.y() * per_m_));
    const std::uint64_t column = mix_bits(pack_cell(u, v, view));
    // Columns begin at different depths, so that no surface lies on the border of many.
    const auto depth =
        static_cast<std::int64_t>(std::floor(p.z() / length_m + static_cast<double>(column & 0xffff) / 65536.0));
    return mix_bits(column ^ (static_cast<std::uint64_t>(depth) * 0x9e3779b97f4a7c15ull));
  }

 private:
  static constexpr double length_m = 2.0;
  static constexpr int elevations = 9, azimuths = 2 * elevations;
  static constexpr double step = std::numbers::pi / elevations;  // of both

  // Which of the steps of half a turn the angle of (x, y) lies in, y not negative: on the left of how many borders it
  // lies. The angle itself would take most of the time of a key.
  int sector(double x, double y) const {
    int passed = 0;
    for (std::size_t border = 0; border < cos_.size(); ++border) passed += cos_[border] * y >= sin_[border] * x;
    return passed;
  }

  double per_m_;
  std::array<double, elevations - 1> cos_{}, sin_{};  // of the borders between the steps
  std::array<Eigen::Matrix3d, azimuths * elevations> axes_;
};

}  // namespace bole::slam
