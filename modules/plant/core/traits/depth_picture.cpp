#include "plant/core/traits/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::plant {
namespace {

constexpr std::size_t max_hiding = 400000;  // points that are drawn
constexpr int block = 3;                    // pixels

int cell(double v, int count) { return std::clamp(static_cast<int>(std::floor((v + 0.5) / block)), 0, count - 1); }

}  // namespace

DepthPicture::DepthPicture(const CameraModel& camera, const Pose& T_camera_plant, const Points3& cloud, double spacing)
    : columns_(camera.width / block + 1), rows_(camera.height / block + 1) {
  nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                  std::numeric_limits<float>::max());
  const std::size_t stride = std::max<std::size_t>(1, cloud.size() / max_hiding);
  for (std::size_t i = 0; i < cloud.size(); i += stride) {
    const Eigen::Vector3d p = T_camera_plant * cloud[i];
    const auto at = camera.project(p);
    if (!at || !camera.contains(*at)) continue;
    const double splat = 0.7 * spacing * std::abs(camera.fx) / p.z();
    for (int y = cell(at->y() - splat, rows_); y <= cell(at->y() + splat, rows_); ++y)
      for (int x = cell(at->x() - splat, columns_); x <= cell(at->x() + splat, columns_); ++x) {
        auto& d = nearest_[index(x, y)];
        d = std::min(d, static_cast<float>(p.z()));
      }
  }
}

bool DepthPicture::hides(const Eigen::Vector2d& pixel, double depth) const {
  return static_cast<double>(nearest_[index(cell(pixel.x(), columns_), cell(pixel.y(), rows_))]) < depth;
}

}  // namespace bole::plant
