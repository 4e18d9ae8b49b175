// Which points a person means: a ball, a box, the stroke of a brush, or what lies behind an outline that was drawn over
// a view. It is geometry and holds no point numbers, so that it says the same of a cloud that was thinned.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

// Metres in the axes of the points.
struct PointRegion {
  enum class Kind { ball, box, outline, brush };

  Kind kind = Kind::ball;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();                                  // ball
  double radius = 0;                                                             // ball, brush
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();  // box
  double turn_deg = 0;  // box: anti-clockwise about the vertical through its middle
  // Corners of a closed outline, roughly in one plane. Points belong to it that are seen within it from `eye`, at any
  // distance before the eye; without an eye, those that lie within it along the normal of the plane.
  std::vector<Eigen::Vector3d> outline;
  std::optional<Eigen::Vector3d> eye;
  // Outline: only points so far from its plane, least and most. Positive on the side from which its corners run
  // anti-clockwise.
  std::optional<Eigen::Vector2d> depth;
  std::vector<Eigen::Vector3d> path;          // brush: points within `radius` of it
  std::optional<Eigen::AlignedBox3d> within;  // any kind: only points in this box
};

// Looks at one point after another. An outline whose corners lie on one line holds no point.
class RegionTest {
 public:
  explicit RegionTest(const PointRegion& region);
  bool contains(const Eigen::Vector3d& point) const;  // false where a coordinate is not finite

  // Whether two sides of the outline cross or touch, seen along its normal or from its eye.
  bool crosses_itself() const;
  bool flat() const { return region_.kind == PointRegion::Kind::outline && !has_plane_; }  // corners on one line

 private:
  void find_plane();
  std::optional<Eigen::Vector2d> on_plane(const Eigen::Vector3d& place) const;
  bool in_outline(const Eigen::Vector3d& point) const;
  bool in_box(const Eigen::Vector3d& point) const;
  bool near_path(const Eigen::Vector3d& point) const;

  PointRegion region_;
  Eigen::AlignedBox3d around_;  // of what the region can hold; all of space for an outline
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero(), normal_ = Eigen::Vector3d::UnitZ(),
                  across_ = Eigen::Vector3d::UnitX(), up_ = Eigen::Vector3d::UnitY();
  double cos_turn_ = 1, sin_turn_ = 0;
  std::vector<Eigen::Vector2d> corners_;
  Eigen::AlignedBox2d corner_box_;
  bool has_plane_ = false;
};

// Indices of the points within, ascending.
std::vector<std::size_t> points_in(const PointRegion& region, const PointCloud& cloud);

}  // namespace cloud
}  // namespace bole
