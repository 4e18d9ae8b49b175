#include "ground/core/heights.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace bole::ground {

std::vector<float> heights_above(const PointCloud& cloud, const Raster& dem, const Run& run) {
  std::vector<float> height(cloud.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cloud.size(), 1 << 16), [&](const auto& range) {
    run.check_cancel();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Eigen::Vector3d p = cloud.position(i);
      height[i] = static_cast<float>(p.z() - dem.sample(p.x(), p.y()));
    }
  });
  return height;
}

std::vector<std::uint8_t> classify(const PointCloud& cloud, const std::vector<float>& height_above_ground,
                                   const GroundScales& scales) {
  constexpr std::uint8_t unassigned = 1, ground = 2, low_noise = 7;
  const std::vector<std::uint8_t>* before = scales.keep_classes && cloud.has(arrays::classification)
                                                ? &cloud.values<std::uint8_t>(arrays::classification)
                                                : nullptr;
  std::vector<std::uint8_t> out(cloud.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto h = static_cast<double>(height_above_ground[i]);
    const std::uint8_t kept = before ? (*before)[i] : 0;
    if (kept != 0 && kept != unassigned && kept != ground && kept != low_noise)
      out[i] = kept;
    else
      out[i] = std::abs(h) <= scales.tolerance ? ground : h < -scales.noise_depth ? low_noise : unassigned;
  }
  return out;
}

}  // namespace bole::ground
