// The motion of the sensor within a frame, and points moved into map axes with it.
#pragma once

#include <algorithm>
#include <array>
#include <memory>

#include "base/transform.h"

namespace bole::slam {

// How the motion within a frame departs from a straight one, as an inertial unit saw it or as the points of a long
// frame tell: the pose at s is interpolate(begin, end, s) after(s). A correction of begin and end leaves it as it is.
struct MotionShape {
  static constexpr std::size_t steps = 32;
  std::array<Pose, steps + 1> after;

  Pose at(double s) const {
    const double x = std::clamp(s, 0.0, 1.0) * static_cast<double>(steps);
    const auto i = std::min(static_cast<std::size_t>(x), steps - 1);
    return interpolate(after[i], after[i + 1], x - static_cast<double>(i));
  }
};

// Motion over one frame: rotation by slerp, translation linear, or with the shape that was measured.
struct FrameMotion {
  Pose T_map_begin = Pose::Identity();
  Pose T_map_end = Pose::Identity();
  std::shared_ptr<const MotionShape> shape = nullptr;

  Pose at(double s) const {
    const Pose straight = interpolate(T_map_begin, T_map_end, s);
    return shape ? Pose(straight * shape->at(s)) : straight;
  }
  // The motion over the frame in the axes of its begin.
  Pose delta() const { return T_map_begin.inverse() * T_map_end; }
};

// Share of the bend in the middle of a frame that its pose at s has: a parabola, as of a constant acceleration.
inline double bend_share(double s) { return 4 * s * (1 - s); }

// A motion whose middle departs from the straight one by `bend` (turn rad, shift m; map axes).
inline FrameMotion bent_motion(const Pose& T_map_begin, const Pose& T_map_end, const Vector6d& bend) {
  auto shape = std::make_shared<MotionShape>();
  for (std::size_t i = 0; i <= MotionShape::steps; ++i) {
    const double s = static_cast<double>(i) / MotionShape::steps, share = bend_share(s);
    const Pose straight = interpolate(T_map_begin, T_map_end, s);
    Pose bent = straight;
    bent.linear() = so3_exp(share * bend.head<3>()).toRotationMatrix() * straight.linear();
    bent.translation() += share * bend.tail<3>();
    shape->after[i] = straight.inverse() * bent;
  }
  return {T_map_begin, T_map_end, std::move(shape)};
}

// Constant motion of `span_s` about the middle of a frame. The velocity (turn rad/s, shift m/s) is in sensor axes.
inline FrameMotion motion_about(const Pose& T_map_mid, const Vector6d& velocity, double span_s) {
  return {T_map_mid * se3_exp(-0.5 * span_s * velocity), T_map_mid * se3_exp(0.5 * span_s * velocity), nullptr};
}

// Poses over a frame on a fine grid of s, so that a point costs two matrix products and no trigonometry. Points are
// blended between grid poses: with 32 steps and 10 deg of rotation in a frame this is exact to 0.01 mm at 20 m.
class PoseGrid {
 public:
  static constexpr int steps = 32;

  PoseGrid() = default;
  explicit PoseGrid(const FrameMotion& motion) : PoseGrid([&](double s) { return motion.at(s); }) {}
  template <class PoseAt>
  requires requires(PoseAt f) { Pose(f(0.0)); }
  explicit PoseGrid(const PoseAt& pose_at) {
    for (int i = 0; i <= steps; ++i) {
      const Pose T = pose_at(static_cast<double>(i) / steps);
      rotations_[static_cast<std::size_t>(i)] = T.linear();
      translations_[static_cast<std::size_t>(i)] = T.translation();
    }
  }

  // The point rotated into map axes but not shifted (the lever arm about the sensor), for s in [0, 1].
  Eigen::Vector3d turned(const Eigen::Vector3f& point, float s) const {
    const auto [i, f] = locate(s);
    const Eigen::Vector3d p = point.cast<double>();
    return (1 - f) * (rotations_[i] * p) + f * (rotations_[i + 1] * p);
  }
  Eigen::Vector3d translation(float s) const {
    const auto [i, f] = locate(s);
    return (1 - f) * translations_[i] + f * translations_[i + 1];
  }
  const Eigen::Matrix3d& rotation(float s) const { return rotations_[locate(s).first]; }
  Eigen::Vector3d in_map(const Eigen::Vector3f& point, float s) const { return turned(point, s) + translation(s); }

 private:
  static std::pair<std::size_t, double> locate(float s) {
    const double x = static_cast<double>(s) * steps;
    const int i = x < 0 ? 0 : (x >= steps ? steps - 1 : static_cast<int>(x));
    return {static_cast<std::size_t>(i), x - i};
  }
  std::array<Eigen::Matrix3d, steps + 1> rotations_;
  std::array<Eigen::Vector3d, steps + 1> translations_;
};

}  // namespace bole::slam
