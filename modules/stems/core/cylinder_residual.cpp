#include <cmath>

#include "stems/core/beam_depth.h"
#include "stems/core/cylinder_fit.h"

namespace bole {
namespace {

// What both residuals share: the point seen from the axis point of its view, and the axis.
struct Seen {
  Eigen::Vector3d q;  // from the axis point to the measured point
  Eigen::Vector3d a;  // axis direction
  double norm;        // of (slope_x, slope_y, 1)
  double s;           // along the axis
  // Derivative of the axis direction by slope k (0 or 1).
  Eigen::Vector3d axis_derivative(int k) const { return (Eigen::Vector3d::Unit(k) - a[k] * a) / norm; }
};

Seen look(const TaperedCylinder& c, const BarkPoint& point) {
  Seen seen;
  const Eigen::Vector3d axis(c.slope_x, c.slope_y, 1);
  seen.norm = axis.norm(), seen.a = axis / seen.norm;
  seen.q = point.p - Eigen::Vector3d(c.x, c.y, 0);
  if (!c.view_offset.empty()) seen.q.head<2>() -= c.view_offset[static_cast<std::size_t>(point.view)];
  seen.s = seen.q.dot(seen.a);
  return seen;
}

}  // namespace

PointResidual surface_residual(const TaperedCylinder& c, const BarkPoint& point, bool derivatives) {
  PointResidual out;
  const auto seen = look(c, point);
  const Eigen::Vector3d across = seen.q - seen.s * seen.a;
  const double distance = across.norm();
  if (distance < 1e-6) return out;
  const Eigen::Vector3d outward = across / distance;
  out.value = distance - (c.radius + c.taper * seen.s), out.usable = true;
  if (!derivatives) return out;
  for (int k = 0; k < 2; ++k) {
    out.jacobian[k] = -outward[k] + c.taper * seen.a[k];
    const Eigen::Vector3d da = seen.axis_derivative(k);
    out.jacobian[2 + k] = -seen.s * outward.dot(da) - c.taper * seen.q.dot(da);
  }
  out.jacobian[4] = -1, out.jacobian[5] = -seen.s;
  return out;
}

PointResidual ray_residual(const TaperedCylinder& c, const BarkPoint& point, double ray_gate, bool derivatives) {
  PointResidual out;
  const auto seen = look(c, point);
  const Eigen::Vector3d& d = point.ray;
  // In the plane across the axis: `along` runs with the projected ray, `impact2` is the squared distance of its line
  // from the axis.
  const double cos_axis = d.dot(seen.a), m2 = 1 - cos_axis * cos_axis;
  if (m2 < 0.1) return out;  // nearly parallel to the stem, or no ray
  const double m = std::sqrt(m2), qd = seen.q.dot(d), A = qd - seen.s * cos_axis, along = A / m;
  const double impact2 = std::max(0.0, seen.q.squaredNorm() - seen.s * seen.s - along * along);
  const double radius = c.radius + c.taper * seen.s;
  if (radius <= 0 || impact2 >= ray_gate * ray_gate * radius * radius) return out;
  const double q = impact2 / (radius * radius), width = point.beam_sd / radius;
  if (q >= 1 && width <= 0) return out;  // a ray that would miss
  const LitDepth lit = lit_depth(q, width);
  const double across = along + radius * lit.depth;
  out.value = across / m - c.range_offset, out.impact = std::sqrt(q), out.usable = true;
  if (!derivatives) return out;

  const double by_radius = lit.depth - 2 * q * lit.by_impact2 - width * lit.by_width,
               by_impact2 = lit.by_impact2 / radius;
  const auto derivative = [&](double d_q2, double ds, double dA, double d_cos, double d_radius) {
    const double dm = -cos_axis * d_cos / m;
    const double d_along = dA / m - A * dm / m2;
    const double d_impact2 = d_q2 - 2 * seen.s * ds - 2 * along * d_along;
    return (d_along + by_radius * d_radius + by_impact2 * d_impact2) / m - across * dm / m2;
  };
  for (int k = 0; k < 2; ++k) {
    const double ds = -seen.a[k];
    out.jacobian[k] = derivative(-2 * seen.q[k], ds, -d[k] - ds * cos_axis, 0, c.taper * ds);
    const Eigen::Vector3d da = seen.axis_derivative(k);
    const double ds_a = seen.q.dot(da), dc = d.dot(da);
    out.jacobian[2 + k] = derivative(0, ds_a, -ds_a * cos_axis - seen.s * dc, dc, c.taper * ds_a);
  }
  out.jacobian[4] = derivative(0, 0, 0, 0, 1), out.jacobian[5] = derivative(0, 0, 0, 0, seen.s);
  out.jacobian[6] = -1;
  return out;
}

}  // namespace bole
