// The random numbers of the simulator: a stream for each purpose.
#pragma once

#include "base/random.h"

namespace bole::sim {

using bole::mix64;

// What a stream of numbers is for. New purposes go at the end, so that old ones keep their numbers.
enum class Stream : std::uint64_t {
  layout = 1,
  diameters,
  stem,
  branches,
  leaves,
  terrain,
  clutter,
  targets,
  walk,
  pulse,
  laser_bias,
  archetype,
  disturbance,
  vineyard,
  imu,
  // Of the harder stands and of the physics of the scan.
  stand = 32,
  poles,
  deadwood,
  wind,
  operator_body,
  wet,
  second_return,
  calibration,
  clock,
  // Of seedlings before a camera.
  seedling = 64,
  seedling_leaves,
  surroundings,
  texture,
  camera_route,
  picture,
  depth_sensor,
  sway
};

class Random : public bole::Random {
 public:
  Random(std::uint64_t seed, Stream stream, std::uint64_t counter = 0)
      : bole::Random(seed, static_cast<std::uint64_t>(stream), counter) {}
};

}  // namespace bole::sim
