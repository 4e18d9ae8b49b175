// A picture of the ground, and where it lies in a scene.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace bole::render {

// Red, green, blue and alpha; the first row is the northernmost.
struct GroundPicture {
  int width = 0, height = 0;       // px
  std::vector<std::uint8_t> rgba;  // 4 x width x height
};

// Each pixel is the mean of `step` x `step`, or fewer at the borders; what is transparent does not count.
GroundPicture coarser(const GroundPicture& picture, int step);

using GroundCorners = std::array<Eigen::Vector2d, 4>;  // north-west, north-east, south-east, south-west; metres

// Where a picture lies: columns x rows of places in world coordinates, evenly over the picture, the northernmost row
// first.
struct GroundPlaces {
  int columns = 0, rows = 0;  // at least two of each
  std::vector<Eigen::Vector3d> at;
  bool behind_all = true;  // whatever is in the scene is drawn before it: points below its plane are seen too
};
GroundPlaces flat_ground(const GroundCorners& corners, double z);

}  // namespace bole::render
