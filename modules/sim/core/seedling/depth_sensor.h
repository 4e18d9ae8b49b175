// What depth cameras make of exact depth.
#pragma once

#include <cstdint>

#include "sim/core/seedling/picture.h"

namespace bole::sim {

// Depth of a structured-light camera (Kinect), registered to the colour camera `pixels`. Axial and lateral noise after
// Nguyen, Izadi, Lovell (Modeling Kinect sensor noise for improved 3D reconstruction and tracking, 3DIMPVT 2012),
// disparity in steps of 1/8 pixel, holes where the projector does not reach and at grazing incidence. `noise` is a
// factor on both.
DepthImage kinect_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view, double noise,
                        std::uint64_t seed);

}  // namespace bole::sim
