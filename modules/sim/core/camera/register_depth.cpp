#include <algorithm>
#include <cmath>

#include "sim/core/camera/depth_sensor.h"

namespace bole::sim {

DepthImage register_to_color(const DepthImage& depth, const RgbdCamera& camera) {
  DepthImage out(camera.color.width, camera.color.height);
  const auto& from = camera.of_depth();
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double z = static_cast<double>(depth.at(x, y));
      if (z <= 0) continue;
      const auto corner = [&](double dx, double dy) {
        return camera.color.project(camera.T_color_depth * Eigen::Vector3d(z * from.direction({x + dx, y + dy})));
      };
      const auto a = corner(-0.5, -0.5), b = corner(0.5, 0.5);
      const Eigen::Vector3d middle = camera.T_color_depth * Eigen::Vector3d(z * from.direction({x, y}));
      if (!a || !b) continue;
      // From the pixel that holds one corner to that of the other, as the makers' libraries do: no gaps between
      // squares.
      const auto pixel = [](double at, int size) {
        return static_cast<int>(std::lround(std::clamp(at, -1.0, size + 1.0)));
      };
      const int x0 = std::max(0, pixel(a->x(), out.width)), x1 = std::min(out.width, pixel(b->x(), out.width) + 1);
      const int y0 = std::max(0, pixel(a->y(), out.height)), y1 = std::min(out.height, pixel(b->y(), out.height) + 1);
      for (int v = y0; v < y1; ++v)
        for (int u = x0; u < x1; ++u) {
          float& seen = out.at(u, v);
          if (seen == 0 || static_cast<double>(seen) > middle.z()) seen = static_cast<float>(middle.z());
        }
    }
  return out;
}

}  // namespace bole::sim
