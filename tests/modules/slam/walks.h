// A short walk among trunks, and how far a trajectory is from the truth.
#pragma once

#include <algorithm>

#include "slam/core/slam.h"
#include "synthetic/scan_world.h"

namespace bole::slam {

inline synthetic::SyntheticScan small_walk(std::size_t frames, double noise_m = 0.01) {
  auto sensor = synthetic::SpinningSensor::even(32, -25, 15, 360);
  sensor.range_noise_m = noise_m;
  return {synthetic::trunks(9, 3.5), sensor, [](double t) { return synthetic::walk_on_circle(t, 4, 1, 1, 0.3); },
          frames};
}

inline SlamOptions with_preset(Preset preset) {
  SlamOptions o;
  o.preset = preset;
  o.map_voxel = 0.03;
  return o;
}

// Largest distance of the estimated from the true positions, the first poses laid on each other.
template <class Scan>
double worst_m(const Trajectory& estimate, const Scan& source) {
  const Pose T_truth_map =
      source.truth(estimate.poses.front().time_s) * estimate.poses.front().T_target_sensor.inverse();
  double worst = 0;
  for (const auto& p : estimate.poses)
    worst = std::max(worst,
                     ((T_truth_map * p.T_target_sensor).translation() - source.truth(p.time_s).translation()).norm());
  return worst;
}

}  // namespace bole::slam
