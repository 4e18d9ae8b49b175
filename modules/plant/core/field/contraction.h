// Space made finite: the innermost box stays as it is, what lies outside is drawn in (Barron et al., mip-NeRF 360,
// 2022).
#pragma once

#include <Eigen/Core>

namespace bole::plant {

// Maps the cube of half edge `half` to [-1, 1] and all that is outside to [-2, 2].
struct Contraction {
  float half = 1;

  Eigen::Vector3f operator()(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / half;
    const float m = q.cwiseAbs().maxCoeff();
    return m > 1 ? Eigen::Vector3f(q * ((2 - 1 / m) / m)) : q;
  }
  Eigen::Matrix3f jacobian(const Eigen::Vector3f& p) const {
    const Eigen::Vector3f q = p / half;
    Eigen::Index axis = 0;
    const float m = q.cwiseAbs().maxCoeff(&axis);
    if (m <= 1) return Eigen::Matrix3f::Identity() / half;
    Eigen::Matrix3f j = Eigen::Matrix3f::Identity() * ((2 - 1 / m) / m);
    j.col(axis) += q * ((q(axis) > 0 ? 1.0F : -1.0F) * (2 / (m * m * m) - 2 / (m * m)));
    return j / half;
  }
};

}  // namespace bole::plant
