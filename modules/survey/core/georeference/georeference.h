// The place of a plot in a coordinate reference system, with its uncertainty.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "cloud/core/global_frame.h"
#include "cloud/table.h"
#include "geo/core/projected_crs.h"
#include "survey/core/georeference/control_points.h"
#include "survey/core/georeference/georeference_options.h"

namespace bole::survey {

// Standard errors of the frame, from which that of every place follows.
struct FrameUncertainty {
  Eigen::Vector2d centre_local = Eigen::Vector2d::Zero();  // where the shift is known best
  double centre_z_m = 0;
  double shift_se_m = 0;  // of each coordinate there
  double turn_se_rad = 0;
  double scale_doubt = 0;  // share of the distance by which an undecided scale may be off
  double tilt_se_rad = 0;  // about each axis; moves what is high or low sideways

  // Root mean square of the standard errors of easting and northing.
  double at(const Eigen::Vector3d& local) const;
};

struct Georeference {
  GlobalFrame frame;
  FrameUncertainty uncertainty;
  // One row per control point: name, x_m, y_m, z_m, easting_m, northing_m, height_m, residual_east_m,
  // residual_north_m, residual_height_m (given - adjusted), misfit_m, misfit_limit_m (distance from where the others
  // put it, and its limit), used, note. The frame is among its facts.
  Table control;
  Report report;
};

// What is known of the plot beside its control points.
struct LocalPlot {
  Axes axes = Axes::unknown;
  // Direction in local axes that a bearing was taken to, counter-clockwise from x; that of the north target.
  double bearing_target_rad = 0;
  std::vector<Eigen::Vector3d> stems;  // places whose uncertainty is told
};

// The direction from the centre to the north target; y where there are not both.
double bearing_target_rad(const Table* targets);

// Turn about the vertical and shift by weighted least squares, level and height from control heights. Throws
// Error{bad_input}, with the reason, where the points do not carry a place: too few, all at one place, mirrored,
// residuals beyond max_residual.
Georeference georeference(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs, const LocalPlot& plot,
                          const GeoreferenceOptions& options, Report report = {});

}  // namespace bole::survey
