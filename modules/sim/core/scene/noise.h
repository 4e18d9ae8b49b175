// Smooth noise: the shape of ground, bark and slow hand motions.
#pragma once

#include <cstdint>

namespace bole::sim {

// Gradient noise (Perlin, Improving noise, SIGGRAPH 2002) with quintic fade: C2, zero mean, about -0.7 .. 0.7, feature
// size 1.
double gradient_noise(double x, double y, std::uint64_t seed);

// Sum of `octaves` of gradient noise, each of half the size and `gain` times the height of the one before.
double fractal_noise(double x, double y, int octaves, double gain, std::uint64_t seed);

// Value noise in three dimensions, in [0, 1], feature size 1.
float value_noise(float x, float y, float z, std::uint32_t seed);

}  // namespace bole::sim
