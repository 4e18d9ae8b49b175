// Where the sensor of a frame stands and where it looks, from marks of known position (SPEC B1).
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "cloud/table.h"

namespace bole::rows {

// vectors: all coordinates of the marks as they are seen; ranges: equation (3) of the paper.
enum class ResectMethod { vectors, ranges };
constexpr std::array<std::string_view, 2> choice_names(ResectMethod) { return {"vectors", "ranges"}; }

struct ResectOptions {
  ResectMethod method = ResectMethod::vectors;
  double roll_deg = 0;
  double pitch_deg = 0;
  double mark_sigma = 0.01;
  double mark_height_sigma = 0.02;
  double range_sigma = 0.01;
  double direction_sigma_deg = 0.05;
  double tilt_sigma_deg = 0.1;
  double max_sigma = 0.1;
  double max_heading_sigma_deg = 1;
};
const OptionTable& option_table(const ResectOptions*);

struct SensorPose {
  // One row: x_m, y_m, z_m of the sensor, yaw_deg (east to the x axis of the levelled frame, towards north),
  // bearing_deg (of the y axis, clockwise from grid north), their standard errors *_se_m and *_se_deg, the covariance
  // cov_* of x, y, z (m) and yaw (rad), sigma0 and redundancy. Facts axes and crs are those of the marks.
  Table pose;
  Table residuals;  // a row per mark: name, known - adjusted dx_m, dy_m, dz_m, range_m, range_residual_m
  Report report;
};

// `marks`: name, x_m, y_m, z_m (or height_m) as known; seen_x_m, seen_y_m, seen_z_m in the axes of the frame; range_m
// where it was measured apart. Throws Error{bad_input} with the reason: too few marks, marks that are not those that
// were seen (their distances differ), swapped axes, marks that carry no heading, ranges that meet nowhere, standard
// errors above the limits.
SensorPose sensor_pose(const Table& marks, const ResectOptions& options);

}  // namespace bole::rows
