#include "ground/core/height_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/statistics.h"
#include "cloud/core/height_facts.h"

namespace bole::ground {
namespace {

constexpr double place_m = 2.0;    // one low point of each place counts
constexpr double block_m = 8.0;    // places whose median must lie at 0 together
constexpr double exact_m = 0.001;  // as ground points of normalised clouds lie at 0
constexpr double min_exact_share = 0.05;
constexpr double max_foot_m = 0.15;   // feet are seen less sharply: bark, grass
constexpr double max_below_m = 0.30;  // lower points are strays
constexpr double max_stray_share = 0.001;
constexpr std::size_t min_feet = 5;
constexpr double min_extent_m = 4.0;
constexpr double max_below_share = 1e-4;  // of clouds that end at z = 0
constexpr double wide_m = 30.0;           // no ground is level over such an extent
constexpr std::size_t min_places = 4;

double share(std::size_t part, std::size_t of) {
  return of == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(of);
}

std::pair<int, int> square_of(const Eigen::Vector3d& p, double size_m) {
  return {static_cast<int>(std::floor(p.x() / size_m)), static_cast<int>(std::floor(p.y() / size_m))};
}

// Share of the blocks, of those with three points or more, where `rank` of the points lies at 0.
double level_share(const std::vector<Eigen::Vector3d>& points, double rank, double tolerance) {
  std::map<std::pair<int, int>, std::vector<double>> by_block;
  for (const auto& p : points) by_block[square_of(p, block_m)].push_back(p.z());
  std::size_t blocks = 0, level = 0;
  for (auto& [block, heights] : by_block) {
    if (heights.size() < 3) continue;
    const auto at = heights.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), at, heights.end());
    ++blocks;
    level += std::abs(*at) <= tolerance ? 1 : 0;
  }
  return blocks == 0 ? 1.0 : share(level, blocks);
}

double extent(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector2d low = points.front().head<2>(), high = low;
  for (const auto& p : points) {
    low = low.cwiseMin(p.head<2>());
    high = high.cwiseMax(p.head<2>());
  }
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
    const auto [it, fresh] = lowest.try_emplace(square_of(c.position, place_m), c.position);
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

// Ground points at z = 0 to the millimetre and nothing below: no terrain that was measured is like that.
bool ground_at_zero(const PointCloud& cloud) {
  std::size_t zero = 0, below = 0;
  for (const auto& p : cloud.positions()) {
    const double z = static_cast<double>(p.z()) + cloud.origin.z();
    zero += std::abs(z) <= exact_m ? 1 : 0;
    below += z < -exact_m ? 1 : 0;
  }
  return share(zero, cloud.size()) >= min_exact_share && share(below, cloud.size()) <= max_stray_share;
}

// Level ground that ends at z = 0 and nothing below, over an extent on which no measured ground is level.
bool ends_at_zero(const PointCloud& cloud, const std::vector<Eigen::Vector3d>& places) {
  return extent(places) >= wide_m && share(count_below(cloud, -exact_m), cloud.size()) <= max_below_share &&
         level_share(places, 0, max_foot_m) >= 0.9;
}

// Whether the cloud ends below as if cut with a knife: as many points in its lowest centimetre as 5 cm above. Ground
// has a tail of noise and relief below, or, where it has none, most of its points in that centimetre.
struct LowerEdge {
  double z = 0;
  bool sharp = false;
};

LowerEdge lower_edge(const PointCloud& cloud) {
  std::vector<float> z;
  for (const auto& p : cloud.positions())
    if (p.allFinite()) z.push_back(p.z());
  LowerEdge out;
  if (z.empty()) return out;
  const auto rank = z.begin() + static_cast<std::ptrdiff_t>(z.size() / 10000);
  std::nth_element(z.begin(), rank, z.end());
  const double lowest = static_cast<double>(*rank);
  const auto count = [&](double low) {
    return static_cast<double>(std::count_if(z.begin(), z.end(), [&](float at) {
      return static_cast<double>(at) >= lowest + low && static_cast<double>(at) < lowest + low + 0.01;
    }));
  };
  const double first = count(0), above = count(0.05);
  out.z = lowest + cloud.origin.z();
  out.sharp = first >= 0.5 * above && first <= 3 * above && above > 0;
  return out;
}

// Of the places without a foot, how many hold something within 0.2 m of `level`.
double low_share(const Evidence& seen, double level) {
  std::size_t bare = 0, low = 0;
  for (const auto& p : seen.places) {
    if (std::any_of(seen.feet.begin(), seen.feet.end(),
                    [&](const auto& f) { return (f - p).template head<2>().norm() < 0.6; }))
      continue;
    ++bare;
    low += p.z() < level + 0.2 ? 1 : 0;
  }
  return share(low, bare);
}

bool feet_at_zero(const std::vector<Eigen::Vector3d>& feet) {
  return feet.size() >= min_feet && extent(feet) >= min_extent_m &&
         share(count_within(feet, -max_foot_m, max_foot_m), feet.size()) >= 0.8 &&
         level_share(feet, 0.5, max_foot_m) == 1;
}

// Most feet stand on the edge itself.
bool cut_level(const Evidence& seen, const LowerEdge& edge, HeightReference& out) {
  if (!edge.sharp || seen.feet.size() < min_feet || extent(seen.feet) < min_extent_m) return false;
  if (share(count_within(seen.feet, edge.z - 0.05, edge.z + max_foot_m), seen.feet.size()) < 0.6) return false;
  out.level_cut = true;
  out.cut_z = edge.z;
  return true;
}

}  // namespace

HeightReference height_reference(const PointCloud& cloud, const std::vector<LowPoint>& candidates,
                                 const std::vector<UprightColumn>& columns) {
  HeightReference out;
  if (fact_text(cloud.facts, facts::height_reference) == "ground") {
    out.above_ground = true;
    out.evidence = "the cloud says so (height_reference)";
    return out;
  }
  if (fact_text(cloud.facts, facts::poses)) return out;
  const auto seen = gather(cloud, candidates, columns);
  if (seen.places.size() < min_places) return out;
  const bool nothing_below =
      static_cast<double>(count_below(cloud, -max_below_m)) <= max_stray_share * static_cast<double>(cloud.size());
  const auto edge = lower_edge(cloud);
  const bool ground_seen = !edge.sharp && low_share(seen, 0) > 0.3;
  if (ground_at_zero(cloud)) {
    out.above_ground = true;
    out.evidence = "its ground points lie at z = 0 exactly";
  } else if (ends_at_zero(cloud, seen.places)) {
    out.above_ground = true;
    out.evidence = "its ground is level all over and ends at z = 0";
  } else if (nothing_below && !ground_seen && feet_at_zero(seen.feet)) {
    out.above_ground = true;
    out.evidence = fmt::format("{} of {} upright structures begin within {:.2f} m of z = 0",
                               count_within(seen.feet, -max_foot_m, max_foot_m), seen.feet.size(), max_foot_m);
  } else {
    cut_level(seen, edge, out);
  }
  return out;
}

}  // namespace bole::ground
