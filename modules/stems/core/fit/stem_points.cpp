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

struct Gathered {
  Eigen::Vector3d p;  // stem axes
  std::size_t i;      // of the points near the stem
};

bool lies_before(const Gathered& a, const Gathered& b) {
  if (a.p.x() != b.p.x()) return a.p.x() < b.p.x();
  if (a.p.y() != b.p.y()) return a.p.y() < b.p.y();
  return a.p.z() != b.p.z() ? a.p.z() < b.p.z() : a.i < b.i;
}

// Stripes of a few points each are quicker to sort than all.
std::vector<Gathered> sorted_by_place(const std::vector<Gathered>& points) {
  if (points.empty()) return {};
  const auto [low, high] = std::ranges::minmax(points, {}, [](const Gathered& a) { return a.p.x(); });
  const std::size_t stripes = points.size() / 8 + 1;
  const double first = low.p.x(), by_width = static_cast<double>(stripes) / std::max(1e-9, high.p.x() - first);
  const auto stripe_of = [&](const Gathered& a) {
    return std::min(stripes - 1, static_cast<std::size_t>((a.p.x() - first) * by_width));
  };
  std::vector<std::uint32_t> start(stripes + 1, 0);
  for (const auto& a : points) ++start[stripe_of(a) + 1];
  for (std::size_t s = 0; s < stripes; ++s) start[s + 1] += start[s];
  std::vector<Gathered> sorted(points.size());
  auto next = start;
  for (const auto& a : points) sorted[next[stripe_of(a)]++] = a;
  for (std::size_t s = 0; s < stripes; ++s)
    std::sort(sorted.begin() + start[s], sorted.begin() + start[s + 1], lies_before);
  return sorted;
}

// Points beyond `max_range`, where nearer ones are plenty.
void drop_distant(std::vector<Gathered>& points, const NearPoints& near, double max_range) {
  const auto within = std::ranges::count_if(points, [&](const Gathered& g) { return near[g.i].range <= max_range; });
  if (static_cast<std::size_t>(within) < plenty) return;
  std::erase_if(points, [&](const Gathered& g) { return near[g.i].range > max_range; });
}

// The map does not say which of the places about a ray it came from.
void blur(BarkPoint& b, double blur_m, double doubt_m) {
  const double beam = b.beam_sd, total = std::hypot(beam, blur_m);
  b.beam_doubt = static_cast<float>(std::hypot(beam / total * b.beam_doubt, blur_m / total * doubt_m));
  b.beam_sd = static_cast<float>(total), b.scattered = static_cast<float>(blur_m * blur_m / (total * total));
}

// Beams are not quite normal, and makers state their widths at levels of their own.
constexpr double beam_form_doubt = 0.1;

}  // namespace

std::vector<BarkPoint> gather_bark(NearPoints& near, const StemAxes& axes, const GatherOptions& options,
                                   const Run& run) {
  const double margin = std::max(0.08, 0.25 * options.radius);
  const auto reach_at = [&](double z) { return options.radius + options.taper * z + margin; };
  near.cover({axes.to_cloud({0, 0, options.lowest}), axes.to_cloud({0, 0, options.highest}), reach_at(options.lowest),
              reach_at(options.highest)},
             run);
  std::vector<Gathered> gathered;
  gathered.reserve(near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Eigen::Vector3d p = axes.to_stem(near[i].p);
    if (p.z() < options.lowest || p.z() > options.highest || p.head<2>().norm() > reach_at(p.z())) continue;
    gathered.push_back({p, i});
  }
  gathered = sorted_by_place(gathered);
  const bool rays = near.rays().has_sensor();
  if (rays) drop_distant(gathered, near, options.max_range);
  std::vector<BarkPoint> out;
  const std::size_t stride = gathered.size() / options.max_points + 1;
  out.reserve(gathered.size() / stride + 1);
  for (std::size_t i = 0; i < gathered.size(); i += stride) {
    auto& b = out.emplace_back();
    const auto& [p, ray, range, time, pass] = near[gathered[i].i];
    b.p = gathered[i].p, b.time = time, b.cloud_pass = pass;
    if (!rays || !(range > 0.1) || !std::isfinite(range)) continue;
    b.ray = axes.rotation * ray / range, b.range = static_cast<float>(range);
    // Full widths of laser beams are those at 1/e^2: four standard deviations.
    b.beam_sd = static_cast<float>(0.25 * (options.beam_aperture + options.beam_divergence * range));
    b.beam_doubt = static_cast<float>(std::hypot(0.25 * options.beam_doubt * range, beam_form_doubt * b.beam_sd));
    if (options.blur > 0) blur(b, options.blur, options.blur_doubt);
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

int number_passes(std::vector<BarkPoint>& points, const CloudRays& rays, double gap_s, bool by_cloud) {
  if ((!rays.time && !rays.pass) || points.empty()) return 1;
  const bool with_pass = rays.pass && (by_cloud || !rays.time);
  std::vector<double> starts;
  if (rays.time) {
    std::vector<double> times;
    times.reserve(points.size());
    for (const auto& p : points) times.push_back(p.time);
    starts = starts_of_stretches(std::move(times), gap_s);
  }
  using Key = std::pair<std::int32_t, std::ptrdiff_t>;
  std::vector<Key> keys;
  keys.reserve(points.size());
  for (const auto& p : points) {
    const auto stretch = rays.time ? std::ranges::upper_bound(starts, p.time) - starts.begin() : std::ptrdiff_t{0};
    keys.emplace_back(with_pass ? p.cloud_pass : 0, stretch);
  }
  std::vector<Key> numbered;
  for (const auto& k : keys)
    if (const auto at = std::ranges::lower_bound(numbered, k); at == numbered.end() || *at != k) numbered.insert(at, k);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].pass = static_cast<int>(std::ranges::lower_bound(numbered, keys[i]) - numbered.begin());
  return static_cast<int>(numbered.size());
}

}  // namespace bole::stems
