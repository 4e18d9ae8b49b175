#include "sim/core/seedling/pixel_directions.h"

#include <algorithm>

namespace bole::sim {

PixelDirections::PixelDirections(const CameraModel& camera) : camera_(camera) {
  if (!camera.distorted()) return;
  for (int y = 0; y <= camera.height; ++y)
    for (int x = 0; x <= camera.width; ++x)
      corners_.push_back(camera.direction({x - 0.5, y - 0.5}).head<2>().cast<float>());
}

Eigen::Vector3d PixelDirections::at(double x, double y) const {
  if (corners_.empty()) return {(x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1};
  const double u = std::clamp(x + 0.5, 0.0, camera_.width - 1e-9), v = std::clamp(y + 0.5, 0.0, camera_.height - 1e-9);
  const int i = static_cast<int>(u), k = static_cast<int>(v);
  const auto s = static_cast<float>(u - i), t = static_cast<float>(v - k);
  const auto corner = [&](int a, int b) {
    const int at = b * (camera_.width + 1) + a;
    return corners_[static_cast<std::size_t>(at)];
  };
  const Eigen::Vector2f upper = (1 - s) * corner(i, k) + s * corner(i + 1, k);
  const Eigen::Vector2f lower = (1 - s) * corner(i, k + 1) + s * corner(i + 1, k + 1);
  return ((1 - t) * upper + t * lower).cast<double>().homogeneous();
}

}  // namespace bole::sim
