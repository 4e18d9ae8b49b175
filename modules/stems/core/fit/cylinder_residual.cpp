#include <cmath>

#include "stems/core/fit/cylinder_fit.h"

namespace bole::stems {

CylinderResiduals::CylinderResiduals(const TaperedCylinder& cylinder) : c_(cylinder) {
  const Eigen::Vector3d along(c_.slope_x, c_.slope_y, 1);
  const double norm = along.norm();
  axis_ = along / norm;
  axis_by_x_ = (Eigen::Vector3d::UnitX() - axis_.x() * axis_) / norm,
  axis_by_y_ = (Eigen::Vector3d::UnitY() - axis_.y() * axis_) / norm;
}

Eigen::Vector3d CylinderResiduals::from_axis(const BarkPoint& point) const {
  Eigen::Vector3d q = point.p - Eigen::Vector3d(c_.x, c_.y, 0);
  if (!c_.view_offset.empty()) q.head<2>() -= c_.view_offset[static_cast<std::size_t>(point.view)];
  return q;
}

PointResidual CylinderResiduals::surface(const BarkPoint& point, bool derivatives) const {
  PointResidual out;
  const Eigen::Vector3d q = from_axis(point);
  const double s = q.dot(axis_);  // along the axis
  const Eigen::Vector3d across = q - s * axis_;
  const double distance = across.norm();
  if (distance < 1e-6) return out;
  out.value = distance - (c_.radius + c_.taper * s), out.usable = true;
  if (!derivatives) return out;
  const Eigen::Vector3d outward = across / distance;
  for (int k = 0; k < 2; ++k) {
    out.jacobian[k] = -outward[k] + c_.taper * axis_[k];
    const auto& da = k == 0 ? axis_by_x_ : axis_by_y_;
    out.jacobian[2 + k] = -s * outward.dot(da) - c_.taper * q.dot(da);
  }
  out.jacobian[4] = -1, out.jacobian[5] = -s;
  return out;
}

PointResidual CylinderResiduals::along_ray(const BarkPoint& point, double ray_gate, bool derivatives) const {
  PointResidual out;
  const Eigen::Vector3d q = from_axis(point);
  const Eigen::Vector3d& d = point.ray;
  const double s = q.dot(axis_);  // along the axis
  // In the plane across the axis: `along` runs with the projected ray, `impact2` is the squared distance of its line
  // from the axis.
  const double cos_axis = d.dot(axis_), m2 = 1 - cos_axis * cos_axis;
  if (m2 < 0.1) return out;  // nearly parallel to the stem, or no ray
  const double by_m = 1 / std::sqrt(m2), A = q.dot(d) - s * cos_axis, along = A * by_m;
  const double impact2 = std::max(0.0, q.squaredNorm() - s * s - along * along);
  const double radius = c_.radius + c_.taper * s;
  if (radius <= 0 || impact2 >= ray_gate * ray_gate * radius * radius) return out;
  const double by_r = 1 / radius, share2 = impact2 * by_r * by_r, width = point.beam_sd * by_r;
  if (share2 >= 1 && width <= 0) return out;  // a ray that would miss
  const LitDepth lit = lit_depth_(share2, width, point.scattered);
  const double across = along + radius * lit.depth;
  out.value = across * by_m - c_.range_offset, out.impact = std::sqrt(share2), out.usable = true;
  if (!derivatives) return out;

  out.by_beam = lit.by_width * by_m;
  const double by_radius = lit.depth - 2 * share2 * lit.by_impact2 - width * lit.by_width,
               by_impact2 = lit.by_impact2 * by_r;
  const auto derivative = [&](double d_q2, double ds, double dA, double d_cos, double d_radius) {
    const double dm_by_m = -cos_axis * d_cos * by_m * by_m;
    const double d_along = dA * by_m - along * dm_by_m;
    const double d_impact2 = d_q2 - 2 * s * ds - 2 * along * d_along;
    return (d_along + by_radius * d_radius + by_impact2 * d_impact2 - across * dm_by_m) * by_m;
  };
  for (int k = 0; k < 2; ++k) {
    const double ds = -axis_[k];
    out.jacobian[k] = derivative(-2 * q[k], ds, -d[k] - ds * cos_axis, 0, c_.taper * ds);
    const auto& da = k == 0 ? axis_by_x_ : axis_by_y_;
    const double ds_a = q.dot(da), dc = d.dot(da);
    out.jacobian[2 + k] = derivative(0, ds_a, -ds_a * cos_axis - s * dc, dc, c_.taper * ds_a);
  }
  out.jacobian[4] = by_radius * by_m, out.jacobian[5] = s * out.jacobian[4];
  out.jacobian[6] = -1;
  return out;
}

CylinderResiduals::RayPlace CylinderResiduals::place_of_ray(const BarkPoint& point) const {
  const Eigen::Vector3d q = from_axis(point);
  const Eigen::Vector3d across = q - q.dot(axis_) * axis_, d = point.ray - point.ray.dot(axis_) * axis_;
  const double length = d.norm();
  if (length < 0.3) return {};
  const double along = across.dot(d) / length;
  return {std::sqrt(std::max(0.0, across.squaredNorm() - along * along)), along, true};
}

PointResidual surface_residual(const TaperedCylinder& c, const BarkPoint& point, bool derivatives) {
  return CylinderResiduals(c).surface(point, derivatives);
}

PointResidual ray_residual(const TaperedCylinder& c, const BarkPoint& point, double ray_gate, bool derivatives) {
  return CylinderResiduals(c).along_ray(point, ray_gate, derivatives);
}

}  // namespace bole::stems
