// Trajectory and map carried by a correction that changes along the walk.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"
#include "slam/core/loops/corrections.h"

namespace bole::slam {

Trajectory corrected(const Trajectory& trajectory, const Corrections& corrections);

// Every point was measured at a time, so it moves with the pose of that time: the same as mapping the frames again, but
// for the thinning. Moves the positions and the columns sensor_x, sensor_y, sensor_z; the others are shared. Needs the
// column time. Throws Error{cancelled}.
PointCloud corrected(const PointCloud& points, const Corrections& corrections, const Run& run);

}  // namespace bole::slam
