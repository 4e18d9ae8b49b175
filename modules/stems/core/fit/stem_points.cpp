#include "stems/core/fit/stem_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace bole::stems {

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

constexpr std::size_t plenty = 300;
constexpr std::size_t points_between_polls = 256;  // where each may lie on a page of a file

Eigen::Vector3d sensor_of(const StemLayer& layer, const CloudRays& rays, std::size_t k) {
  if (rays.sensor_x) {
    const auto i = layer.index[k];
    return Eigen::Vector3d((*rays.sensor_x)[i], (*rays.sensor_y)[i], (*rays.sensor_z)[i]);
  }
  return rays.sensor[k].cast<double>();
}

struct Near {
  Eigen::Vector3d p;
  std::uint32_t k;
};

bool lies_before(const Near& a, const Near& b) {
  if (a.p.x() != b.p.x()) return a.p.x() < b.p.x();
  if (a.p.y() != b.p.y()) return a.p.y() < b.p.y();
  return a.p.z() != b.p.z() ? a.p.z() < b.p.z() : a.k < b.k;
}

// Sorts small keys in place of the points: x alone decides nearly always.
void sort_by_place(std::vector<Near>& near) {
  std::vector<std::pair<double, std::uint32_t>> order(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) order[i] = {near[i].p.x(), static_cast<std::uint32_t>(i)};
  std::ranges::sort(order, [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : lies_before(near[a.second], near[b.second]);
  });
  std::vector<Near> sorted;
  sorted.reserve(near.size());
  for (const auto& [x, i] : order) sorted.push_back(near[i]);
  near.swap(sorted);
}

// Points beyond `max_range`, where nearer ones are plenty, and their rays.
void drop_distant(std::vector<Near>& near, std::vector<Eigen::Vector3d>& ray, double max_range) {
  const auto within = static_cast<std::size_t>(
      std::ranges::count_if(ray, [&](const Eigen::Vector3d& r) { return r.norm() <= max_range; }));
  if (within < plenty) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < near.size(); ++i)
    if (!(ray[i].norm() > max_range)) near[kept] = near[i], ray[kept] = ray[i], ++kept;
  near.resize(kept), ray.resize(kept);
}

// Beams are not quite normal, and makers state their widths at levels of their own.
constexpr double beam_form_doubt = 0.1;

}  // namespace

std::vector<BarkPoint> gather_bark(const StemLayer& layer, const CloudRays& rays, const StemAxes& axes,
                                   const GatherOptions& options, const Run& run) {
  std::vector<Near> near;
  const Eigen::Vector3d up = axes.rotation.row(2).transpose();
  const double lean = up.head<2>().norm() * std::max(std::abs(options.lowest), options.highest),
               margin = std::max(0.08, 0.25 * options.radius);
  layer.for_each_near(axes.origin.x(), axes.origin.y(), options.radius + margin + lean, [&](std::uint32_t k) {
    const Eigen::Vector3d p = axes.to_stem(layer.position[k].cast<double>());
    if (p.z() < options.lowest || p.z() > options.highest ||
        p.head<2>().norm() > options.radius + options.taper * p.z() + margin)
      return;
    near.push_back({p, k});
  });
  sort_by_place(near);
  std::vector<Eigen::Vector3d> ray;
  if (rays.has_sensor()) {
    ray.reserve(near.size());
    for (const auto& n : near) {
      if (ray.size() % points_between_polls == 0 && run.cancelled()) return {};
      ray.emplace_back(layer.position[n.k].cast<double>() - sensor_of(layer, rays, n.k));
    }
    drop_distant(near, ray, options.max_range);
  }
  std::vector<BarkPoint> out;
  const std::size_t stride = near.size() / options.max_points + 1;
  out.reserve(near.size() / stride + 1);
  for (std::size_t i = 0; i < near.size(); i += stride) {
    auto& b = out.emplace_back();
    b.p = near[i].p, b.source = layer.index[near[i].k];
    if (!rays.has_sensor()) continue;
    const double range = ray[i].norm();
    if (!(range > 0.1) || !std::isfinite(range)) continue;
    b.ray = axes.rotation * ray[i] / range;
    // Full widths of laser beams are those at 1/e^2: four standard deviations.
    b.beam_sd = static_cast<float>(0.25 * (options.beam_aperture + options.beam_divergence * range));
    b.beam_doubt = static_cast<float>(std::hypot(0.25 * options.beam_doubt * range, beam_form_doubt * b.beam_sd));
  }
  return out;
}

