#include "render/scene/seen_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace bole::render {
namespace {

constexpr std::size_t spacing_sample = 64;               // points whose neighbours are looked for
constexpr std::size_t points_between_polls = 1U << 17U;  // points between two looks at a cancel
constexpr int max_half_px = 12;                          // of what a point covers
constexpr double behind_spacings = 3, behind_pixels = 2;

// The square that a point covers.
int half_px(const CameraModel& camera, double spacing_m, double depth_m, double share) {
  const double px = share * std::abs(camera.fx) * spacing_m / depth_m;
  return std::clamp(static_cast<int>(px), 0, max_half_px);
}

template <class Put>
void cover(const DepthImage& image, const SeenPoint& p, int half, Put put) {
  const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
  for (int v = std::max(0, y - half); v <= std::min(image.height - 1, y + half); ++v)
    for (int u = std::max(0, x - half); u <= std::min(image.width - 1, x + half); ++u) put(u, v);
}

// Of the points in a pixel the foremost.
DepthImage front_of(const std::vector<SeenPoint>& points, const CameraModel& camera, double spacing_m) {
  DepthImage front(camera.width, camera.height);
  for (const auto& p : points)
    cover(front, p, half_px(camera, spacing_m, p.depth_m, 1), [&](int x, int y) {
      float& depth = front.at(x, y);
      if (depth == 0 || p.depth_m < depth) depth = p.depth_m;
    });
  return front;
}

// Of the points in a pixel the one nearest to its middle: the foremost would be too near on a surface that slopes.
// Points cover half of what they hide, so that the rim of a thing does not grow over what is measured behind it.
DepthImage middle_of(const std::vector<SeenPoint>& points, const CameraModel& camera, double spacing_m) {
  DepthImage depth(camera.width, camera.height);
  bole::Image<float> off(camera.width, camera.height, 1, std::numeric_limits<float>::infinity());
  for (const auto& p : points)
    cover(depth, p, half_px(camera, spacing_m, p.depth_m, 0.5), [&](int x, int y) {
      const float px = std::hypot(p.x - static_cast<float>(x), p.y - static_cast<float>(y));
      if (px >= off.at(x, y)) return;
      off.at(x, y) = px;
      depth.at(x, y) = p.depth_m;
    });
  return depth;
}

}  // namespace

double point_spacing_m(const PointCloud& cloud, const Run& run) {
  const auto& positions = cloud.positions();
  std::vector<float> nearest;
  const std::size_t step = std::max<std::size_t>(1, positions.size() / spacing_sample);
  for (std::size_t i = 0; i < positions.size(); i += step) {
    run.check_cancel();
    float best = std::numeric_limits<float>::infinity();
    for (const auto& q : positions)
      if (const float d = (q - positions[i]).squaredNorm(); d > 0 && d < best) best = d;
    if (std::isfinite(best)) nearest.push_back(std::sqrt(best));
  }
  if (nearest.empty()) return 0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

SeenCloud see_cloud(const PointCloud& cloud, const CameraModel& camera, const Pose& T_world_camera, double spacing_m,
                    const Run& run) {
  camera.check();
  const Pose T_camera_world = T_world_camera.inverse();
  std::vector<SeenPoint> in_picture;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % points_between_polls == 0) run.check_cancel();
    const Eigen::Vector3d p = T_camera_world * cloud.position(i);
    const auto pixel = camera.project(p);
    if (!pixel || !camera.contains(*pixel)) continue;
    in_picture.push_back({static_cast<std::uint32_t>(i), static_cast<float>(pixel->x()), static_cast<float>(pixel->y()),
                          static_cast<float>(p.z())});
  }
  const auto front = front_of(in_picture, camera, spacing_m);
  run.check_cancel();
  SeenCloud seen;
  for (const auto& p : in_picture) {
    const int x = std::clamp(static_cast<int>(std::lround(p.x)), 0, camera.width - 1),
              y = std::clamp(static_cast<int>(std::lround(p.y)), 0, camera.height - 1);
    if (p.depth_m <= front.at(x, y) + behind_spacings * spacing_m + behind_pixels * p.depth_m / std::abs(camera.fx))
      seen.points.push_back(p);
  }
  seen.depth = middle_of(seen.points, camera, spacing_m);
  return seen;
}

DepthImage depth_residual(const DepthImage& measured, const DepthImage& of_cloud) {
  if (measured.width != of_cloud.width || measured.height != of_cloud.height)
    throw failure("depth images of two sizes are compared");
  DepthImage residual(measured.width, measured.height, 1, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < residual.values.size(); ++i)
    if (measured.values[i] > 0 && of_cloud.values[i] > 0) residual.values[i] = measured.values[i] - of_cloud.values[i];
  return residual;
}

}  // namespace bole::render
