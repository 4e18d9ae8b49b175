// Robust means of small samples.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace bole {
inline namespace cloud {

struct RobustMean {
  Eigen::VectorXd mean;
  double sigma = 0;            // scatter of the inliers per axis
  double standard_error = 0;   // of the mean, per axis
  double effective_count = 0;  // sum of weights
};

// Location by Tukey's biweight (c = 4.685) from the component-wise median, scale by the median absolute deviation of
// the distances but not below `min_sigma`. `weights` may be empty (all one). At least one sample.
RobustMean robust_mean(const std::vector<Eigen::VectorXd>& samples, const std::vector<double>& weights,
                       double min_sigma);

}  // namespace cloud
}  // namespace bole
