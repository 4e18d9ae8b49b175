// Heights above a terrain model, and what they say about points.
#pragma once

#include <cstdint>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "ground/core/scales.h"

namespace bole::ground {

// Height of each point above the bilinearly interpolated `dem`, metres; NaN where the DEM has no value.
std::vector<float> heights_above(const PointCloud& cloud, const Raster& dem, const Run& run);

// ASPRS classes: 2 within tolerance of the terrain, 7 deeper than noise_depth below it, else 1. With keep_classes a
// class of the input that is none of 0, 1, 2 and 7 stays.
std::vector<std::uint8_t> classify(const PointCloud& cloud, const std::vector<float>& height_above_ground,
                                   const GroundScales& scales);

}  // namespace bole::ground
