// Where the sensor was when it saw each point: columns of the cloud, or a trajectory and the times of the points.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"
#include "stems/core/detect/ray_test.h"
#include "stems/core/detect/stem_layer.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

bool has_sensor_columns(const PointCloud& points);  // all three

// `trajectory` may be null.
bool knows_sensor(const PointCloud& points, const Trajectory* trajectory);

// What the fits read of the cloud. Keeps pointers to its columns. Throws Error{cancelled}.
CloudRays rays_of(const PointCloud& points, const Trajectory* trajectory, const StemLayer& layer, const Run& run);

// Null when no sensor positions are known. Keeps references to both.
SensorOf sensor_of_points(const PointCloud& points, const Trajectory* trajectory);

// Writes the columns sensor_x, sensor_y, sensor_z, NaN where the position is not known, so that they move with the
// points. Throws Error{cancelled}.
void add_sensor_columns(PointCloud& points, const SensorOf& sensor_of, const Run& run);

}  // namespace bole::stems
