#include "plant/core/surface/posed_views.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace bole::plant {

std::vector<PosedView> posed_views(const ViewSource& views, const Trajectory& poses, std::size_t min_views,
                                   Report& report) {
  std::vector<PosedView> posed;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (const auto pose = pose_of_view(poses, views.time_s(i)); pose && pose->matrix().allFinite())
      posed.push_back({i, *pose});
  if (posed.size() < min_views)
    throw bad_input(std::to_string(posed.size()) + " of " + std::to_string(views.size()) + " views have a pose",
                    "at least " + std::to_string(min_views),
                    "Connect the poses that belong to these views (their times must agree)");
  if (const auto missing = views.size() - posed.size(); missing > 0)
    report.find(
        missing * 4 > views.size() ? Severity::look : Severity::note, "views_without_pose",
        std::to_string(missing) + " of " + std::to_string(views.size()) + " views have no pose and are left out.");
  report.counts["views"] = static_cast<std::int64_t>(posed.size());
  return posed;
}

double DepthNoise::sigma(double z) const { return sigma_at_half_metre * std::max(0.25, 4 * z * z); }

MaskImage depth_edges(const DepthImage& depth, const DepthNoise& noise, int reach) {
  MaskImage jumps(depth.width, depth.height, 1, 0), edges(depth.width, depth.height, 1, 0);
  const auto is_jump = [&](float a, float b) {
    if (a <= 0 || b <= 0) return (a > 0) != (b > 0);
    const double z = std::min(a, b);
    return std::abs(a - b) > 5 * noise.sigma(z) + 0.01 * z;
  };
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      if ((x + 1 < depth.width && is_jump(depth.at(x, y), depth.at(x + 1, y))) ||
          (y + 1 < depth.height && is_jump(depth.at(x, y), depth.at(x, y + 1))))
        jumps.at(x, y) = 255;
  MaskImage rows = jumps;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      for (int k = std::max(0, x - reach); k <= std::min(depth.width - 1, x + reach) && rows.at(x, y) == 0; ++k)
        rows.at(x, y) = jumps.at(k, y);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      for (int k = std::max(0, y - reach); k <= std::min(depth.height - 1, y + reach) && edges.at(x, y) == 0; ++k)
        edges.at(x, y) = rows.at(x, k);
  return edges;
}

DepthImage viewing_cosines(const DepthImage& depth, const CameraModel& camera) {
  DepthImage cosines(depth.width, depth.height, 1, 0.0F);
  const auto point = [&](int x, int y) {
    const double z = depth.at(x, y);
    return Eigen::Vector3d((x - camera.cx) / camera.fx * z, (y - camera.cy) / camera.fy * z, z);
  };
  constexpr int step = 2;  // wider than a pixel: the noise of single pixels would tilt every normal
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      if (depth.at(x, y) <= 0) continue;
      const int x0 = std::max(0, x - step), x1 = std::min(depth.width - 1, x + step);
      const int y0 = std::max(0, y - step), y1 = std::min(depth.height - 1, y + step);
      float cosine = 0.3F;  // no neighbours to tell the angle
      if (depth.at(x0, y) > 0 && depth.at(x1, y) > 0 && depth.at(x, y0) > 0 && depth.at(x, y1) > 0) {
        const Eigen::Vector3d normal = (point(x1, y) - point(x0, y)).cross(point(x, y1) - point(x, y0));
        const Eigen::Vector3d sight = point(x, y);
        const double scale = normal.norm() * sight.norm();
        if (scale > 0) cosine = static_cast<float>(std::abs(normal.dot(sight)) / scale);
      }
      cosines.at(x, y) = std::max(0.05F, cosine);
    }
  return cosines;
}

float depth_at(const DepthImage& depth, float x, float y, float max_difference) {
  const int nx = static_cast<int>(std::lround(x)), ny = static_cast<int>(std::lround(y));
  if (!depth.contains(nx, ny)) return 0;
  const float nearest = depth.at(nx, ny);
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  if (nearest <= 0 || !depth.contains(x0, y0) || !depth.contains(x0 + 1, y0 + 1)) return nearest;
  const float a = depth.at(x0, y0), b = depth.at(x0 + 1, y0), c = depth.at(x0, y0 + 1), d = depth.at(x0 + 1, y0 + 1);
  const auto [low, high] = std::minmax({a, b, c, d});
  if (low <= 0 || high - low > max_difference) return nearest;
  const float u = x - static_cast<float>(x0), v = y - static_cast<float>(y0);
  return (a * (1 - u) + b * u) * (1 - v) + (c * (1 - u) + d * u) * v;
}

}  // namespace bole::plant
