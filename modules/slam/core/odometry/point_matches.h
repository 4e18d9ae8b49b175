// Single points of the last frame as references: the line through two and the plane through three, as LOAM and SPEC A7
// have them, equations (3), (4) and (6)-(13), with the covariance of every point.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "slam/core/odometry/registration.h"

namespace bole::slam {

// The distance of a point from a line or plane through reference points, and how it depends on them. With the unit
// vector u from the foot to the point: d(distance)/d(point) = u, d(distance)/d(reference k) = -shares[k] u. The shares
// are the barycentric coordinates of the foot, so they sum to 1. Metres.
struct PointDistance {
  double distance = 0;  // from a plane with the sign of its normal
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  std::array<double, 3> shares{};
};
// SPEC A7, d_L. `a` and `b` must differ.
PointDistance distance_from_line(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b);
// SPEC A7, d_S; the printed formula (4) is the inverse. The points must not lie on one line.
PointDistance distance_from_plane(const Eigen::Vector3d& x, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

// A Q A^T of a condition (SPEC A, equations 6 and 10): the variance of the model, of the references and of the point.
double condition_variance(const PointDistance& distance, double model_variance,
                          std::span<const Eigen::Matrix3d* const> of_references, const Eigen::Matrix3d& of_point);

// The features of a frame whose motion is known.
class PointMatches {
 public:
  // The covariance of each point is that of the sensor and, with `pose_covariance` (turn, shift; map axes), that of the
  // pose which placed it. The first frame is exact: zero.
  PointMatches(const FeatureSet& features, const FrameMotion& motion, const SensorPrior& sensor,
               const Matrix6d& pose_covariance);
  ~PointMatches();
  PointMatches(const PointMatches&) = delete;
  PointMatches& operator=(const PointMatches&) = delete;

  // The line through the nearest edge point and the nearest one of another scan line, or the plane through the nearest
  // plane point, the nearest one of its scan line and the nearest one of another: LOAM, section V-B. Kind::none where
  // these are missing, farther than 2 m, or do not span a line or plane. `of_point`: covariance of the point in map
  // axes, for the variance of the condition; null: the variance is `variance`.
  Target target(const Eigen::Vector3d& point_in_map, bool line, const Eigen::Matrix3d* of_point, double variance) const;

 private:
  struct Part;
  std::unique_ptr<Part> edges_, planes_;
};

}  // namespace bole::slam
