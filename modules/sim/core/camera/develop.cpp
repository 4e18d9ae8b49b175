#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "sim/core/camera/picture.h"

namespace bole::sim {
namespace {

constexpr int curve_steps = 4096;  // between them the curve is straight enough for 8 bits

float srgb_of_linear(float v) { return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F; }

std::vector<float> response(bool straight) {
  std::vector<float> curve;
  for (int i = 0; i <= curve_steps; ++i) {
    const float v = static_cast<float>(i) / curve_steps;
    curve.push_back(255 * (straight ? v : srgb_of_linear(v)));
  }
  return curve;
}

void develop_into(const Image<float>& light, double exposure, const SensorNoise& noise, std::uint64_t seed,
                  const std::vector<float>& curve, Image<std::uint8_t>& out) {
  const auto factor = static_cast<float>(exposure), shot = static_cast<float>(noise.shot),
             read = static_cast<float>(noise.read);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, light.values.size(), 1 << 14), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const float value = factor * light.values[i];
      const float sd = std::sqrt(shot * shot * std::max(0.0F, value) + read * read);
      const float noisy = std::clamp(value + sd * quick_normal(mix64(seed ^ mix64(i))), 0.0F, 1.0F) * curve_steps;
      const int k = std::min(static_cast<int>(noisy), curve_steps - 1);
      const float s = noisy - static_cast<float>(k);
      const auto at = static_cast<std::size_t>(k);
      out.values[i] = static_cast<std::uint8_t>(std::lround((1 - s) * curve[at] + s * curve[at + 1]));
    }
  });
}

}  // namespace

ColorImage develop(const Image<float>& light, double exposure, const SensorNoise& noise, std::uint64_t seed) {
  static const auto curve = response(false);
  ColorImage out(light.width, light.height, 3);
  develop_into(light, exposure, noise, seed, curve, out);
  return out;
}

Image<std::uint8_t> develop_infrared(const Image<float>& light, double exposure, const SensorNoise& noise,
                                     std::uint64_t seed) {
  static const auto curve = response(true);
  Image<std::uint8_t> out(light.width, light.height, 1);
  develop_into(light, exposure, noise, seed, curve, out);
  return out;
}

}  // namespace bole::sim