void number_sections(std::vector<BarkPoint>& points, double step_m) {
  for (auto& p : points) p.section = static_cast<int>(std::lround(p.p.z() / step_m));
}

double section_step(const std::vector<BarkPoint>& points, double step_m, int least) {
  if (points.empty()) return step_m;
  const auto [low, high] = std::ranges::minmax(points, {}, [](const BarkPoint& p) { return p.p.z(); });
  double step = step_m;
  for (; step < 3.9 * step_m; step *= 2) {
    const long first = std::lround(low.p.z() / step);
    std::vector<int> counts(static_cast<std::size_t>(std::lround(high.p.z() / step) - first) + 1, 0);
    for (const auto& p : points) ++counts[static_cast<std::size_t>(std::lround(p.p.z() / step) - first)];
    const auto seen = std::ranges::count_if(counts, [](int n) { return n > 0; }),
               thin = std::ranges::count_if(counts, [&](int n) { return n > 0 && n < least; });
    if (2 * thin <= seen) break;
  }
  return step;
}

namespace {

// Where the times begin and begin anew after a pause longer than `gap_s`, ascending. Pauses lie between bins as wide as
// a pause: no sorting of all times.
std::vector<double> starts_of_stretches(std::vector<double> times, double gap_s) {
  constexpr double max_bins = 10000;
  std::erase_if(times, [](double t) { return !std::isfinite(t); });
  std::vector<double> starts;
  if (times.empty()) return starts;
  const auto [lowest, highest] = std::ranges::minmax(times);
  if (!(gap_s > 0) || !((highest - lowest) / gap_s < max_bins)) {
    std::ranges::sort(times);
    for (std::size_t i = 0; i < times.size(); ++i)
      if (i == 0 || times[i] - times[i - 1] > gap_s) starts.push_back(times[i]);
    return starts;
  }
  struct Bin {
    double first = std::numeric_limits<double>::infinity(), last = -first;
  };
  std::vector<Bin> bins(static_cast<std::size_t>((highest - lowest) / gap_s) + 1);
  for (const double t : times) {
    auto& bin = bins[std::min(bins.size() - 1, static_cast<std::size_t>((t - lowest) / gap_s))];
    bin.first = std::min(bin.first, t), bin.last = std::max(bin.last, t);
  }
  double last = -std::numeric_limits<double>::infinity();
  for (const auto& bin : bins) {
    if (bin.first > bin.last) continue;
    if (bin.first - last > gap_s) starts.push_back(bin.first);
    last = bin.last;
  }
  return starts;
}

}  // namespace

int number_passes(std::vector<BarkPoint>& points, const CloudRays& rays, double gap_s, bool by_cloud, const Run& run) {
  if ((!rays.time && !rays.pass) || points.empty()) return 1;
  const auto* pass = by_cloud || !rays.time ? rays.pass : nullptr;
  std::vector<double> times, starts;
  if (rays.time) {
    times.reserve(points.size());
    for (const auto& p : points) {
      if (times.size() % points_between_polls == 0 && run.cancelled()) return 1;
      times.push_back((*rays.time)[p.source]);
    }
    starts = starts_of_stretches(times, gap_s);
  }
  using Key = std::pair<std::int32_t, std::ptrdiff_t>;
  const auto key = [&](std::size_t i) {
    const auto stretch = rays.time ? std::ranges::upper_bound(starts, times[i]) - starts.begin() : std::ptrdiff_t{0};
    return Key(pass ? (*pass)[points[i].source] : 0, stretch);
  };
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % points_between_polls == 0 && run.cancelled()) return 1;
    keys.push_back(key(i));
  }
  std::vector<Key> numbered;
  for (const auto& k : keys)
    if (const auto at = std::ranges::lower_bound(numbered, k); at == numbered.end() || *at != k) numbered.insert(at, k);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].pass = static_cast<int>(std::ranges::lower_bound(numbered, keys[i]) - numbered.begin());
  return static_cast<int>(numbered.size());
}

}  // namespace bole::stems
