// The final adjustment: all of the path against all of the map, in turns. Each round builds the map from every frame
// with the present path, matches every frame to it, and solves for all nodes of the smooth path at once (a banded
// system). Walls that were mapped twice come together, and motion faster than a frame is followed.
#pragma once

#include <string>
#include <vector>

#include "slam/core/map/path.h"
#include "slam/core/odometry/registration.h"
#include "slam/core/options.h"

namespace bole::slam {

// What the adjustment needs of a frame: some of its points, raw, with their place in time.
struct FrameSample {
  double begin_s = 0, end_s = 0;
  FeatureSet features;
};

struct RefineSettings {
  int rounds = 3;
  double node_spacing_s = 0.05;
  double cell_m = 0.1;
  double sigma_m = 0.02;
  double kernel_sigmas = 3;
  double acceleration_sigma_m_s2 = 10;  // change of velocity between pieces of the path, per second
  double acceleration_sigma_rad_s2 = 5;
};

struct RefineResult {
  Path path;
  std::vector<double> rms_m;   // of the inliers, at the start of each round
  std::vector<double> step_m;  // root mean square move of the nodes in each round
  std::string stopped;         // why a round could not be believed: `path` is that before it; else empty
};

// Throws Error{cancelled}; stops after the round in work when asked to finish.
RefineResult refine_path(const Path& initial, const std::vector<FrameSample>& frames, const RefineSettings& settings,
                         const Run& run);

}  // namespace bole::slam
