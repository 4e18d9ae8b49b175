#include "cloud/core/sight/sample.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace bole {
inline namespace cloud {
namespace sight {

Sample sample_of(const PointCloud& cloud) {
  const std::size_t stride = (cloud.size() + max_sample - 1) / max_sample;
  Sample out;
  out.each = static_cast<double>(stride);
  out.points.reserve(cloud.size() / stride + 1);
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    if (cloud.positions()[i].allFinite()) out.points.push_back(cloud.positions()[i]);
  return out;
}

float quantile(std::vector<float> values, double share) {
  const auto rank = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, rank);
  return *rank;
}

std::vector<float> coordinates(const std::vector<Eigen::Vector3f>& points, int axis) {
  std::vector<float> out;
  out.reserve(points.size());
  for (const auto& p : points) out.push_back(p[axis]);
  return out;
}

Range range_of(std::vector<float> values, double share_outside) {
  return {quantile(values, 0.5 * share_outside), quantile(std::move(values), 1 - 0.5 * share_outside)};
}

namespace {

std::uint64_t mixed(const Eigen::Vector3f& p) {
  std::uint64_t h = 0x9E3779B97F4A7C15ULL;
  for (int axis = 0; axis < 3; ++axis) {
    h ^= std::bit_cast<std::uint32_t>(p[axis] + 0.0F);  // -0 and 0 are the same place
    h *= 0xBF58476D1CE4E5B9ULL;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace

// The points are chosen by their coordinates, not by their number, so that all points of one place are chosen together.
double duplicated_share(const PointCloud& cloud) {
  const std::uint64_t one_in = cloud.size() / max_sample + 1;
  std::vector<std::uint64_t> keys;
  keys.reserve(cloud.size() / one_in + 1);
  for (const auto& p : cloud.positions())
    if (const auto key = mixed(p); key % one_in == 0) keys.push_back(key);
  if (keys.empty()) return 0;
  std::ranges::sort(keys);
  const auto places = std::distance(keys.begin(), std::unique(keys.begin(), keys.end()));
  return 1 - static_cast<double>(places) / static_cast<double>(keys.size());
}

}  // namespace sight
}  // namespace cloud
}  // namespace bole
