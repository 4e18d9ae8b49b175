// Least-squares planes through a few points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

namespace bole::ground {

struct NeighbourPlane {
  bool valid = false;        // at least four neighbours
  double residual = 0;       // of the point above the plane through its neighbours, metres (vertical)
  double mean_distance = 0;  // horizontal, to the neighbours
};

// Plane through the neighbours of `at` (weights 1 / distance), evaluated at its x, y.
NeighbourPlane plane_through_neighbours(std::span<const Eigen::Vector3d> points,
                                        std::span<const std::uint32_t> neighbours, const Eigen::Vector3d& at);

// z = a + b (x - x0) + c (y - y0) by weighted normal equations; slopes are drawn gently to zero where the points do not
// tell.
class PlaneFit {
 public:
  PlaneFit() = default;
  void add(double dx, double dy, double z, double weight) {
    const Eigen::Vector3d row(1, dx, dy);
    normal_.noalias() += weight * row * row.transpose();
    right_ += weight * z * row;
  }
  // (a, b, c); `prior_weight_m2` is added to the sums of weighted dx^2 and dy^2.
  Eigen::Vector3d solve(double prior_weight_m2) const;
  double weight() const { return normal_(0, 0); }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

}  // namespace bole::ground
