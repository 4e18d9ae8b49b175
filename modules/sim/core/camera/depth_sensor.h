// What depth cameras make of a scene.
#pragma once

#include <cstdint>

#include "sim/core/camera/exact_depth.h"
#include "sim/core/camera/picture.h"

namespace bole::sim {

// `noise` is a factor on all noise. `view` is that of the camera whose pixels are given.

// Depth of a structured-light camera (Kinect), registered to the colour camera `pixels`. Axial and lateral noise after
// Nguyen, Izadi, Lovell (Modeling Kinect sensor noise for improved 3D reconstruction and tracking, 3DIMPVT 2012),
// disparity in steps of 1/8 pixel, holes where the projector does not reach and at grazing incidence.
DepthImage kinect_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view, double noise,
                        std::uint64_t seed);

// An infrared pair with projected dots, like that of a RealSense D435, matched by semi-global matching (OpenCV): edges
// are fattened, and occluded and smooth places have no depth, as with a real pair. `pixels` are those of the left
// camera, which has no distortion.
inline constexpr double stereo_baseline = 0.050;  // metres
struct InfraredPair {
  Image<std::uint8_t> left, right;
};
InfraredPair render_infrared(const PictureScene& scene, const Lighting& lighting, const SurfaceColors& colors,
                             const PixelDirections& pixels, const ViewPose& view, double noise, std::uint64_t seed);
// Disparities reach down to a depth of 0.24 m.
DepthImage match_infrared(const InfraredPair& pair, const CameraModel& camera);

// Time of flight, one frequency of 80 MHz. What a pixel sees of several surfaces adds up as waves do, so that edges
// have depths between them.
DepthImage tof_depth(const PictureScene& scene, const SurfaceColors& colors, const PixelDirections& pixels,
                     const ViewPose& view, double noise, std::uint64_t seed);

// Depth of `camera.depth` as the colour camera would see it: each pixel covers its square to whole pixels, the nearer
// one wins.
DepthImage register_to_color(const DepthImage& depth, const RgbdCamera& camera);

}  // namespace bole::sim
