// A walk that the map makes too short, or too long, against the ranges that were measured.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "cloud/trajectory.h"
#include "stems/core/fit/cylinder_fit.h"

namespace bole::stems {

// Of less the stems cannot be sure (cylinder_fit's model of the beam, the shape of stems).
inline constexpr double min_stretch_to_take_out = 2e-4, still_to_take_out = 5e-5;

// Mean over stems of bounded influence, drawn to zero by what good maps have. Values as shares of the range.
RangeStretchPrior mean_range_stretch(const std::vector<RangeStretchEvidence>& stems);

// How much too short the walk of a map is, as a share, and the place that stays where it is when it is made longer.
struct WalkStretch {
  double share = 0;
  Eigen::Vector2d still = Eigen::Vector2d::Zero();  // coordinates of the map
};

// The origin of the map where it lies among the stems (a target, or the start of the walk), else their middle.
Eigen::Vector2d still_place(const std::vector<Eigen::Vector2d>& stems);

// The cloud of a walk that is made longer in the plan: every point goes with the place it was seen from, and so do
// sensor_x and sensor_y. Ranges stay as they were measured. Without these columns the places come from `trajectory`,
// which may be null, and the times of the points; points without a sensor stay. The fact walk_lengthened adds up.
// Throws Error{cancelled}.
PointCloud lengthened(const PointCloud& points, const Trajectory* trajectory, const WalkStretch& walk, const Run& run);

// The cloud with every point moved in the plan towards its sensor by `stretch` of its distance in the plan: for maps
// whose poses are not known to be estimated, so that the ranges may be at fault and places are left alone. Needs the
// columns of the sensor; points without one stay. Throws Error{cancelled}.
PointCloud without_stretch(const PointCloud& points, double stretch, const Run& run);

// The terrain under a walk that is made longer: the ground was seen from near, and goes with it as a whole.
Raster lengthened(Raster dem, const WalkStretch& walk);

// Metric range_stretch; finding walk_too_short or walk_too_long for what was taken out of the points. `lengthened`:
// places were moved too.
void tell_range_stretch(double stretch, double taken_out, bool lengthened, Report& report);

}  // namespace bole::stems
