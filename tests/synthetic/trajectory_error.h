// How far estimated poses are from true ones.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "cloud/core/view_source.h"

namespace bole::synthetic {

struct PosePairs {
  std::vector<Pose> truth, found;
};

inline PosePairs pose_pairs(const Trajectory& found, const std::vector<Pose>& truth, const ViewSource& views) {
  PosePairs out;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (const auto T = pose_of_view(found, views.time_s(i))) {
      out.truth.push_back(truth[i]);
      out.found.push_back(*T);
    }
  return out;
}

inline double place_rms(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i].translation() - b[i].translation()).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// Root mean square distance after the best rigid motion (ATE), metres. `scale` gets that of the best similarity.
inline double ate(const PosePairs& pairs, double* scale = nullptr) {
  const auto n = static_cast<Eigen::Index>(pairs.truth.size());
  Eigen::Matrix3Xd a(3, n), b(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    a.col(i) = pairs.found[static_cast<std::size_t>(i)].translation();
    b.col(i) = pairs.truth[static_cast<std::size_t>(i)].translation();
  }
  if (scale != nullptr) *scale = std::cbrt(Eigen::umeyama(a, b, true).topLeftCorner<3, 3>().determinant());
  const Eigen::Matrix4d T = Eigen::umeyama(a, b, false);
  double sum = 0;
  for (Eigen::Index i = 0; i < n; ++i) sum += ((T * a.col(i).homogeneous()).head<3>() - b.col(i)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(n));
}

}  // namespace bole::synthetic
