// The final trajectory adjustment: the whole path and the whole map, in turns. Each iteration builds the map from every
// frame with the present path, matches every frame to it, and solves for all nodes of the smooth path at once (a banded
// system). Walls that were mapped twice come together, and motion faster than a frame is followed.
#pragma once

#include <string>
#include <vector>

#include "slam/core/map/inertial_terms.h"
#include "slam/core/map/path.h"
#include "slam/core/odometry/registration.h"
#include "slam/core/options.h"

namespace bole::slam {

// What the adjustment needs of a frame: some of its raw points with their times.
struct FrameSample {
  double begin_s = 0, end_s = 0;
  FeatureSet features;
};

struct RefineSettings {
  int iterations = 3;
  double node_spacing_s = 0.05;
  double cell_size = 0.1;
  double sigma = 0.02;
  double kernel_sigmas = 3;
  double acceleration_sigma = 10;  // change of velocity between pieces of the path, per second
  double angular_acceleration_sigma = 5;
};

struct RefineResult {
  Path path;
  std::vector<double> rms;        // of the inliers, at the start of each iteration
  std::vector<double> step_size;  // root mean square displacement of the nodes in each iteration
  std::string stopped;            // why an iteration was not credible: `path` is that before it; else empty
};

// With `inertial`, the measurements between nodes hold the path as well, and its biases and gravity are estimated.
// Throws Error{cancelled}. Stops after the current iteration when asked to finish.
RefineResult refine_path(const Path& initial, const std::vector<FrameSample>& frames, const RefineSettings& settings,
                         const Run& run, InertialTerms* inertial = nullptr);

}  // namespace bole::slam
