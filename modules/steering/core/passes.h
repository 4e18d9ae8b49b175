// Stretches of a log that run along a set of parallel lines.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "steering/core/guidance_line.h"

namespace bole::steering {

// A run of samples with times; `navigated` is empty where only one position is known.
struct Track {
  std::vector<double> time_s;
  std::vector<Eigen::Vector2d> truth, navigated;
};

struct PassLimits {
  double row_width_m = 0;
  double run_in_m = 30, run_out_m = 3;
  double min_length_m = 20;
  double max_angle_rad = 0.17;
  double max_gap_s = 5;  // a longer step in time ends a pass, as a jump does: what was driven in it is unknown
};

struct Pass {
  std::size_t first = 0, last = 0;  // samples of the track, last included, between run-in and run-out
  std::int64_t row = 0;             // 0: the first line, 1: a row width to its left, ...
  int direction = 1;                // 1: from A to B
};

// Samples that move along the line's direction within the angle, cut where the way turns off for more than a second.
// Run-in and run-out are cut off.
std::vector<Pass> find_passes(const Track& track, const GuidanceLine& line, const PassLimits& limits);

// Least-squares line through the longest straight stretch, in its direction; nothing when the track has none of
// `min_length_m`.
std::optional<GuidanceLine> longest_straight(const Track& track, const PassLimits& limits);

}  // namespace bole::steering
