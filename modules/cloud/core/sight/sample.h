// A bounded sample of a cloud, and what its coordinates say.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {
namespace sight {

constexpr std::size_t max_sample = 3'000'000;

struct Sample {
  std::vector<Eigen::Vector3f> points;  // relative to the origin of the cloud
  double each = 1;                      // how many points of the cloud one of the sample stands for
};

// Every n-th point with finite coordinates.
Sample sample_of(const PointCloud& cloud);

float quantile(std::vector<float> values, double share);
std::vector<float> coordinates(const std::vector<Eigen::Vector3f>& points, int axis);

struct Range {
  float low = 0, high = 0;
  float width() const { return high - low; }
};

// Without `share_outside` of the values, half of them at each end.
Range range_of(std::vector<float> values, double share_outside);

// Share of the points that have the coordinates of another one.
double duplicated_share(const PointCloud& cloud);

}  // namespace sight
}  // namespace cloud
}  // namespace bole
