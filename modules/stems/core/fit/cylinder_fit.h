// Joint robust fit of a tapered cylinder to bark points, in axes aligned with the stem: origin on the axis at breast
// height, z along it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>
#include <vector>

#include "stems/core/fit/beam_depth.h"

namespace bole::stems {

struct BarkPoint {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();    // stem axes, metres
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();  // unit direction from sensor to point; zero when not known
  int pass = 0;                                   // from 0, consecutive
  int view = 0;                                   // from 0, consecutive: part of a pass (number_views)
  int section = 0;
  std::int32_t cloud_pass = 0;  // of the cloud; 0 when not known
  double time = 0;              // likewise
  float range = 0;              // from the sensor, metres; 0 when not known
  float beam_sd = 0;     // of where the light met the stem, across the ray, metres: width of the beam and blur of the
                         // map; 0: a thin ray
  float beam_doubt = 0;  // standard deviation of beam_sd, metres: all points err alike
  float scattered = 0;   // share of beam_sd squared that is blur
};

// A view is what one pass sees from one direction: errors of the poses change with both. Numbers the points by pass
// and, with `by_bearing`, by sectors of the bearing of the ray; returns the pass of each view.
std::vector<int> number_views(std::vector<BarkPoint>& points, bool by_bearing);

// Parameters: axis point (x, y) at z = 0, axis slopes, radius at z = 0 along the axis, radius per metre of stem; an
// offset (x, y) per view: views see the stem displaced by it; what all rays measure too far, metres.
struct TaperedCylinder {
  double x = 0, y = 0, slope_x = 0, slope_y = 0, radius = 0, taper = 0;
  std::vector<Eigen::Vector2d> view_offset;
  double range_offset = 0;

  Eigen::Vector3d direction() const { return Eigen::Vector3d(slope_x, slope_y, 1).normalized(); }
};

// Standard deviations per axis of how far a pass is displaced, and a view from the mean of its pass, metres.
struct DriftPrior {
  double pass_sd_m = 0.01, view_sd_m = 0.003;
};

// Normal prior of the range offset.
struct RangeOffsetPrior {
  double mean_m = 0, sd_m = 0.010;
};

// Normal prior of the range stretch (RangeStretchEvidence).
struct RangeStretchPrior {
  double mean = 0, sd = 0;
};

struct CylinderFitOptions {
  bool along_rays = false;   // residual: measured less predicted range along the ray, else distance from the surface
  double ray_gate = 0.9;     // rays with an impact parameter beyond this share of the radius are left out
  double max_sigma = 0.025;  // cap of the robust scale
  DriftPrior drift;
  RangeOffsetPrior range_offset;                 // along rays
  double taper_mean = -0.005, taper_sd = 0.010;  // prior, metres of radius per metre
  double still_m = 5e-6, still_scale = 1e-3;  // what a step moves the fit by at its end: parameters, share of the scale
  std::stop_token cancel;                     // once asked for there is no fit
};

// The data on the view offsets with all other parameters free: log likelihood = target . d - d . information d / 2 for
// offsets d (x, y by view).
struct DriftEvidence {
  Eigen::MatrixXd information;
  Eigen::VectorXd target;
  std::vector<int> pass_of_view;
};

// Log of the marginal likelihood of a prior, up to a constant.
double drift_log_likelihood(const DriftEvidence& evidence, const DriftPrior& prior);

// By pass, the mean offset of its views that is likeliest under a prior, in stem axes, metres.
std::vector<Eigen::Vector2d> likeliest_offsets(const DriftEvidence& evidence, const DriftPrior& prior);

// What the points alone say about the range offset.
struct RangeOffsetEvidence {
  double value_m = 0, sd_m = 0;  // sd 0: nothing
  double beam_doubt_m = 0;       // standard deviation of the value because the width of the beam is not known
};

// What the points alone say about the range stretch: by how much the cloud lays them too far from where the sensor
// seemed to be, as a share of their range. A walk that SLAM makes too short does that: a stem seen from near and from
// far then lies at two places.
struct RangeStretchEvidence {
  double value = 0, sd = 0;  // sd 0: nothing
  double doubt = 0;          // likewise of what all stems have in common: the width of the beam, the range offset
};

struct CylinderFit {
  TaperedCylinder cylinder;
  double sigma_m = 0;        // robust scale of the residuals, capped
  double noise_m = 0;        // the same as found
  double radius_sd_m = 0;    // standard deviation of the radius, correlated residuals allowed for
  double beam_doubt_m = 0;   // standard deviation of the radius because the width of the beam is not known
  double position_sd_m = 0;  // of the axis point, larger axis
  int blocks = 0;            // groups of residuals that count as independent
  int inliers = 0;
  bool along_rays = false;
  std::vector<double> weight;                // Tukey weight of each point, 0: outlier or gated
  std::vector<Eigen::Vector2d> pass_offset;  // mean of the views of each pass; empty with one view
  DriftEvidence drift;                       // empty with one view
  RangeOffsetEvidence range_offset;
  RangeStretchEvidence range_stretch;
  double radius_by_stretch_m = 0;  // of the radius, by the stretch that is taken out of the points
};

// Residual of one point and its derivatives by (x, y, slope_x, slope_y, radius, taper, range_offset); derivatives by
// the view offset are those by (x, y). Along rays, metres along the ray, positive when measured too far, where a wide
// beam is expected to measure the mean depth of the bark that it lights (beam_depth.h); else distance from the surface,
// positive outside.
struct PointResidual {
  double value = 0;
  Eigen::Matrix<double, 7, 1> jacobian = Eigen::Matrix<double, 7, 1>::Zero();
  double impact = 0;   // distance of the ray from the axis, in radii; 0 for the surface
  double by_beam = 0;  // derivative by the point's beam_sd
  bool usable = false;
};
PointResidual surface_residual(const TaperedCylinder& cylinder, const BarkPoint& point, bool derivatives = true);
PointResidual ray_residual(const TaperedCylinder& cylinder, const BarkPoint& point, double ray_gate,
                           bool derivatives = true);

// The same for many points of one cylinder: what they share is found once.
class CylinderResiduals {
 public:
  explicit CylinderResiduals(const TaperedCylinder& cylinder);
  PointResidual surface(const BarkPoint& point, bool derivatives = true) const;
  PointResidual along_ray(const BarkPoint& point, double ray_gate, bool derivatives = true) const;

  // Of the ray of a point, in the plane across the axis, metres: the distance of its line from the axis, and how far
  // beyond the foot of the axis on it the point lies.
  struct RayPlace {
    double impact = 0, along = 0;
    bool known = false;  // not without a ray, or nearly parallel to the stem
  };
  RayPlace place_of_ray(const BarkPoint& point) const;

 private:
  Eigen::Vector3d from_axis(const BarkPoint& point) const;  // from the axis point of its view

  const TaperedCylinder& c_;
  BeamDepth lit_depth_;
  Eigen::Vector3d axis_;                   // unit direction
  Eigen::Vector3d axis_by_x_, axis_by_y_;  // its derivatives by the slopes
};

// Levenberg-Marquardt with Tukey weights from `start` (offsets are set to zero unless there is one per view). Nothing
// when too few points or no convergence.
std::optional<CylinderFit> fit_tapered_cylinder(const std::vector<BarkPoint>& points, TaperedCylinder start,
                                                double start_error_m, const CylinderFitOptions& options);

}  // namespace bole::stems
