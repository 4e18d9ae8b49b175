// A path in the axes of the cloud that it belongs to.
#pragma once

#include "base/report.h"
#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"

namespace bole::survey {

// Of a survey with a place on the earth the file of the cloud is in its coordinate system, that of the path in the axes
// of the plot. A path that lies far from the points is moved with the axes that the cloud says it was moved from, where
// that brings it to them; a note says so. Else it stays as it is.
Trajectory in_axes_of(const PointCloud& points, const Trajectory& path, Report& report);

}  // namespace bole::survey
