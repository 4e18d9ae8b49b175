// From a cloud to a terrain model with heights above it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/height_facts.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "ground/core/options.h"

namespace bole::ground {

struct GroundModel {
  Raster dem;     // "elevation_m"; NaN further than fill_distance_m from any ground point
  Raster filled;  // "filled": 1 where the DEM was filled, 0 where it was measured, NaN where it is NaN
  std::vector<float> height_above_ground;    // per point, metres; NaN off the DEM
  std::vector<std::uint8_t> classification;  // per point, ASPRS
  TerrainSource source = TerrainSource::ground;
  Report report;
};

// z of `cloud` points up. Throws Error{bad_input} for a cloud without finite points or of too great an extent,
// Error{failed} when no ground is found. What speaks against the terrain is a finding of the report. `given`: by point
// the class that a person gave (given_ground.h); points given to the ground carry the terrain where it is triangulated.
GroundModel model_ground(const PointCloud& cloud, const GroundOptions& options, const Run& run,
                         const std::vector<std::uint8_t>& given = {});

// Heights and classes over a terrain that was made before, of which the model is a copy. Throws Error{bad_input} where
// it lies below no point of the cloud.
GroundModel ground_of(const PointCloud& cloud, const Raster& terrain, const GroundOptions& options, const Run& run);

// Why model_ground() takes the cloud for height-normalised where the method is open; empty where it does not. Throws
// Error{bad_input} as it does.
std::string evidence_of_normalised(const PointCloud& cloud, const Run& run);

}  // namespace bole::ground
