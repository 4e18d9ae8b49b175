#include "sim/core/field/livox_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/rosette.h"

namespace bole::sim {
namespace {

constexpr int beams = 6, rays = RayBundle::size;
constexpr double blend_m = 0.2;  // surfaces closer together in range give one return between them

// Quantiles of a standard normal for eight rays of equal energy.
constexpr std::array<double, rays> quantiles{-1.534, -0.887, -0.489, -0.157, 0.157, 0.489, 0.887, 1.534};
constexpr std::array<int, rays> shuffled{3, 6, 0, 5, 2, 7, 1, 4};

double energy(const RayHit& h) { return h.reflectivity * h.cos_incidence; }

struct Echo {
  double range_m = 0, energy = 0;
  int tree_id = 0;
};

// The run of hits with the most light, after inverse square.
Echo strongest(std::array<RayHit, rays>& hits) {
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) { return a.range_m < b.range_m; });
  Echo best;
  double best_light = 0;
  for (std::size_t first = 0; first < hits.size();) {
    std::size_t next = first;
    double sum = 0, moment = 0, peak = 0;
    int tree = 0;
    for (; next < hits.size() &&
           (next == first || hits[next].range_m - hits[next - 1].range_m < static_cast<float>(blend_m));
         ++next) {
      const double e = hits[next].range_m > 0 ? energy(hits[next]) : 0;
      sum += e;
      moment += e * static_cast<double>(hits[next].range_m);
      if (e > peak) {
        peak = e;
        tree = hits[next].tree_id;
      }
    }
    const double range = sum > 0 ? moment / sum : 0, light = sum > 0 ? sum / (range * range) : 0;
    if (light > best_light) {
      best_light = light;
      best = {range, sum / rays, tree};
    }
    first = next;
  }
  return best;
}

}  // namespace

LivoxScanner::LivoxScanner(const LivoxModel& model, double noise, const RayScene& scene, std::uint64_t seed)
    : model_(model),
      noise_(noise),
      bias_m_(noise * model.range_bias_sigma_m * Random(seed, Stream::laser_bias, 4001).bounded_normal()),
      scene_(scene),
      seed_(seed) {}

Eigen::Vector3d LivoxScanner::direction(std::int64_t n) const {
  const double half_height = 0.5 * model_.field_vertical_deg * rad_per_deg;
  const auto [azimuth, elevation] =
      rosette_angles({model_.rate_hz, beams, model_.field_horizontal_deg * rad_per_deg, -half_height, half_height}, n);
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth), std::sin(elevation)};
}

LivoxReturn LivoxScanner::fire(const Pose& T, std::int64_t n) const {
  LivoxReturn out;
  out.direction = direction(n);
  Random random(seed_, Stream::pulse, static_cast<std::uint64_t>(n));
  const Eigen::Vector3d axis = T.linear() * out.direction;
  const Eigen::Vector3d right = (T.linear() * out.direction.cross(Eigen::Vector3d::UnitZ())).normalized(),
                        up = right.cross(axis);
  // Full 1/e^2 widths are four standard deviations.
  const double kh = 0.25 * model_.divergence_horizontal_deg * rad_per_deg,
               kv = 0.25 * model_.divergence_vertical_deg * rad_per_deg;
  RayBundle bundle;
  bundle.max_range_m = static_cast<float>(model_.max_range_m);
  for (std::size_t i = 0; i < rays; ++i) {
    const double u = kh * quantiles[static_cast<std::size_t>(shuffled[i])], v = kv * quantiles[i];
    const Eigen::Vector3d d = (axis + u * right + v * up).normalized();
    for (int k = 0; k < 3; ++k) {
      bundle.origin[k][i] = static_cast<float>(T.translation()[k]);
      bundle.direction[k][i] = static_cast<float>(d[k]);
    }
  }
  std::array<RayHit, rays> hits;
  scene_.intersect(bundle, hits.data());
  const Echo echo = strongest(hits);
  const double z = random.bounded_normal(4);
  if (echo.range_m < model_.min_range_m || random.chance(model_.dropouts)) return out;
  // Weak returns scatter more: a tenth of the light of a white wall at 20 m by half again.
  const double strength = echo.energy * 400 / (echo.range_m * echo.range_m) / 0.08;
  const double sigma = noise_ * model_.range_sigma_m * std::min(1.5, std::sqrt(1 + 0.125 / strength));
  out.range_m = static_cast<float>(echo.range_m + bias_m_ + sigma * z);
  out.intensity = static_cast<float>(std::clamp(255 * echo.energy, 1.0, 255.0));
  out.tree_id = echo.tree_id;
  return out;
}

}  // namespace bole::sim
