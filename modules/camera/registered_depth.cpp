#include "camera/registered_depth.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bole {
inline namespace camera {

DepthImage registered_depth(const DepthImage& depth, const MaskImage& left_out, const CameraModel& depth_camera,
                            const Pose& T_color_depth, const CameraModel& color_camera) {
  // Where the pixels of the depth image land. Those to be left out hide others all the same.
  DepthImage nearest_of(color_camera.width, color_camera.height, 1, 0.0F), landed = nearest_of, out = nearest_of;
  MaskImage keeps(color_camera.width, color_camera.height, 1, 255);
  Image<std::uint16_t> counts(color_camera.width, color_camera.height);
  struct Landing {
    std::size_t at = 0;
    float z = 0;
    bool keep = true;
  };
  std::vector<Landing> landings;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double z = depth.at(x, y);
      if (!(z > 0) || !std::isfinite(z)) continue;
      const Eigen::Vector3d p = T_color_depth * Eigen::Vector3d(depth_camera.direction({x, y}) * z);
      const auto pixel = color_camera.project(p);
      if (!pixel || !color_camera.contains(*pixel)) continue;
      const auto at =
          landed.index(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
      landings.push_back({at, static_cast<float>(p.z()), left_out.empty() || left_out.at(x, y) == 0});
      float& nearest = nearest_of.values[at];
      nearest = nearest > 0 ? std::min(nearest, landings.back().z) : landings.back().z;
    }
  // Of several depths in one pixel the mean: the nearest alone would be the one with the largest error.
  constexpr float same_surface = 1.03F;
  for (const auto& l : landings) {
    if (l.z > nearest_of.values[l.at] * same_surface) continue;
    landed.values[l.at] += l.z;
    ++counts.values[l.at];
    if (!l.keep) keeps.values[l.at] = 0;
  }
  for (std::size_t i = 0; i < landed.values.size(); ++i)
    if (counts.values[i] > 0) landed.values[i] /= static_cast<float>(counts.values[i]);
  // Pixels between those that were hit have the mean of their neighbours. What shines through between the pixels of a
  // nearer surface is dropped. Taking the nearest neighbour instead would pull slanted surfaces towards the camera.
  const double ratio = std::abs(color_camera.fx / depth_camera.fx);
  const int reach = std::clamp(static_cast<int>(std::ceil(ratio / 2)), 1, 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      float nearest = 0, sum = 0;
      int count = 0, kept = 0;
      const auto each = [&](auto visit) {
        for (int v = std::max(0, y - reach); v <= std::min(out.height - 1, y + reach); ++v)
          for (int u = std::max(0, x - reach); u <= std::min(out.width - 1, x + reach); ++u)
            if (landed.at(u, v) > 0) visit(landed.at(u, v), keeps.at(u, v));
      };
      each([&](float z, std::uint8_t) { nearest = nearest > 0 ? std::min(nearest, z) : z; });
      if (nearest <= 0) continue;
      const float limit = nearest * same_surface;
      const float own = landed.at(x, y);
      if (own > 0 && own <= limit) {
        out.at(x, y) = keeps.at(x, y) != 0 ? own : -own;
        continue;
      }
      if (own <= 0 && ratio <= 1.05) continue;  // a hole of the depth image itself
      each([&](float z, std::uint8_t keep) {
        if (z > limit) return;
        sum += z;
        ++count;
        kept += keep != 0;
      });
      const float mean = sum / static_cast<float>(count);
      out.at(x, y) = kept == count ? mean : -mean;
    }
  return out;
}

}  // namespace camera
}  // namespace bole
