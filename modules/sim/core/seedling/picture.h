// Pictures of a scene: light as it falls on the sensor, and the image that the camera makes of it.
#pragma once

#include <cstdint>

#include "camera/camera_model.h"
#include "camera/image.h"
#include "sim/core/seedling/picture_scene.h"
#include "sim/core/seedling/surface_color.h"

namespace bole::sim {

// Where the camera is in the middle of the exposure, and how it moves during it: twists (rotation rad, translation m,
// camera axes) over the whole exposure, against the plant and against the room.
struct ViewPose {
  Pose T_world_camera = Pose::Identity();
  Pose T_room_camera = Pose::Identity();
  Vector6d world_motion = Vector6d::Zero(), room_motion = Vector6d::Zero();
};

struct PictureOptions {
  int samples = 2;             // along each side of a pixel
  double point_spread = 0.45;  // standard deviation of the lens, pixels
  bool infrared = false;       // one channel instead of three
};

// Directions of the pixels of a camera, undistorted once.
class PixelDirections {
 public:
  explicit PixelDirections(const CameraModel& camera);
  const CameraModel& camera() const { return camera_; }
  // (x / z, y / z, 1) at any place of the image; for distorted cameras linear between pixels.
  Eigen::Vector3d at(double x, double y) const;

 private:
  CameraModel camera_;
  std::vector<Eigen::Vector2f> corners_;  // of pixels, by rows; empty without distortion
};

// Linear light; white paper on the mat is about 0.8.
Image<float> render_picture(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                            const PixelDirections& pixels, const ViewPose& view, const PictureOptions& options,
                            std::uint64_t seed);

struct SensorNoise {
  double shot = 0.010, read = 0.0010;  // standard deviations at light 1 (grows with the root) and in the dark
};

// Exposure (a factor on the light), noise, the sRGB curve and 8 bits.
ColorImage develop(const Image<float>& light, double exposure, const SensorNoise& noise, std::uint64_t seed);

// Depth along exact rays through the centres of the pixels, and the cosine between ray and surface.
struct ExactDepth {
  DepthImage depth;  // metres along z; 0 where nothing is met
  Image<float> cosine;
};
// `shifts`: places in pixels added to the centres, x and y for each pixel, or empty.
ExactDepth render_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view,
                        const std::vector<Eigen::Vector2f>& shifts = {});

// About normal with standard deviation 1, bounded by 3.5, from 64 random bits.
inline float quick_normal(std::uint64_t bits) {
  const auto part = [bits](int shift) { return static_cast<float>((bits >> shift) & 0xffffu); };
  return ((part(0) + part(16) + part(32) + part(48)) * (1.0F / 65536.0F) - 2.0F) * 1.7320508F;
}

}  // namespace bole::sim
