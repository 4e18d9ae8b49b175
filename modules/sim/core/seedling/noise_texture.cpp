#include "sim/core/seedling/noise_texture.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/random.h"

namespace bole::sim {
namespace {

constexpr int finest_level = 512;

float lattice(std::uint64_t seed, int cells, int x, int y) {
  const int at = (y & (cells - 1)) * cells + (x & (cells - 1));
  const auto key = static_cast<std::uint64_t>(at);
  return static_cast<float>(
      static_cast<double>(mix64(seed ^ mix64(key + (static_cast<std::uint64_t>(cells) << 32))) >> 40) * 0x1.0p-23 - 1);
}

float smooth_step(float t) { return t * t * (3 - 2 * t); }

}  // namespace

NoiseTexture::NoiseTexture(std::uint64_t seed, int finest, double gain) {
  Level base{finest_level, std::vector<float>(static_cast<std::size_t>(finest_level) * finest_level, 0.0F)};
  double height = 1;
  for (int cells = 4; cells <= std::min(finest, finest_level / 2); cells *= 2, height *= gain) {
    const int width = finest_level / cells;
    for (int y = 0; y < finest_level; ++y)
      for (int x = 0; x < finest_level; ++x) {
        const int i = x / width, j = y / width;
        const float s = smooth_step((static_cast<float>(x % width) + 0.5F) / static_cast<float>(width));
        const float t = smooth_step((static_cast<float>(y % width) + 0.5F) / static_cast<float>(width));
        const float low = (1 - s) * lattice(seed, cells, i, j) + s * lattice(seed, cells, i + 1, j);
        const float high = (1 - s) * lattice(seed, cells, i, j + 1) + s * lattice(seed, cells, i + 1, j + 1);
        base.values[static_cast<std::size_t>(y) * finest_level + static_cast<std::size_t>(x)] +=
            static_cast<float>(height) * ((1 - t) * low + t * high);
      }
  }
  double sum = 0, squares = 0;
  for (const float v : base.values) sum += v, squares += static_cast<double>(v) * v;
  const double mean = sum / static_cast<double>(base.values.size());
  const double sd = std::sqrt(squares / static_cast<double>(base.values.size()) - mean * mean);
  for (float& v : base.values) v = static_cast<float>((v - mean) / sd);
  levels_.push_back(std::move(base));
  while (levels_.back().size > 4) {
    const Level& fine = levels_.back();
    Level coarse{fine.size / 2, {}};
    for (int y = 0; y < coarse.size; ++y)
      for (int x = 0; x < coarse.size; ++x) {
        const auto at = [&](int i, int j) {
          const int k = j * fine.size + i;
          return fine.values[static_cast<std::size_t>(k)];
        };
        coarse.values.push_back(
            0.25F * (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1)));
      }
    levels_.push_back(std::move(coarse));
  }
}

float NoiseTexture::at(float u, float v, float footprint) const {
  const float pixels = std::max(footprint, 0.0F) * finest_level;
  // ilogb is the whole part of the logarithm: no level is finer than the footprint by more than a factor of two.
  const int wanted = pixels >= 2 ? std::ilogb(pixels) : 0;
  const Level& level = levels_[static_cast<std::size_t>(std::min(wanted, static_cast<int>(levels_.size()) - 1))];
  const float x = u * static_cast<float>(level.size) - 0.5F, y = v * static_cast<float>(level.size) - 0.5F;
  const float fx = std::floor(x), fy = std::floor(y), s = x - fx, t = y - fy;
  const int mask = level.size - 1;
  const int i = static_cast<int>(fx) & mask, j = static_cast<int>(fy) & mask, k = (i + 1) & mask, l = (j + 1) & mask;
  const auto value = [&](int a, int b) {
    const int at = b * level.size + a;
    return level.values[static_cast<std::size_t>(at)];
  };
  return (1 - t) * ((1 - s) * value(i, j) + s * value(k, j)) + t * ((1 - s) * value(i, l) + s * value(k, l));
}

}  // namespace bole::sim
