#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "base/random.h"
#include "sim/core/camera/depth_sensor.h"

namespace bole::sim {
namespace {

const Eigen::Vector3d projector_place(0.028, 0, 0);  // metres, in the axes of the left camera
constexpr double infrared_exposure = 0.9, infrared_room_light = 0.35;
constexpr double nearest = 0.24;  // metres
constexpr int window = 5;         // pixels

cv::Mat mat_over(const Image<std::uint8_t>& image) {
  return cv::Mat(image.height, image.width, CV_8UC1,
                 const_cast<std::uint8_t*>(image.values.data()));  // NOLINT: only read
}

}  // namespace

InfraredPair render_infrared(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                             const PixelDirections& pixels, const ViewPose& view, double noise, std::uint64_t seed) {
  const auto picture = [&](double right, std::uint64_t number) {
    DotProjector projector;
    projector.seed = 0xd075;  // the pattern belongs to the sensor, not to the plant
    projector.offset = projector_place - Eigen::Vector3d(right, 0, 0);
    PictureOptions o;
    o.infrared = true;
    o.projector = &projector;
    o.room_light = infrared_room_light;
    o.point_spread = 0.5;
    Pose T_left_here = Pose::Identity();
    T_left_here.translation().x() = right;
    const SensorNoise sensor{0.015 * noise, 0.004 * noise};
    const auto light =
        render_picture(scene, lighting, colors, pixels, view.mounted(T_left_here), o, mix64(seed + number));
    return develop_infrared(light, infrared_exposure, sensor, mix64(seed + number + 2));
  };
  return {picture(0, 1), picture(stereo_baseline, 2)};
}

DepthImage match_infrared(const InfraredPair& pair, const CameraModel& camera) {
  const double scale = camera.fx * stereo_baseline;
  const int disparities = 16 * std::max(1, static_cast<int>(std::ceil(scale / nearest / 16)));
  const auto matcher = cv::StereoSGBM::create(0, disparities, window, 8 * window * window, 32 * window * window, 1, 31,
                                              6, 60, 1, cv::StereoSGBM::MODE_SGBM);
  cv::Mat sixteenths;
  matcher->compute(mat_over(pair.left), mat_over(pair.right), sixteenths);
  DepthImage depth(camera.width, camera.height);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double disparity = sixteenths.at<short>(y, x) / 16.0;
      if (disparity > 0.5) depth.at(x, y) = static_cast<float>(scale / disparity);
    }
  return depth;
}

}  // namespace bole::sim
