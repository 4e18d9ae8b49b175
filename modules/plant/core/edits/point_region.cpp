#include "plant/core/edits/point_region.h"

#include <Eigen/Geometry>
#include <cmath>

namespace bole::plant {
namespace {

class Outline {
 public:
  explicit Outline(const PointRegion& region) : eye_(region.eye) {
    const auto& corners = region.outline;
    for (const auto& c : corners) middle_ += c / static_cast<double>(corners.size());
    Eigen::Vector3d area = Eigen::Vector3d::Zero();  // Newell's normal: the mean plane of corners that are rounded
    for (std::size_t i = 0; i < corners.size(); ++i)
      area += (corners[i] - middle_).cross(corners[(i + 1) % corners.size()] - middle_);
    if (!(area.norm() > 1e-12)) return;
    normal_ = area.normalized();
    across_ = normal_.unitOrthogonal();
    up_ = normal_.cross(across_);
    if (eye_ && std::abs(normal_.dot(middle_ - *eye_)) < 1e-9) return;
    for (const auto& c : corners) {
      const auto p = on_plane(c);
      if (!p) return;
      corners_.push_back(*p);
      box_.extend(*p);
    }
    valid_ = true;
  }

  bool contains(const Eigen::Vector3d& point) const {
    if (!valid_ || !point.allFinite()) return false;
    const auto p = on_plane(point);
    if (!p || !box_.contains(*p)) return false;
    bool inside = false;
    for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
      const auto &a = corners_[i], &b = corners_[j];
      if ((a.y() > p->y()) != (b.y() > p->y()) && p->x() < a.x() + (p->y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        inside = !inside;
    }
    return inside;
  }

 private:
  // Where the line of sight to a place meets the plane; nothing behind the eye.
  std::optional<Eigen::Vector2d> on_plane(const Eigen::Vector3d& place) const {
    Eigen::Vector3d p = place - middle_;
    if (eye_) {
      const Eigen::Vector3d e = *eye_ - middle_, along = p - e;
      const double t = -normal_.dot(e) / normal_.dot(along);
      if (!(t > 0) || !std::isfinite(t)) return {};
      p = e + t * along;
    }
    return Eigen::Vector2d(across_.dot(p), up_.dot(p));
  }

  std::optional<Eigen::Vector3d> eye_;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero(), normal_ = Eigen::Vector3d::UnitZ(),
                  across_ = Eigen::Vector3d::UnitX(), up_ = Eigen::Vector3d::UnitY();
  std::vector<Eigen::Vector2d> corners_;
  Eigen::AlignedBox2d box_;
  bool valid_ = false;
};

template <class Contains>
std::vector<std::size_t> those(const PointCloud& cloud, const Contains& contains) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (contains(cloud.position(i))) indices.push_back(i);
  return indices;
}

}  // namespace

std::vector<std::size_t> points_in(const PointRegion& region, const PointCloud& cloud) {
  if (region.kind == PointRegion::Kind::ball)
    return those(cloud, [&](const Eigen::Vector3d& p) { return (p - region.at).norm() <= region.radius; });
  if (region.kind == PointRegion::Kind::box)
    return those(cloud, [&](const Eigen::Vector3d& p) {
      return (p.array() >= region.min.array()).all() && (p.array() <= region.max.array()).all();
    });
  const Outline outline(region);
  return those(cloud, [&](const Eigen::Vector3d& p) { return outline.contains(p); });
}

}  // namespace bole::plant
