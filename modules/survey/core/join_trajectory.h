// Points that others mapped, and the path of the sensor: joined by time, so that every point has its ray.
#pragma once

#include <optional>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"

namespace bole::survey {

struct JoinOptions {
  std::optional<double> time_offset{};  // open: found by the clocks
  double max_gap = 1.0;
  double pass_radius = 8.0;
  double max_distance = 20.0;
};
const OptionTable& option_table(const JoinOptions*);

struct JoinedCloud {
  PointCloud points;      // with sensor_x, sensor_y, sensor_z, range and pass; NaN where there is no pose
  Trajectory trajectory;  // with the times and in the axes of the points
  Report report;
};

// Throws Error{bad_input} where the points have no times, where the clocks of the two do not go together for certain,
// and where the path does not run through the cloud.
JoinedCloud join_trajectory(const PointCloud& points, const Trajectory& trajectory, const JoinOptions& options,
                            const Run& run);

}  // namespace bole::survey
