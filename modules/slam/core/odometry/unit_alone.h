// What the inertial unit carries by itself where the surroundings leave a motion open.
#pragma once

#include <algorithm>
#include <vector>

#include "base/angles.h"
#include "slam/core/odometry/odometry.h"

namespace bole::slam {

// By how far the place may be off after so many seconds, beside what the filter knows of it. The filter takes the local
// map for exact, but its level drifts as it grows, and with it gravity pulls the sensor along. The error of the level
// is a guess: two simulated walks over bare ground had 0.05 deg.
inline double astray_m(double alone_s) {
  constexpr double gravity_m_s2 = 9.81, level_error_rad = radians(0.06);
  return 0.5 * gravity_m_s2 * level_error_rad * alone_s * alone_s;
}

// Frames in a row that tell all motions end such a stretch; fewer do so by chance.
inline constexpr int frames_that_hold = 4;

// Seconds from the last frames that told all motions, before frame `end`, to `until_s`.
inline double seconds_alone(const std::vector<TrackedFrame>& frames, std::size_t end, double until_s) {
  int in_a_row = 0;
  double last_s = 0;
  for (std::size_t k = end; k-- > 0;) {
    const bool holds = frames[k].ok && !frames[k].bridged;
    in_a_row = holds ? in_a_row + 1 : 0;
    if (in_a_row == 1) last_s = frames[k].end_s;
    if (in_a_row == frames_that_hold) return std::max(0.0, until_s - last_s);
  }
  return frames.empty() ? 0 : std::max(0.0, until_s - frames.front().end_s);
}

}  // namespace bole::slam
