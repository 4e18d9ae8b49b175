// ICP and NDT of PCL. Only one file includes its headers.
#pragma once

#include <vector>

#include "base/transform.h"

namespace bole::slam {

// The pose that puts `source` on `target`. Both functions return the guess unchanged where they find none; `converged`
// says which.
struct PointRegistration {
  Pose T_target_source = Pose::Identity();
  bool converged = false;
  double rms = 0;  // of the distances from the points of `source` to the closest points of `target`, where converged
};

// Normal distributions transform (Biber and Strasser 2003, Magnusson 2009) on cells of `cell_size` with at least 5
// points.
PointRegistration register_by_ndt(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double cell_size);
// Iterative closest points (Besl and McKay 1992), each step by singular values. Pairs farther apart than `reach` do not
// count.
PointRegistration register_by_icp(const std::vector<Eigen::Vector3f>& source,
                                  const std::vector<Eigen::Vector3f>& target, const Pose& guess, double reach);

}  // namespace bole::slam
