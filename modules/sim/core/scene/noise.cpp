#include "sim/core/scene/noise.h"

#include <cmath>
#include <numbers>

#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }
double lerp(double a, double b, double t) { return a + t * (b - a); }

// Dot product of the corner's random unit gradient with the offset from the corner.
double corner(std::int64_t ix, std::int64_t iy, double dx, double dy, std::uint64_t seed) {
  const std::uint64_t h = mix64(mix64(seed ^ static_cast<std::uint64_t>(ix)) ^ static_cast<std::uint64_t>(iy));
  const double angle = static_cast<double>(h >> 11) * 0x1.0p-53 * 2 * std::numbers::pi;
  return std::cos(angle) * dx + std::sin(angle) * dy;
}

std::uint32_t mix32(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352Du;
  x ^= x >> 15;
  x *= 0x846CA68Bu;
  return x ^ (x >> 16);
}

float lattice(std::int32_t ix, std::int32_t iy, std::int32_t iz, std::uint32_t seed) {
  const std::uint32_t h =
      mix32(seed ^ (static_cast<std::uint32_t>(ix) * 0x8DA6B343u + static_cast<std::uint32_t>(iy) * 0xD8163841u +
                    static_cast<std::uint32_t>(iz) * 0xCB1AB31Fu));
  return static_cast<float>(h >> 8) * 0x1.0p-24f;
}

}  // namespace

double gradient_noise(double x, double y, std::uint64_t seed) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const double dx = x - fx, dy = y - fy, u = fade(dx), v = fade(dy);
  return lerp(lerp(corner(ix, iy, dx, dy, seed), corner(ix + 1, iy, dx - 1, dy, seed), u),
              lerp(corner(ix, iy + 1, dx, dy - 1, seed), corner(ix + 1, iy + 1, dx - 1, dy - 1, seed), u), v);
}

double fractal_noise(double x, double y, int octaves, double gain, std::uint64_t seed) {
  double sum = 0, height = 1, scale = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += height * gradient_noise(x * scale, y * scale, seed + static_cast<std::uint64_t>(i));
    height *= gain;
    scale *= 2;
  }
  return sum;
}

float value_noise(float x, float y, float z, std::uint32_t seed) {
  const float fx = std::floor(x), fy = std::floor(y), fz = std::floor(z);
  const auto ix = static_cast<std::int32_t>(fx), iy = static_cast<std::int32_t>(fy), iz = static_cast<std::int32_t>(fz);
  const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
  const float u = smooth(x - fx), v = smooth(y - fy), w = smooth(z - fz);
  const auto edge = [&](std::int32_t jy, std::int32_t jz) {
    const float a = lattice(ix, jy, jz, seed), b = lattice(ix + 1, jy, jz, seed);
    return a + u * (b - a);
  };
  const auto face = [&](std::int32_t jz) {
    const float a = edge(iy, jz), b = edge(iy + 1, jz);
    return a + v * (b - a);
  };
  const float a = face(iz), b = face(iz + 1);
  return a + w * (b - a);
}

}  // namespace bole::sim
