#include "sim/core/scene/beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "sensor/core/spinning_beams.h"
#include "sim/core/scene/noise.h"

namespace bole::sim {
namespace {

constexpr int rays = RayBundle::size;

// Eight rays of equal energy that sample a Gaussian beam of unit standard deviation (a sunflower over its quantiles).
std::array<Eigen::Vector2d, rays> gaussian_pattern() {
  std::array<Eigen::Vector2d, rays> pattern;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < rays; ++i) {
    const double r = std::sqrt(-2 * std::log(1 - (i + 0.5) / rays)), a = i * golden;
    pattern[static_cast<std::size_t>(i)] = r * Eigen::Vector2d(std::cos(a), std::sin(a));
  }
  return pattern;
}

// A foil sends this many times more light back than a white wall.
constexpr double retro_gain = 30;

double energy(const RayHit& hit) {
  return hit.material == Material::retro ? retro_gain : hit.reflectivity * hit.cos_incidence;
}

// Depth of the bark at a point, 0 (ridge) to 1 (fissure): stretched along the stem.
double bark_relief(const Eigen::Vector3d& p, int tree_id) {
  const float n = value_noise(static_cast<float>(p.x() / 0.015), static_cast<float>(p.y() / 0.015),
                              static_cast<float>(p.z() / 0.07), static_cast<std::uint32_t>(tree_id));
  return n * n;
}

// The same where the bark breaks into plates: each some 2 cm wide and 7 cm high, as deep as it likes.
double bark_facet(const Eigen::Vector3d& p, int tree_id) {
  const auto cell = [](double v, double size) { return static_cast<float>(std::floor(v / size)); };
  return value_noise(cell(p.x(), 0.02), cell(p.y(), 0.02), cell(p.z(), 0.07), static_cast<std::uint32_t>(tree_id));
}

// Grazing surfaces draw an echo out in time, and a beam that mostly misses gives a faint one.
double growth_of_noise(double cos_incidence, double share) {
  return std::max(1 - cos_incidence, 1 - std::min(1.0, 2 * share));
}

}  // namespace

Beam::Beam(const sensor::SensorModel& sensor, const BeamParameters& parameters, const RayScene& scene,
           std::uint64_t seed)
    : sensor_(sensor), parameters_(parameters), scene_(scene), seed_(seed) {
  const std::size_t count = sensor.rosette ? static_cast<std::size_t>(sensor.rosette->beams) : sensor.channels.size();
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed, Stream::calibration, i);
    const double error = parameters.angle_error_rad, elevation_error = error * random.bounded_normal(),
                 azimuth_error = error * random.bounded_normal();
    const double elevation = (sensor.rosette ? 0 : sensor.channels[i].elevation_rad) + elevation_error;
    const auto offsets = sensor.rosette ? sensor::LaserOffsets{} : sensor.channels[i].offsets;
    if (offsets.two_points)
      throw bad_input("the calibration of the sensor " + sensor.name + " corrects ranges at two distances",
                      "a sensor without such a correction: the simulator does not have it");
    const double bias_m =
        parameters.noise * parameters.laser_bias_m * Random(seed, Stream::laser_bias, i).bounded_normal();
    // The sensor reports ranges that its calibration still has to correct.
    lasers_.push_back({std::cos(elevation), std::sin(elevation), bias_m - offsets.range, elevation_error, azimuth_error,
                       elevation, offsets, offsets != sensor::LaserOffsets{}});
  }
}

Beam::Returns Beam::returns_of(const RayHit hits[rays]) const {
  std::array<int, rays> order{};
  int count = 0;
  for (int i = 0; i < rays; ++i)
    if (hits[i].range_m > 0) order[static_cast<std::size_t>(count++)] = i;
  std::sort(order.begin(), order.begin() + count, [&](int a, int b) { return hits[a].range_m < hits[b].range_m; });
  Returns returns;
  double best_energy = 0;
  for (int first = 0; first < count;) {
    // A run of surfaces without a gap longer than the pulse is one return.
    double sum = 0, moment = 0, brightness = 0, retro = 0, bark = 0, cosine = 0;
    int next = first;
    float previous = hits[order[static_cast<std::size_t>(first)]].range_m;
    for (; next < count; ++next) {
      const RayHit& hit = hits[order[static_cast<std::size_t>(next)]];
      if (hit.range_m - previous > parameters_.pulse_length_m) break;
      previous = hit.range_m;
      const double e = energy(hit);
      sum += e;
      moment += e * hit.range_m;
      bark += e * hit.bark_depth_m;
      cosine += e * hit.cos_incidence;
      if (hit.material == Material::retro)
        retro += 1;
      else
        brightness += hit.reflectivity * std::sqrt(hit.cos_incidence);
    }
    const double range = sum > 0 ? moment / sum : 0;
    if (sum > 0) {
      const double light = sum / (range * range);
      if (light > best_energy) {
        best_energy = light;
        returns.strongest = returns.count;
      }
      returns.list[returns.count++] = {range,
                                       light / rays,
                                       brightness / rays,
                                       retro / rays,
                                       bark / sum,
                                       cosine / sum,
                                       static_cast<double>(next - first) / rays};
    }
    first = next;
  }
  return returns;
}

