// Pictures of a scene: light as it falls on the sensor, and the image that the camera makes of it.
#pragma once

#include <cstdint>
#include <stop_token>

#include "camera/image.h"
#include "sim/core/seedling/pixel_directions.h"
#include "sim/core/seedling/seen_point.h"
#include "sim/core/seedling/surface_color.h"

namespace bole::sim {

// A projector of infrared dots near the camera. Its axes are those of the camera, moved by `offset`.
struct DotProjector {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // metres, camera axes
  double cell = 0.016;                               // mean distance of the dots (tangent of the angle)
  double spread = 0.0024;                            // standard deviation of a dot (tangent of the angle)
  double strength = 1.1;                             // irradiance in the middle of a dot at 0.5 m
  std::uint64_t seed = 0;

  // Light on a point, in the projector's axes, without shadows and incidence.
  float light(const Eigen::Vector3d& point) const;
};

struct PictureOptions {
  int samples = 2;                          // along each side of a pixel
  double point_spread = 0.45;               // standard deviation of the lens, pixels
  bool infrared = false;                    // one channel instead of three
  const DotProjector* projector = nullptr;  // of infrared pictures
  double room_light = 1;                    // factor on the light of the room, of infrared pictures
  std::stop_token cancel;                   // a picture that was stopped is black in part
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
// The same of an infrared picture, with a straight curve.
Image<std::uint8_t> develop_infrared(const Image<float>& light, double exposure, const SensorNoise& noise,
                                     std::uint64_t seed);

// About normal with standard deviation 1, bounded by 3.5, from 64 random bits.
inline float quick_normal(std::uint64_t bits) {
  const auto part = [bits](int shift) { return static_cast<float>((bits >> shift) & 0xffffu); };
  return ((part(0) + part(16) + part(32) + part(48)) * (1.0F / 65536.0F) - 2.0F) * 1.7320508F;
}

}  // namespace bole::sim
