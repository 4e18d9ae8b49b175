#include "plant/core/leaves/leaf_node.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::plant {

LeafNodePlace leaf_node(const AxisCurve& axis, const Points3& middles, double contact, const NodeScales& scales) {
  LeafNodePlace out;
  out.along = std::clamp(contact, 0.0, axis.length());
  Points3 outside;
  for (const auto& p : middles) {
    const auto near = axis.nearest(p);
    const double radius = axis.radius_at(near.along);
    if (near.distance > (std::isfinite(radius) ? 1.3 * radius : 0)) outside.push_back(p);
  }
  if (outside.empty()) {
    out.direction = axis.tangent(out.along, scales.tangent);
    return out;
  }
  double best = std::numeric_limits<double>::infinity();
  const double from = std::max(0.0, contact - scales.reach), to = std::min(axis.length(), contact + scales.above);
  for (double along = from; along <= to + 1e-12; along += scales.step) {
    const Eigen::Vector3d start = axis.at(along);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& p : outside) sum += p - start;
    const Eigen::Vector3d direction = sum.normalized();
    double off = 0;
    for (const auto& p : outside) {
      const Eigen::Vector3d d = p - start;
      off += (d - d.dot(direction) * direction).squaredNorm();
    }
    // Among lines that fit alike, the one from nearest to the contact.
    off /= static_cast<double>(outside.size());
    off += 1e-4 * (along - contact) * (along - contact);
    if (off >= best) continue;
    best = off;
    out.along = along;
    out.direction = direction;
  }
  const Eigen::Vector3d up = axis.tangent(out.along, scales.tangent);
  out.angle = std::acos(std::clamp(out.direction.dot(up), -1.0, 1.0));
  out.good = outside.size() >= 3;
  return out;
}

}  // namespace bole::plant
