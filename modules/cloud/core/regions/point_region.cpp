#include "cloud/core/regions/point_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"

namespace bole {
inline namespace cloud {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Sides a-b and c-d have a point in common.
bool meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  if (!Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b)).intersects({c.cwiseMin(d), c.cwiseMax(d)})) return false;
  const auto apart = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q, const Eigen::Vector2d& r,
                        const Eigen::Vector2d& s) { return cross(q - p, r - p) * cross(q - p, s - p) > 0; };
  return !apart(a, b, c, d) && !apart(c, d, a, b);
}

double distance_to_side(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d side = b - a;
  const double t = std::clamp((p - a).dot(side) / std::max(side.squaredNorm(), 1e-18), 0.0, 1.0);
  return (p - a - t * side).norm();
}

}  // namespace

RegionTest::RegionTest(const PointRegion& region) : region_(region) {
  using Kind = PointRegion::Kind;
  const Eigen::Vector3d all = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()),
                        reach = Eigen::Vector3d::Constant(region.radius);
  if (region.kind == Kind::ball) region_.path = {region.at};
  for (const auto& p : region_.path) around_.extend(Eigen::AlignedBox3d(p - reach, p + reach));
  if (region.kind == Kind::box) {
    cos_turn_ = std::cos(radians(region.turn_deg));
    sin_turn_ = std::sin(radians(region.turn_deg));
    middle_ = (region.min + region.max) / 2;
    Eigen::Vector3d half = (region.max - region.min) / 2;
    if (region.turn_deg != 0) half.head<2>().setConstant(half.head<2>().norm());
    around_ = {middle_ - half, middle_ + half};
    if (region.turn_deg == 0) around_ = {region.min, region.max};  // not rounded
  }
  if (region.kind == Kind::outline) {
    around_ = {-all, all};
    find_plane();
  }
  if (region.within) around_ = around_.intersection(*region.within);
}

// The plane has Newell's normal: the mean one of corners that are rounded.
void RegionTest::find_plane() {
  const auto& corners = region_.outline;
  for (const auto& c : corners) middle_ += c / static_cast<double>(corners.size());
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += (corners[i] - middle_).cross(corners[(i + 1) % corners.size()] - middle_);
  if (!(area.norm() > 1e-12)) return;
  normal_ = area.normalized();
  across_ = normal_.unitOrthogonal();
  up_ = normal_.cross(across_);
  if (region_.eye && std::abs(normal_.dot(middle_ - *region_.eye)) < 1e-9) return;
  for (const auto& c : corners) {
    const auto p = on_plane(c);
    if (!p) return;
    corners_.push_back(*p);
    corner_box_.extend(*p);
  }
  has_plane_ = true;
}

// Where the line of sight to a place meets the plane; nothing behind the eye.
std::optional<Eigen::Vector2d> RegionTest::on_plane(const Eigen::Vector3d& place) const {
  Eigen::Vector3d p = place - middle_;
  if (region_.eye) {
    const Eigen::Vector3d e = *region_.eye - middle_, along = p - e;
    const double t = -normal_.dot(e) / normal_.dot(along);
    if (!(t > 0) || !std::isfinite(t)) return {};
    p = e + t * along;
  }
  return Eigen::Vector2d(across_.dot(p), up_.dot(p));
}

bool RegionTest::in_outline(const Eigen::Vector3d& point) const {
  if (!has_plane_) return false;
  if (region_.depth) {
    const double depth_m = normal_.dot(point - middle_);
    if (depth_m < region_.depth->x() || depth_m > region_.depth->y()) return false;
  }
  const auto p = on_plane(point);
  if (!p || !corner_box_.contains(*p)) return false;
  bool inside = false;
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const auto &a = corners_[i], &b = corners_[j];
    if ((a.y() > p->y()) != (b.y() > p->y()) && p->x() < a.x() + (p->y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

bool RegionTest::in_box(const Eigen::Vector3d& point) const {
  if (region_.turn_deg == 0) return true;  // is in `around_`
  const Eigen::Vector3d d = point - middle_, half = (region_.max - region_.min) / 2;
  return std::abs(cos_turn_ * d.x() + sin_turn_ * d.y()) <= half.x() &&
         std::abs(cos_turn_ * d.y() - sin_turn_ * d.x()) <= half.y();
}

bool RegionTest::near_path(const Eigen::Vector3d& point) const {
  const auto& path = region_.path;
  if (path.size() == 1) return (point - path[0]).norm() <= region_.radius;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (distance_to_side(point, path[i - 1], path[i]) <= region_.radius) return true;
  return false;
}

bool RegionTest::contains(const Eigen::Vector3d& point) const {
  if (!point.allFinite() || !around_.contains(point)) return false;
  if (region_.kind == PointRegion::Kind::outline) return in_outline(point);
  return region_.kind == PointRegion::Kind::box ? in_box(point) : near_path(point);
}

bool RegionTest::crosses_itself() const {
  const auto n = corners_.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j + 1 == n) continue;  // neighbours
      if (meet(corners_[i], corners_[i + 1], corners_[j], corners_[(j + 1) % n])) return true;
    }
  return false;
}

std::vector<std::size_t> points_in(const PointRegion& region, const PointCloud& cloud) {
  const RegionTest test(region);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (test.contains(cloud.position(i))) indices.push_back(i);
  return indices;
}

}  // namespace cloud
}  // namespace bole
