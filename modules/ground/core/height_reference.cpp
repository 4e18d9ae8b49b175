#include "ground/core/height_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/statistics.h"
#include "cloud/height_facts.h"

namespace bole::ground {
namespace {

constexpr double place_m = 2.0;        // one low point of each place counts
constexpr double block_m = 8.0;        // places whose median must lie at 0 together
constexpr double max_block_m = 0.04;   // median of a block of ground
constexpr double max_ground_m = 0.10;  // of nine places in ten
constexpr double max_foot_m = 0.15;    // feet are seen less sharply: bark, grass
constexpr double max_below_m = 0.30;   // lower points are strays
constexpr double max_stray_share = 0.001;
constexpr std::size_t min_places = 12;
constexpr std::size_t min_feet = 5;
constexpr double min_extent_m = 4.0;

double share(std::size_t part, std::size_t of) {
  return of == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
}

template <class Points, class Position>
std::map<std::pair<int, int>, std::vector<double>> heights_by_block(const Points& points, double size,
                                                                    const Position& position) {
  std::map<std::pair<int, int>, std::vector<double>> out;
  for (const auto& p : points) {
    const Eigen::Vector3d at = position(p);
    out[{static_cast<int>(std::floor(at.x() / size)), static_cast<int>(std::floor(at.y() / size))}].push_back(at.z());
  }
  return out;
}

bool all_blocks_level(const std::vector<Eigen::Vector3d>& points, double level, double tolerance) {
  for (const auto& [block, heights] : heights_by_block(points, block_m, [](const auto& p) { return p; }))
    if (heights.size() >= 3 && std::abs(upper_median(std::vector<double>(heights)) - level) > tolerance) return false;
  return true;
}

double extent(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector2d low = points.front().head<2>(), high = low;
  for (const auto& p : points) low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
  return (high - low).maxCoeff();
}

std::size_t count_within(const std::vector<Eigen::Vector3d>& points, double low, double high) {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.z() >= low && p.z() <= high; }));
}

struct Evidence {
  std::vector<Eigen::Vector3d> places;  // the lowest candidate of each
  std::vector<Eigen::Vector3d> feet;    // of upright structures
};

Evidence gather(const PointCloud& cloud, const std::vector<LowPoint>& candidates,
                const std::vector<UprightColumn>& columns) {
  Evidence out;
  const Eigen::Vector3d lift(0, 0, cloud.origin.z());
  std::map<std::pair<int, int>, Eigen::Vector3d> lowest;
  for (const auto& c : candidates) {
    const std::pair key(static_cast<int>(std::floor(c.position.x() / place_m)),
                        static_cast<int>(std::floor(c.position.y() / place_m)));
    const auto [it, fresh] = lowest.try_emplace(key, c.position);
    if (!fresh && c.position.z() < it->second.z()) it->second = c.position;
  }
  for (const auto& [key, p] : lowest) out.places.push_back(p + lift);
  for (const auto& c : columns) out.feet.push_back(c.foot + lift);
  return out;
}

std::size_t count_below(const PointCloud& cloud, double z) {
  std::size_t n = 0;
  for (const auto& p : cloud.positions()) n += static_cast<double>(p.z()) + cloud.origin.z() < z ? 1 : 0;
  return n;
}

bool ground_at_zero(const std::vector<Eigen::Vector3d>& places) {
  return places.size() >= min_places && extent(places) >= min_extent_m &&
         share(count_within(places, -max_ground_m, max_ground_m), places.size()) >= 0.9 &&
         all_blocks_level(places, 0, max_block_m);
}

bool feet_at_zero(const std::vector<Eigen::Vector3d>& feet) {
  return feet.size() >= min_feet && extent(feet) >= min_extent_m &&
         share(count_within(feet, -max_foot_m, max_foot_m), feet.size()) >= 0.8 &&
         all_blocks_level(feet, 0, max_foot_m);
}

// Feet within 5 cm of one level, and few places beside them that hold anything as low.
bool cut_level(const Evidence& seen, HeightReference& out) {
  if (seen.feet.size() < min_feet || extent(seen.feet) < min_extent_m) return false;
  std::vector<double> z;
  for (const auto& f : seen.feet) z.push_back(f.z());
  const double level = upper_median(z);
  if (share(count_within(seen.feet, level - 0.05, level + 0.05), seen.feet.size()) < 0.8) return false;
  std::size_t bare = 0, low = 0;
  for (const auto& p : seen.places) {
    if (std::any_of(seen.feet.begin(), seen.feet.end(),
                    [&](const auto& f) { return (f - p).template head<2>().norm() < 0.6; }))
      continue;
    ++bare;
    low += p.z() < level + 0.2 ? 1 : 0;
  }
  if (bare < min_feet || share(low, bare) > 0.3) return false;
  out.level_cut = true, out.cut_z = level;
  return true;
}

}  // namespace

HeightReference height_reference(const PointCloud& cloud, const std::vector<LowPoint>& candidates,
                                 const std::vector<UprightColumn>& columns) {
  HeightReference out;
  if (fact_text(cloud.facts, facts::height_reference) == "ground") {
    out.above_ground = true, out.evidence = "the cloud says so (height_reference)";
    return out;
  }
  if (fact_text(cloud.facts, facts::poses)) return out;
  const auto seen = gather(cloud, candidates, columns);
  const bool nothing_below =
      static_cast<double>(count_below(cloud, -max_below_m)) <= max_stray_share * static_cast<double>(cloud.size());
  if (nothing_below && ground_at_zero(seen.places)) {
    out.above_ground = true;
    out.evidence = fmt::format("the ground lies within {:.2f} m of z = 0 in {:.0f} % of {} places", max_ground_m,
                               100 * share(count_within(seen.places, -max_ground_m, max_ground_m), seen.places.size()),
                               seen.places.size());
  } else if (nothing_below && feet_at_zero(seen.feet)) {
    out.above_ground = true;
    out.evidence = fmt::format("{} of {} upright structures begin within {:.2f} m of z = 0",
                               count_within(seen.feet, -max_foot_m, max_foot_m), seen.feet.size(), max_foot_m);
  } else {
    cut_level(seen, out);
  }
  return out;
}

}  // namespace bole::ground
