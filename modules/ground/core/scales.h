// The lengths that the terrain model works with, from the options or from the density of the cloud.
#pragma once

#include "cloud/point_cloud.h"
#include "ground/core/options.h"

namespace bole::ground {

// GroundOptions without open ends: metres and degrees.
struct GroundScales {
  double cell = 0.25;
  double seed = 4.0;
  double max_slope_deg = 50.0;
  double max_angle_deg = 15.0;
  double max_distance = 0.6;
  double roughness = 0.10;
  double band = 0.30;
  double tolerance = 0.15;
  double noise_depth = 0.30;
  double fill_distance = 10.0;
  bool keep_classes = true;
};

// The smallest of 0.25, 0.5, 1, 2 and 4 m at which at least two fifths of the cells of that size hold points, in the
// area that the cloud covers.
double point_spacing(const PointCloud& cloud);

// What the options leave open follows the density: sparse clouds come from the air, with larger objects, more noise in
// height and fewer points to tell ground by. Throws Error{bad_input} where a seed is smaller than two cells.
GroundScales scales_for(const PointCloud& cloud, const GroundOptions& options);

}  // namespace bole::ground
