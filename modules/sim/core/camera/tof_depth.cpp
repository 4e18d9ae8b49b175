#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/random.h"
#include "sim/core/camera/depth_sensor.h"

namespace bole::sim {
namespace {

constexpr double phase_per_metre = 4 * std::numbers::pi * 80e6 / 299'792'458;
constexpr int rays_per_side = 3;
constexpr double usual_amplitude = 1.6;             // of a surface that sends back 0.4 at 0.5 m
constexpr double weakest = 0.02, min_unity = 0.45;  // shares of the amplitude below which there is no depth

}  // namespace

DepthImage tof_depth(const PictureScene& scene, const SurfaceColors& colors, const PixelDirections& pixels,
                     const ViewPose& view, double noise, std::uint64_t seed) {
  const auto& camera = pixels.camera();
  DepthImage out(camera.width, camera.height);
  const std::size_t count = out.values.size();
  std::vector<std::complex<double>> waves(count);
  std::vector<double> amplitudes(count, 0.0), first(count, 0.0);
  for (int j = 0; j < rays_per_side; ++j)
    for (int i = 0; i < rays_per_side; ++i) {
      const Eigen::Vector2f shift((i + 0.5F) / rays_per_side - 0.5F, (j + 0.5F) / rays_per_side - 0.5F);
      const auto exact = render_depth(scene, pixels, view, std::vector<Eigen::Vector2f>(count, shift), &colors);
      for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
          const auto k = out.index(x, y);
          const double z = static_cast<double>(exact.depth.values[k]);
          if (z <= 0) continue;
          const double range = z * pixels.at(x, y).norm();
          const double weight =
              static_cast<double>(exact.reflected.values[k] * exact.cosine.values[k]) / (range * range);
          if (first[k] == 0) first[k] = range;
          waves[k] += std::polar(weight, phase_per_metre * (range - first[k]));
          amplitudes[k] += weight;
        }
    }
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const auto k = out.index(x, y);
      const double wave = std::abs(waves[k]), share = wave / (rays_per_side * rays_per_side * usual_amplitude);
      if (amplitudes[k] <= 0 || share < weakest || wave < min_unity * amplitudes[k]) continue;
      const double sd = noise * 0.0009 / std::sqrt(share);
      const double range = first[k] + std::arg(waves[k]) / phase_per_metre +
                           sd * static_cast<double>(quick_normal(mix64(seed ^ mix64(k))));
      if (range > 0.05) out.values[k] = static_cast<float>(range / pixels.at(x, y).norm());
    }
  return out;
}

}  // namespace bole::sim
