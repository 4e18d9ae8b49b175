// Rigid motion of clouds and trajectories.
#pragma once

#include "base/run.h"
#include "base/transform.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"

namespace bole::survey {

// The cloud in other axes: positions and the sensor_x, sensor_y, sensor_z columns are moved, all other columns are
// shared. The result's origin is `new_origin`. CRS and coordinate quantum are dropped, since they hold for the old axes
// only.
PointCloud move_cloud(const PointCloud& cloud, const Pose& T_new_old, const Eigen::Vector3d& new_origin, Axes axes,
                      const Run& run);

Trajectory move_trajectory(const Trajectory& trajectory, const Pose& T_new_old, Axes axes);

}  // namespace bole::survey
