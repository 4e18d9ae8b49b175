// Circles through points in the plane.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace bole::stems {

struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0;
};

// The algebraic "Hyper" fit, which has no essential bias (Al-Sharadqah and Chernov 2009, Electronic Journal of
// Statistics 3, section 8). `weights` may be empty. Nothing when there are fewer than three points or they lie on a
// line.
std::optional<Circle> hyper_circle(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights = {});

struct RobustCircle {
  Circle circle;
  double sigma = 0;    // robust scale of the radial residuals, metres, capped
  double arc_rad = 0;  // part of the circle that inliers cover
  int inliers = 0;
};

// Geometric least squares by Gauss-Newton with Tukey weights from a start that is right to `start_error_m`; the scale
// (1.4826 MAD) is capped at `max_sigma`. Nothing when the points do not hold a circle.
std::optional<RobustCircle> robust_circle(const std::vector<Eigen::Vector2d>& points, const Circle& start,
                                          double start_error_m, double max_sigma);

// Whether a point lies within the scatter of the circle.
bool is_on(const Eigen::Vector2d& point, const RobustCircle& fit);

// The part of the circle, in radians, whose 10 degree sectors hold a point; `angles_rad` are directions from the
// centre.
double covered_arc_rad(const std::vector<double>& angles_rad);

// The longest run of such sectors, where one empty sector does not end a run.
double unbroken_arc_rad(const std::vector<double>& angles_rad);

// Tukey's biweight for a residual in units of its scale (constant 4.685: 95 % efficiency for normal residuals).
double tukey_weight(double scaled_residual);

// As upper_median() (base/statistics.h); quick where the middle is near `guess`, which changes nothing else.
double upper_median_near(std::span<double> values, double guess);

}  // namespace bole::stems
