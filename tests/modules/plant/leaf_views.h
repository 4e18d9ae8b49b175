// Pictures of a flat leaf before a mottled table, and clouds of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "cloud/core/view_source.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

inline constexpr double half_length = 0.06,
                        half_width = 0.02;  // of the leaf, a rhombus in the plane z = 0.2, long in x

inline bool on_leaf(double x, double y, double share = 1) {
  return std::abs(x) / (half_length * share) + std::abs(y) / (half_width * share) <= 1;
}

class LeafViews : public ViewSource {
 public:
  // `green_table`: whether the table is green as well, as moss is. `gap`: of the leaf, metres along x from its middle,
  // that is not there.
  explicit LeafViews(bool green_table = false, double gap = 0) : green_table_(green_table), gap_(gap) {
    camera_.color = {640, 480, 600, 600, 320, 240, {}};
    for (int i = 0; i < 20; ++i) {
      const double turn = 2 * std::numbers::pi * i / 20;
      const Eigen::Vector3d eye(0.3 * std::cos(turn), 0.3 * std::sin(turn), 0.45 + 0.02 * (i % 3));
      const Eigen::Vector3d ahead = (Eigen::Vector3d(0, 0, 0.2) - eye).normalized();
      const Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
      Pose pose = Pose::Identity();
      pose.linear() << right, ahead.cross(right), ahead;
      pose.translation() = eye;
      poses_.poses.push_back({i / 30.0, pose});
    }
  }
  std::size_t size() const override { return poses_.poses.size(); }
  double time_s(std::size_t i) const override { return poses_.poses[i].time_s; }
  std::string name(std::size_t i) const override { return std::to_string(i); }
  const RgbdCamera& camera(std::size_t) const override { return camera_; }
  bool has_depth() const override { return false; }
  const Trajectory& given_poses() const override { return poses_; }
  std::string description() const override { return "leaf"; }
  std::string locator() const override { return "{}"; }
  void read(std::size_t i, View& view, ViewParts) const override {
    const auto& c = camera_.color;
    const Pose& T = poses_.poses[i].T_target_sensor;
    view.color = ColorImage(c.width, c.height, 3);
    constexpr int fine = 4;
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x) {
        double leaf = 0;
        for (int k = 0; k < fine * fine; ++k) {
          const Eigen::Vector2d at(x + (k % fine + 0.5) / fine - 0.5, y + (k / fine + 0.5) / fine - 0.5);
          const Eigen::Vector3d ray = T.linear() * c.direction(at);
          const double s = (0.2 - T.translation().z()) / ray.z();
          const Eigen::Vector3d p = T.translation() + s * ray;
          leaf += on_leaf(p.x(), p.y()) && !(p.x() > 0 && p.x() < gap_) ? 1.0 / (fine * fine) : 0;
        }
        // The table behind, in squares of 1 cm of many greys.
        const Eigen::Vector3d ray = T.linear() * c.direction(Eigen::Vector2d(x, y));
        const Eigen::Vector3d p = T.translation() + (-0.1 - T.translation().z()) / ray.z() * ray;
        Random mottle(7, static_cast<std::uint64_t>(std::floor(100 * p.x()) + 1000),
                      static_cast<std::uint64_t>(std::floor(100 * p.y()) + 1000));
        const double grey = 120 + 60 * mottle.uniform();
        const double green[3]{40, 90, 30};
        for (int channel = 0; channel < 3; ++channel)
          view.color.at(x, y, channel) = static_cast<std::uint8_t>(
              std::lround(leaf * green[channel] + (1 - leaf) * (green_table_ ? green[channel] * grey / 120 : grey)));
      }
  }

 private:
  bool green_table_;
  double gap_;
  RgbdCamera camera_;
  Trajectory poses_;
};

// Points of the leaf made `share` as large, with noise.
inline Points3 leaf_cloud(double share, double noise) {
  Random random(3, 1);
  Points3 out;
  while (out.size() < 6000) {
    const double x = random.uniform(-half_length, half_length), y = random.uniform(-half_width, half_width);
    if (on_leaf(x, y, share))
      out.push_back(Eigen::Vector3d(x, y, 0.2) +
                    noise * Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
  }
  return out;
}

inline std::vector<std::uint32_t> all_of(const ViewSource& views) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < views.size(); ++i) out.push_back(i);
  return out;
}

}  // namespace bole::plant
