// The steps that prepare one LiDAR frame (SPEC B1 to B4). Axes: y ahead, z up, origin in the sensor.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

// p' = Rz(yaw) Ry(pitch) Rx(roll) p (eqs. 1 and 2). Columns are kept. With `attitude` (time_s, roll_deg, pitch_deg,
// yaw_deg; times increase) every point of a frame with the column time is turned by the attitude of its own moment,
// interpolated; the angles of the options are added. Throws Error{bad_input} when points have no time or a time more
// than half a second outside the attitudes.
PointCloud level(const PointCloud& frame, const LevelOptions& options, const Table* attitude = nullptr);

// Points inside the box (eq. 5).
PointCloud cut_region(const PointCloud& frame, const RegionOptions& options);

// One point per occupied voxel: the centroid of its points, in order of the voxels. Columns are dropped.
PointCloud voxel_centroids(const PointCloud& frame, const VoxelOptions& options);

// Ray ground filter: points of a narrow sector, by range, are ground while they rise less than the local slope from the
// last one, or lie within the general slope after a jump. Returns the points that are not ground.
PointCloud remove_ground(const PointCloud& frame, const RayGroundOptions& options, const Run& run);

// Points with at least min_neighbours others within the radius.
PointCloud radius_filter(const PointCloud& frame, const RadiusOptions& options, const Run& run);

}  // namespace bole::rows
