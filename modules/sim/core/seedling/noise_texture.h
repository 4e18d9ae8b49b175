// A tile of noise that is looked up instead of computed: pictures need it millions of times.
#pragma once

#include <cstdint>
#include <vector>

namespace bole::sim {

// Fractal value noise on a torus, mean 0 and standard deviation 1, with coarser copies for far surfaces.
class NoiseTexture {
 public:
  // Octaves of 4, 8, ... up to `finest` cells over the tile, each `gain` times as high as the one before.
  NoiseTexture(std::uint64_t seed, int finest, double gain);

  // At (u, v) in tiles, as the mean over about `footprint` tiles.
  float at(float u, float v, float footprint) const;

 private:
  struct Level {
    int size = 0;
    std::vector<float> values;
  };
  std::vector<Level> levels_;  // each half as large as the one before
};

}  // namespace bole::sim