std::uint8_t Beam::intensity(const Return& r, Random& random) const {
  const double speckle = 1 + 0.06 * random.bounded_normal();
  if (r.retro_share > 0)
    return static_cast<std::uint8_t>(std::clamp((100 + 140 * std::pow(r.retro_share, 0.7)) * speckle, 60.0, 255.0));
  return static_cast<std::uint8_t>(std::clamp(100 * r.brightness / (1 + r.range_m / 120) * speckle, 1.0, 100.0));
}

// Water fills the pores and darkens all but foil, and its film sends grazing light away.
void Beam::soak(RayHit& hit) const {
  const auto darker = [&](double share) {
    const double film = std::pow(std::max(0.02, static_cast<double>(hit.cos_incidence)), 0.7 * parameters_.wet);
    hit.reflectivity *= static_cast<float>((1 - share * parameters_.wet) * film);
  };
  switch (hit.material) {
    case Material::bark:
    case Material::wood:
      darker(0.5);
      break;
    case Material::leaf:
    case Material::grass:
      darker(0.35);
      break;
    case Material::ground:
    case Material::rock:
      darker(0.45);
      break;
    case Material::pole:
    case Material::retro:
      break;
  }
}

// Drops on leaves and bark turn a share of the light aside.
bool Beam::lost_in_water(const RayHit hits[rays], std::uint64_t pulse) const {
  double plants = 0;
  for (int i = 0; i < rays; ++i) {
    const bool plant = hits[i].material == Material::bark || hits[i].material == Material::wood ||
                       hits[i].material == Material::leaf || hits[i].material == Material::grass;
    plants += hits[i].range_m > 0 && plant;
  }
  return Random(seed_, Stream::wet, pulse).chance(0.1 * parameters_.wet * plants / rays);
}

RayBundle Beam::rays_of(const Pose& T, const Shot& shot, const Eigen::Vector3d& axis, double spin) const {
  static const auto pattern = gaussian_pattern();
  const double ca = std::cos(shot.azimuth_rad), sa = std::sin(shot.azimuth_rad);
  const Eigen::Vector3d right = T.linear() * Eigen::Vector3d(-sa, -ca, 0), up = right.cross(axis);
  // A full 1/e^2 width is four standard deviations.
  const double k = 0.25 * parameters_.divergence, cs = std::cos(spin), ss = std::sin(spin);
  RayBundle bundle;
  bundle.max_range_m = static_cast<float>(sensor_.max_range_m);
  for (int i = 0; i < rays; ++i) {
    const auto& p = pattern[static_cast<std::size_t>(i)];
    const double u = k * (cs * p.x() - ss * p.y()), v = k * (ss * p.x() + cs * p.y());
    const Eigen::Vector3d origin =
        T.translation() + u * sensor_.aperture_horizontal_m * right + v * sensor_.aperture_vertical_m * up;
    const Eigen::Vector3d direction =
        (axis + u * sensor_.beam_divergence_horizontal_rad * right + v * sensor_.beam_divergence_vertical_rad * up)
            .normalized();
    for (int d = 0; d < 3; ++d) {
      bundle.origin[d][i] = static_cast<float>(origin[d]);
      bundle.direction[d][i] = static_cast<float>(direction[d]);
    }
  }
  return bundle;
}

