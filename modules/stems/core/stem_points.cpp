#include "stems/core/stem_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace bole {

StemAxes::StemAxes(const Eigen::Vector3d& at, const Eigen::Vector3d& direction, double ground)
    : origin(at), rotation(rotation_between(direction, Eigen::Vector3d::UnitZ())), ground_z(ground) {}

double ground_around(const Raster& dem, const Eigen::Vector3d& cloud_origin, const Eigen::Vector2d& base, double radius,
                     bool uphill) {
  constexpr int directions = 16;
  double highest = -std::numeric_limits<double>::infinity(), sum = 0;
  int n = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    const double z = dem.sample(cloud_origin.x() + base.x() + radius * std::cos(angle),
                                cloud_origin.y() + base.y() + radius * std::sin(angle)) -
                     cloud_origin.z();
    if (std::isfinite(z)) highest = std::max(highest, z), sum += z, ++n;
  }
  if (n == 0) return std::numeric_limits<double>::quiet_NaN();
  return uphill ? highest : sum / n;
}

namespace {

constexpr std::size_t most_points = 40000;
constexpr std::size_t plenty = 300;

Eigen::Vector3d sensor_of(const StemLayer& layer, const CloudRays& rays, std::size_t k) {
  if (rays.sensor_x) {
    const auto i = layer.index[k];
    return Eigen::Vector3d((*rays.sensor_x)[i], (*rays.sensor_y)[i], (*rays.sensor_z)[i]);
  }
  return rays.sensor[k].cast<double>();
}

}  // namespace

std::vector<BarkPoint> gather_bark(const StemLayer& layer, const CloudRays& rays, const StemAxes& axes,
                                   const GatherOptions& options) {
  struct Near {
    BarkPoint point;
    double range;
  };
  std::vector<Near> near;
  const Eigen::Vector3d up = axes.rotation.row(2).transpose();
  const double lean = up.head<2>().norm() * std::max(std::abs(options.lowest), options.highest),
               margin = std::max(0.08, 0.25 * options.radius);
  layer.for_each_near(axes.origin.x(), axes.origin.y(), options.radius + margin + lean, [&](std::uint32_t k) {
    const Eigen::Vector3d in_cloud = layer.position[k].cast<double>(), p = axes.to_stem(in_cloud);
    if (p.z() < options.lowest || p.z() > options.highest ||
        p.head<2>().norm() > options.radius + options.taper * p.z() + margin)
      return;
    BarkPoint b;
    b.p = p, b.source = layer.index[k];
    double range = 0;
    if (rays.has_sensor()) {
      const Eigen::Vector3d ray = in_cloud - sensor_of(layer, rays, k);
      range = ray.norm();
      if (range > 0.1 && std::isfinite(range)) {
        b.ray = axes.rotation * ray / range;
        // Full widths of laser beams are those at 1/e^2: four standard deviations.
        b.beam_sd = static_cast<float>(0.25 * (options.beam_aperture + options.beam_divergence * range));
      }
    }
    near.push_back({b, range});
  });
  std::ranges::sort(near, [](const Near& a, const Near& b) {
    return std::lexicographical_compare(a.point.p.data(), a.point.p.data() + 3, b.point.p.data(), b.point.p.data() + 3);
  });
  const auto within = static_cast<std::size_t>(
      std::ranges::count_if(near, [&](const Near& n) { return n.range <= options.max_range; }));
  if (within >= plenty) std::erase_if(near, [&](const Near& n) { return n.range > options.max_range; });
  std::vector<BarkPoint> out;
  const std::size_t stride = near.size() / most_points + 1;
  for (std::size_t i = 0; i < near.size(); i += stride) out.push_back(near[i].point);
  return out;
}

void number_sections(std::vector<BarkPoint>& points, double step_m) {
  for (auto& p : points) p.section = static_cast<int>(std::lround(p.p.z() / step_m));
}

double section_step(const std::vector<BarkPoint>& points, double step_m, int least) {
  double step = step_m;
  for (; step < 3.9 * step_m; step *= 2) {
    std::map<long, int> counts;
    for (const auto& p : points) ++counts[std::lround(p.p.z() / step)];
    const auto thin = std::ranges::count_if(counts, [&](const auto& c) { return c.second < least; });
    if (2 * thin <= static_cast<std::ptrdiff_t>(counts.size())) break;
  }
  return step;
}

int number_passes(std::vector<BarkPoint>& points, const CloudRays& rays, double gap_s, bool by_cloud) {
  if (!rays.time && !rays.pass) return 1;
  const auto* pass = by_cloud || !rays.time ? rays.pass : nullptr;
  std::vector<double> starts;
  if (rays.time) {
    std::vector<double> times;
    for (const auto& p : points) times.push_back((*rays.time)[p.source]);
    std::ranges::sort(times);
    for (std::size_t i = 0; i < times.size(); ++i)
      if (i == 0 || times[i] - times[i - 1] > gap_s) starts.push_back(times[i]);
  }
  const auto key = [&](const BarkPoint& p) {
    const auto stretch =
        rays.time ? std::ranges::upper_bound(starts, (*rays.time)[p.source]) - starts.begin() : std::ptrdiff_t{0};
    return std::pair(pass ? (*pass)[p.source] : 0, stretch);
  };
  std::map<std::pair<std::int32_t, std::ptrdiff_t>, int> numbers;
  for (const auto& p : points) numbers.emplace(key(p), 0);
  int next = 0;
  for (auto& [k, number] : numbers) number = next++;
  for (auto& p : points) p.pass = numbers[key(p)];
  return std::max(1, next);
}

}  // namespace bole
