#include "ground/core/local_plane.h"

#include <Eigen/Cholesky>

namespace bole::ground {

Eigen::Vector3d PlaneFit::solve(double prior_weight_m2) const {
  Eigen::Matrix3d normal = normal_;
  normal(1, 1) += prior_weight_m2, normal(2, 2) += prior_weight_m2;
  return normal.ldlt().solve(right_);
}

NeighbourPlane plane_through_neighbours(std::span<const Eigen::Vector3d> points,
                                        std::span<const std::uint32_t> neighbours, const Eigen::Vector3d& at) {
  NeighbourPlane out;
  if (neighbours.size() < 4) return out;
  PlaneFit fit;
  double spread = 0;
  for (const auto n : neighbours) {
    const Eigen::Vector3d d = points[n] - at;
    const double distance = d.head<2>().norm();
    out.mean_distance += distance;
    const double weight = 1.0 / (distance + 1e-3);
    spread += weight * distance * distance;
    fit.add(d.x(), d.y(), d.z(), weight);
  }
  out.mean_distance /= static_cast<double>(neighbours.size());
  out.residual = -fit.solve(1e-6 * spread)(0);
  out.valid = true;
  return out;
}

}  // namespace bole::ground
