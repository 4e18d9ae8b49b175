#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/statistics.h"
#include "stems/core/tree/tree_axis.h"
#include "stems/core/tree/tree_ends.h"

namespace bole::stems {
namespace {

constexpr double low_end_m = 3;                   // below this a stem that ends is no tree that was measured
constexpr double end_in_diameters = 10;           // nor where it is so thick for its height ...
constexpr double highest_low_end_m = 6;           // ... up to here
constexpr double band_m = 0.1;                    // height of the bands that bark is counted in
constexpr std::size_t bands = StemColumn::bands;  // from the ground upwards
constexpr double off_bark_m = 0.08;               // so near to the surface, or inside, is the stem
constexpr double open_around_m = 0.25;            // what must be empty above it
constexpr double open_from_m = 0.2, open_to_m = 2.0;
constexpr double open_share = 0.05;       // of the points per band on the bark
constexpr double end_share = 0.3;         // likewise: thinner, and the stem has ended
constexpr std::size_t max_gap_bands = 3;  // that something hides
constexpr double ragged_m = 0.3;  // where a scanner did not see higher, returns become fewer over more than this
constexpr double usual_from_m = 0.5, usual_to_m = 1.5;
constexpr int min_points_per_band = 4;
constexpr double around_m = 15, higher_by_m = 1.5;
constexpr double column_tile_m = 2.0;

using Column = StemColumn;

std::vector<Column> columns_of(const std::vector<Stem>& stems, const PointCloud& points, const Run& run) {
  std::vector<Column> columns(stems.size());
  std::vector<TreeAxis> axes;
  std::map<std::pair<int, int>, std::vector<std::size_t>> stems_at;
  const auto tile = [](double x) { return static_cast<int>(std::floor(x / column_tile_m)); };
  for (std::size_t k = 0; k < stems.size(); ++k) {
    axes.emplace_back(stems[k]);
    const Eigen::Vector2d low = axes[k].at(stems[k].ground_z), high = axes[k].at(stems[k].ground_z + bands * band_m);
    const double reach = stems[k].radius + open_around_m;
    for (int ty = tile(std::min(low.y(), high.y()) - reach); ty <= tile(std::max(low.y(), high.y()) + reach); ++ty)
      for (int tx = tile(std::min(low.x(), high.x()) - reach); tx <= tile(std::max(low.x(), high.x()) + reach); ++tx)
        stems_at[{tx, ty}].push_back(k);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto& point = points.positions()[i];
    if (!point.allFinite()) continue;
    const Eigen::Vector3d p = point.cast<double>();
    const auto it = stems_at.find({tile(p.x()), tile(p.y())});
    if (it == stems_at.end()) continue;
    for (const auto k : it->second) {
      const double h = p.z() - stems[k].ground_z;
      if (!(h >= 0 && h < bands * band_m)) continue;
      const double beside = (p.head<2>() - axes[k].at(p.z())).norm() - stems[k].radius;
      const auto band = std::min(bands - 1, static_cast<std::size_t>(h / band_m));
      columns[k].bark[band] += beside <= off_bark_m;
      columns[k].inside[band] += beside <= open_around_m;
    }
  }
  return columns;
}

std::size_t band_at(double height_m) { return std::min(bands, static_cast<std::size_t>(height_m / band_m)); }

// Height at which the bark of a stem ends below open space; nothing where it does not end low, or where something
// stands above that may hide the rest.
std::optional<double> open_end_m(const Stem& s, const Column& column) {
  std::vector<double> lower;
  for (std::size_t b = band_at(usual_from_m); b < band_at(usual_to_m); ++b) lower.push_back(column.bark[b]);
  const double usual = upper_median(std::move(lower));
  if (usual < min_points_per_band) return std::nullopt;
  const std::size_t first = band_at(usual_from_m);
  std::size_t last = first, gap = 0;
  for (std::size_t b = first; b < bands && gap <= max_gap_bands; ++b) {
    gap = column.bark[b] >= end_share * usual ? 0 : gap + 1;
    if (gap == 0) last = b;
  }
  const double end = static_cast<double>(last + 1) * band_m;
  if (end >= std::max(low_end_m, std::min(end_in_diameters * 2 * s.radius, highest_low_end_m))) return std::nullopt;
  double above = 0;
  for (std::size_t b = band_at(end + open_from_m); b < band_at(end + open_to_m); ++b) above += column.inside[b];
  return above <= open_share * usual * (open_to_m - open_from_m) / band_m ? std::optional(end) : std::nullopt;
}

bool others_go_on(const std::vector<Stem>& stems, const std::vector<double>& height_m, std::size_t k, double end) {
  int others = 0, higher = 0;
  for (std::size_t j = 0; j < stems.size(); ++j) {
    if (j == k || (stems[j].breast_height - stems[k].breast_height).head<2>().norm() > around_m) continue;
    ++others;
    higher += height_m[j] > end + higher_by_m;
  }
  return higher > 0 && 2 * higher >= others;
}

}  // namespace

LowEnds::LowEnds(const std::vector<Stem>& stems, const PointCloud& points, const Run& run)
    : columns_(columns_of(stems, points, run)) {}

void LowEnds::judge(std::vector<Stem>& stems, const std::vector<double>& height_m) const {
  for (std::size_t k = 0; k < stems.size(); ++k) {
    const auto end = open_end_m(stems[k], columns_[k]);
    if (!end || height_m[k] > *end + ragged_m || !others_go_on(stems, height_m, k, *end)) continue;
    stems[k].reasons.push_back({StemReason::ends_low, {*end}});
    stems[k].quality = "poor";
    stems[k].state = "check";
  }
}

}  // namespace bole::stems
