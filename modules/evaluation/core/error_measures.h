// Measures of position and diameter errors: one definition each, for one survey and for several together.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace bole::evaluation {

// Of errors e = estimate - reference in metres (paper A, equations 25 to 27; the sum of (26) is divided by n). NaN
// without any.
struct PositionMeasures {
  std::size_t n = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();        // mu
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // Sigma; its element (0, 1) is what table 2 calls rho_xy
  Eigen::Vector2d sigma = Eigen::Vector2d::Zero();       // square roots of its diagonal
  double max_sigma = 0;                                  // square root of its largest eigenvalue
  double correlation = 0;                                // of both errors; NaN where one of them is constant
  Eigen::Vector2d rmse = Eigen::Vector2d::Zero();
};
PositionMeasures position_measures(const std::vector<Eigen::Vector2d>& errors);

struct DiameterPair {
  double estimate_cm = 0, reference_cm = 0;
  double lo_cm = 0, hi_cm = 0;  // interval of the estimate; NaN where there is none
};

// BIAS and RMSE of estimate - reference. relBIAS and relRMSE are the mean and the root mean square of the relative
// errors (estimate - reference) / reference. The paper prints no formula; its table 3 excludes the other usual one, in
// which BIAS is divided by the mean diameter: -0.59 % with a BIAS of -0.08 cm and a mean of 18.25 cm (plot 4). Pairs
// without both diameters, and with a reference that is not above zero, take no part. NaN without any.
struct DiameterMeasures {
  std::size_t n = 0;
  double bias_cm = 0, relative_bias_pct = 0, rmse_cm = 0, relative_rmse_pct = 0;
  std::size_t with_interval = 0;
  double coverage_pct = 0;  // of the intervals, those that hold the reference
};
DiameterMeasures diameter_measures(const std::vector<DiameterPair>& pairs);

double share_percent(double part, double whole);  // NaN of nothing

}  // namespace bole::evaluation
