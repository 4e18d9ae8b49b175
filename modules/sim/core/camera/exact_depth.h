// Depth along exact rays.
#pragma once

#include <vector>

#include "camera/image.h"
#include "sim/core/seedling/pixel_directions.h"
#include "sim/core/seedling/seen_point.h"
#include "sim/core/seedling/surface_color.h"

namespace bole::sim {

struct ExactDepth {
  DepthImage depth;        // metres along z; 0 where nothing is met
  Image<float> cosine;     // between ray and surface
  Image<float> reflected;  // share of infrared light that the surface sends back; empty without colours
};

// Through the centres of the pixels. `shifts`: places in pixels added to the centres, for each pixel, or empty.
// `colors`: for `reflected`, or null.
ExactDepth render_depth(const PictureScene& scene, const PixelDirections& pixels, const ViewPose& view,
                        const std::vector<Eigen::Vector2f>& shifts = {}, const SurfaceColors* colors = nullptr);

}  // namespace bole::sim
