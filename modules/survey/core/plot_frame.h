// From map axes to plot axes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "base/transform.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "survey/core/options.h"

namespace bole::survey {

struct PlotFrame {
  Pose T_plot_map = Pose::Identity();                    // "plot" are levelled map axes when `axes` is Axes::map
  Axes axes = Axes::map;                                 // plot when both targets were found
  Eigen::Vector3d new_origin = Eigen::Vector3d::Zero();  // for the moved cloud
  bool by_gravity = false;                               // z is up as the inertial unit told
  Table targets;                                         // name, x_m, y_m, z_m, points; fact axes
  Report report;
};

// Finds the vertical and the targets (SPEC A9) and from them the axes of the plot: z up, origin on the ground below the
// centre target, the north target at options.north_bearing_deg from it, clockwise from y. With one target: origin
// there, heading of the map. With none: levelled about the cloud's origin. Throws Error{bad_input} for a cloud without
// points.
PlotFrame find_plot_frame(const PointCloud& points_in_map, const Trajectory* trajectory_in_map,
                          const FrameOptions& options, const Run& run);

}  // namespace bole::survey
