// ICP and NDT of PCL behind a narrow door: its headers are seen in one file only.
#pragma once

#include <vector>

#include "base/transform.h"

namespace bole::slam {

// Moves T_target_source so that `source` lies on `target` (metres). Both return the guess unchanged where they find
// nothing; `converged` says which.
struct PointRegistration {
  Pose T_target_source = Pose::Identity();
  bool converged = false;
};

// Normal distributions transform (Biber and Strasser 2003, Magnusson 2009): cells of `cell_m` with at least 5 points.
PointRegistration register_by_ndt(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double cell_m);
// Iterated closest points (Besl and McKay 1992), each step by singular values; pairs farther apart than `reach_m` do
// not count.
PointRegistration register_by_icp(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double reach_m);

}  // namespace bole::slam
