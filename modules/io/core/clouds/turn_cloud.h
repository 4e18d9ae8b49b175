// Clouds turned and scaled after they were read, with the sensor positions of their points.
#pragma once

#include <Eigen/Core>

#include "cloud/point_cloud.h"

namespace bole::io {

// About the zero of the coordinates: the origin moves with the points.
void turn_cloud(PointCloud& cloud, const Eigen::Matrix3d& matrix);

// About a place, given as an offset from the origin, which stays.
void turn_cloud_about(PointCloud& cloud, const Eigen::Matrix3d& matrix, const Eigen::Vector3d& place);

}  // namespace bole::io
