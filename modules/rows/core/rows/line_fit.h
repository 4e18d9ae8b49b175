// The line of a row.
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "rows/core/rows/plant_grid.h"

namespace bole::rows {

struct LineFit {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // a point on the line: the mean of the plants
  double angle_rad = 0;                              // of the line with due east, in (-pi/2, pi/2]; NaN for one plant
  double angle_se_rad = 0;                           // standard error; NaN below three plants
  double rms_m = 0;                                  // of the distances from the line

  Eigen::Vector2d direction() const { return {std::cos(angle_rad), std::sin(angle_rad)}; }
};

// Total least squares: the squared distances across the line are least. Standard error from the residuals with n - 2
// degrees of freedom: sigma / sqrt(sum of squared distances along the line).
LineFit fit_orthogonal(const Points2& points);

// Ordinary least squares of y = a x + b (SPEC B6, eqs. 8 to 10), or of x = a y + b where the row runs more north than
// east, so that every direction has a solution.
LineFit fit_least_squares(const Points2& points);

// An angle modulo pi, in (-pi/2, pi/2].
double row_angle(double angle_rad);

// |a - b| of two row angles, in [0, pi/2].
double row_angle_difference(double a_rad, double b_rad);

}  // namespace bole::rows
