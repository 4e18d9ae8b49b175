#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/random.h"
#include "sim/core/camera/depth_sensor.h"

namespace bole::sim {
namespace {

constexpr double kinect_focal = 585;       // pixels of the depth camera
constexpr double kinect_baseline = 0.075;  // metres
constexpr double disparity_step = 0.125;   // pixels
constexpr double max_angle = 80 * rad_per_deg;
constexpr double shadow_slack = 0.003;  // metres before a surface that do not shade it

double incidence_term(double cosine) {
  const double theta = std::min(std::acos(std::clamp(cosine, 0.0, 1.0)), max_angle);
  return theta / (std::numbers::pi / 2 - theta);
}

// Whether the projector, beside the camera, lights a point of the world.
class ProjectorShadow {
 public:
  ProjectorShadow(const PictureScene& scene, const ViewPose& view)
      : scene_(scene), projector_(view.T_world_camera * Eigen::Vector3d(-kinect_baseline, 0, 0)), view_(view) {}

  std::array<bool, RayPack::size> of(const std::array<Eigen::Vector3d, RayPack::size>& in_camera) const {
    RayPack pack;
    for (int k = 0; k < RayPack::size; ++k) {
      const Eigen::Vector3d at = view_.T_world_camera * in_camera[static_cast<std::size_t>(k)];
      const Eigen::Vector3d way = at - projector_;
      const double length = std::max(way.norm(), 1e-6);
      pack.set(k, projector_, way * std::max(0.0, 1 - shadow_slack / length));
    }
    return scene_.world_rays->blocked(pack, 1);
  }

 private:
  const PictureScene& scene_;
  Eigen::Vector3d projector_;
  const ViewPose& view_;
};

}  // namespace

DepthImage kinect_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view, double noise,
                        std::uint64_t seed) {
  // The depth camera looks from the same place with coarser pixels; its image is then registered to the colour image.
  const CameraModel sensor = pixels.camera().scaled(std::min(1.0, kinect_focal / pixels.camera().fx));
  const PixelDirections coarse(sensor);
  const ExactDepth exact = render_depth(scene, coarse, view);
  const std::size_t count = exact.depth.values.size();
  std::vector<Eigen::Vector2f> shifts(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = mix64(seed ^ mix64(2 * i));
    const double sd = noise * (0.8 + 0.035 * incidence_term(static_cast<double>(exact.cosine.values[i])));
    shifts[i] = static_cast<float>(sd) * Eigen::Vector2f(quick_normal(bits), quick_normal(mix64(bits)));
  }
  const ExactDepth moved = render_depth(scene, coarse, view, shifts);
  const ProjectorShadow shadow(scene, view);
  DepthImage measured(sensor.width, sensor.height);
  tbb::parallel_for(tbb::blocked_range<int>(0, sensor.height, 4), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < sensor.width; x += RayPack::size) {
        std::array<Eigen::Vector3d, RayPack::size> points;
        for (int k = 0; k < RayPack::size; ++k) {
          const int px = std::min(x + k, sensor.width - 1);
          const auto i = exact.depth.index(px, y);
          const Eigen::Vector2d at = Eigen::Vector2d(px, y) + shifts[i].cast<double>();
          points[static_cast<std::size_t>(k)] = coarse.at(at.x(), at.y()) * static_cast<double>(moved.depth.values[i]);
        }
        const auto dark = shadow.of(points);
        for (int k = 0; k < RayPack::size && x + k < sensor.width; ++k) {
          const auto i = exact.depth.index(x + k, y);
          const auto z = static_cast<double>(moved.depth.values[i]);
          const auto cosine = static_cast<double>(moved.cosine.values[i]);
          if (z <= 0 || dark[static_cast<std::size_t>(k)] || cosine < std::cos(max_angle)) continue;
          const double term = incidence_term(cosine), beyond = z - 0.4;
          const double sd = 0.0012 + 0.0019 * beyond * beyond + 0.0001 / std::sqrt(z) * term * term;
          const double noisy = z + noise * sd * static_cast<double>(quick_normal(mix64(seed ^ mix64(2 * i + 1))));
          const double scale = kinect_focal * kinect_baseline / disparity_step;
          const double steps = std::round(scale / std::max(noisy, 0.05));
          measured.values[i] = static_cast<float>(noise > 0 ? scale / steps : noisy);
        }
      }
  });
  const auto& color = pixels.camera();
  DepthImage out(color.width, color.height);
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x)
      out.at(x, y) = measured.at(std::min(sensor.width - 1, (2 * x + 1) * sensor.width / (2 * color.width)),
                                 std::min(sensor.height - 1, (2 * y + 1) * sensor.height / (2 * color.height)));
  return out;
}

}  // namespace bole::sim