sensor::LaserEcho Beam::echo_of(Return r, const RayHit hits[rays], const Eigen::Vector3d& origin,
                                const Eigen::Vector3d& axis, double bias_m, Random& random) const {
  if (r.range_m < sensor_.min_range_m || random.chance(parameters_.dropouts)) return {};
  // A tenth of the light from half the greatest range is seen every second time.
  const double faintest = 0.1 / (0.25 * sensor_.max_range_m * sensor_.max_range_m), strength = r.signal / faintest;
  if (!random.chance(strength * strength / (1 + strength * strength))) return {};
  if (parameters_.bark && r.bark_depth_m > 0) {
    int tree = 0;
    for (int i = 0; i < rays; ++i)
      if (hits[i].bark_depth_m > 0) tree = hits[i].tree_id;
    const Eigen::Vector3d at = origin + r.range_m * axis;
    const double relief = parameters_.bark_facets ? bark_facet(at, tree) : bark_relief(at, tree);
    r.range_m += r.bark_depth_m * relief / std::max(0.25, r.cos_incidence);
  }
  const double sigma = parameters_.noise * sensor_.range_sigma_m * std::min(2.5, std::sqrt(1 + 1 / strength)) *
                       (1 + parameters_.noise_growth * growth_of_noise(r.cos_incidence, r.share));
  const double range = r.range_m + bias_m + sigma * random.bounded_normal(4);
  return {static_cast<float>(range), intensity(r, random)};
}

Echoes Beam::measure(const Pose& T_plot_sensor, const Shot& shot, std::uint64_t pulse, double time_s) const {
  Pose T = T_plot_sensor;  // of the laser
  T.translation() += T.linear() * shot.origin;
  Random random(seed_, Stream::pulse, pulse);
  const double ce = shot.cos_elevation;
  const Eigen::Vector3d axis = T.linear() * Eigen::Vector3d(ce * std::cos(shot.azimuth_rad),
                                                            -ce * std::sin(shot.azimuth_rad), shot.sin_elevation);
  RayBundle bundle = rays_of(T, shot, axis, random.angle());
  bundle.time_s = time_s;
  RayHit hits[rays];
  scene_.intersect(bundle, hits);
  if (parameters_.wet > 0) {
    for (auto& hit : hits) soak(hit);
    if (lost_in_water(hits, pulse)) return {};
  }
  const Returns returns = returns_of(hits);
  const Return& best = returns.count > 0 ? returns.list[returns.strongest] : Return{};
  Echoes echoes{echo_of(best, hits, T.translation(), axis, shot.bias_m, random), {}};
  if (!parameters_.dual) return echoes;
  echoes.last = echoes.strongest;
  if (returns.count < 2) return echoes;
  // The last return, or the second strongest where the last is the strongest.
  const std::size_t last = returns.count - 1;
  const bool strongest_is_last = returns.strongest == last && !parameters_.by_strength;
  std::size_t other = last;
  if (parameters_.by_strength || returns.strongest == last) {
    other = returns.strongest == 0 ? 1 : 0;
    for (std::size_t i = 0; i < returns.count; ++i)
      if (i != returns.strongest && returns.list[i].signal > returns.list[other].signal) other = i;
  }
  Random second_random(seed_, Stream::second_return, pulse);
  const auto second = echo_of(returns.list[other], hits, T.translation(), axis, shot.bias_m, second_random);
  if (!(second.range_m > 0)) return echoes;
  if (!(echoes.strongest.range_m > 0)) return {second, second};
  (strongest_is_last ? echoes.strongest : echoes.last) = second;
  return echoes;
}

Echoes Beam::fire(const Pose& T, std::size_t channel, double azimuth_rad, std::uint64_t pulse, double time_s) const {
  const Laser& laser = lasers_[channel];
  const double azimuth = azimuth_rad + laser.azimuth_error_rad;
  return measure(
      T,
      {laser.cos_elevation, laser.sin_elevation, azimuth, laser.bias_m,
       laser.off_centre ? sensor::laser_origin(laser.offsets, azimuth, laser.elevation_rad) : Eigen::Vector3d::Zero()},
      pulse, time_s);
}

sensor::LaserEcho Beam::fire(const Pose& T, std::size_t channel, double azimuth_rad, std::uint64_t pulse) const {
  return fire(T, channel, azimuth_rad, pulse, 0).strongest;
}

Echoes Beam::fire(const Pose& T, std::size_t laser_index, const Aim& aim, std::uint64_t pulse, double time_s) const {
  const Laser& laser = lasers_[laser_index];
  const double elevation = aim.elevation_rad + laser.elevation_error_rad;
  return measure(T, {std::cos(elevation), std::sin(elevation), aim.azimuth_rad + laser.azimuth_error_rad, laser.bias_m},
                 pulse, time_s);
}

}  // namespace bole::sim
