// A Livox Horizon: where its beams point, and what one of its pulses measures.
#pragma once

#include <cstdint>

#include "base/transform.h"
#include "sim/core/scene/ray_scene.h"

namespace bole::sim {

// Livox Horizon user manual v1.0 (2020): 81.7 x 25.1 degrees, 240 000 points/s, random range error 2 cm (1 sigma at
// 20 m, 80 % reflectivity), divergence 0.28 x 0.03 degrees (vertical, horizontal), no returns below 0.5 m.
struct LivoxModel {
  double field_horizontal_deg = 81.7, field_vertical_deg = 25.1;
  double rate_hz = 240'000;
  double range_sigma_m = 0.02, range_bias_sigma_m = 0.005;  // the bias is constant over a recording
  double min_range_m = 0.5, max_range_m = 60;
  double divergence_horizontal_deg = 0.03, divergence_vertical_deg = 0.28;
  double dropouts = 0.004;
};

struct LivoxReturn {
  float range_m = 0;  // 0: none
  float intensity = 0;
  int tree_id = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  // in sensor axes: x right, y ahead, z up
};

class LivoxScanner {
 public:
  LivoxScanner(const LivoxModel& model, double noise, const RayScene& scene, std::uint64_t seed);

  // Direction of pulse `n` in sensor axes (rosette.h).
  Eigen::Vector3d direction(std::int64_t n) const;

  // The strongest return of pulse `n` fired from a pose. Same arguments, same return.
  LivoxReturn fire(const Pose& T_nav_sensor, std::int64_t n) const;

  const LivoxModel& model() const { return model_; }

 private:
  LivoxModel model_;
  double noise_, bias_m_;
  const RayScene& scene_;
  std::uint64_t seed_;
};

}  // namespace bole::sim
