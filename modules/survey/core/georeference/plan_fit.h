// Turn and shift between two sets of points in the plan, by least squares.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace bole::survey {

// The same point in local axes and on the plane of a coordinate reference system.
struct PlanPair {
  Eigen::Vector2d local = Eigen::Vector2d::Zero();   // metres
  Eigen::Vector2d global = Eigen::Vector2d::Zero();  // easting, northing
  double sd_m = 0.02;  // of each coordinate of the difference: control point and its place in the map together
};

// A turn that is known from elsewhere (a bearing).
struct KnownTurn {
  double turn_rad = 0;
  double sd_rad = 0;
};

struct PlanFit {
  double turn_rad = 0;  // counter-clockwise from local to global axes
  double scale = 1;     // as given
  Eigen::Vector2d centre_local = Eigen::Vector2d::Zero(), centre_global = Eigen::Vector2d::Zero();  // centres of weight
  // From the stated standard deviations: of the turn, and of each coordinate of the centre.
  double turn_se_rad = 0, shift_se_m = 0;
  std::vector<Eigen::Vector2d> residuals;  // given - adjusted, easting and northing, metres
  double chi2 = 0;                         // sum of squares of residuals over their standard deviations
  int redundancy = 0;
  // The scale that the points themselves ask for; NaN for less than two points apart.
  double free_scale = 0, free_scale_se = 0;

  Eigen::Vector2d to_global(const Eigen::Vector2d& local) const;
};

// Minimises sum |global - (shift + scale R local)|^2 / sd^2, with the known turn as an observation. The turn comes from
// the weighted cross and dot products about the centres of weight (closed form; with a known turn by Newton's method),
// for which the shift does not depend on it. Needs two different points, or one and a known turn: Error{bad_input}.
PlanFit fit_plan(const std::vector<PlanPair>& pairs, double scale = 1, const std::optional<KnownTurn>& known = {});

// The root mean square distance that is left when the points are mirrored before they are turned: smaller than that of
// fit_plan() where easting and northing are exchanged.
double mirrored_rms_m(const std::vector<PlanPair>& pairs);

}  // namespace bole::survey
