#include "stems/core/ground_check.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/statistics.h"
#include "cloud/core/height_facts.h"
#include "cloud/point_cloud.h"
#include "stems/core/tree/tree_axis.h"

namespace bole::stems {
namespace {

constexpr double look_around_m = 1.0;  // beside the bark: ground as near as this tells where the foot is
constexpr double bark_m = 0.08;        // points as near to the surface are bark
constexpr double lowest_m = -3.0;      // of the heights that are looked at
constexpr double bin_m = 0.1;
constexpr std::size_t bins = 60;         // from lowest_m upwards
constexpr std::size_t max_gap_bins = 3;  // of the bark, down from the lowest section
constexpr double max_depth_m = 0.30;     // of bark below the terrain
constexpr double max_start_m = 0.50;     // of bark above a terrain that was not seen
constexpr double ground_m = 0.15;        // a point as near to the terrain is ground, in a cloud without classes
constexpr int min_ground_points = 5;
constexpr double foot_m = 0.15;     // of the heights where a stem that is whole widens
constexpr double min_flare = 0.12;  // of the radius
constexpr double tile_m = 2.0;

// What the cloud shows about one foot.
struct Foot {
  int ground_points = 0;  // beside the stem
  std::array<int, bins> bark{};
  std::vector<double> at_foot;  // of the lowest points: distances from the axis, up to two radii

  void add(const Foot& o) {
    ground_points += o.ground_points;
    for (std::size_t b = 0; b < bins; ++b) bark[b] += o.bark[b];
    at_foot.insert(at_foot.end(), o.at_foot.begin(), o.at_foot.end());
  }
};

class FeetFinder {
 public:
  FeetFinder(const std::vector<Stem>& stems, const PointCloud& points) : points_(points) {
    for (std::size_t k = 0; k < stems.size(); ++k) {
      axes_.emplace_back(stems[k]);
      const Eigen::Vector2d at = axes_.back().at(stems[k].ground_z);
      const double reach = stems[k].radius + look_around_m;
      for (int ty = tile(at.y() - reach); ty <= tile(at.y() + reach); ++ty)
        for (int tx = tile(at.x() - reach); tx <= tile(at.x() + reach); ++tx) stems_at_[{tx, ty}].push_back(k);
    }
  }

  std::vector<Foot> find(const Run& run) const {
    const auto& height = points_.values<float>(arrays::height_above_ground);
    const auto* classes =
        points_.has(arrays::classification) ? &points_.values<std::uint8_t>(arrays::classification) : nullptr;
    tbb::enumerable_thread_specific<std::vector<Foot>> seen([&] { return std::vector<Foot>(axes_.size()); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points_.size(), 1 << 17), [&](const auto& range) {
      run.check_cancel();
      auto& feet = seen.local();
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const auto h = static_cast<double>(height[i]);
        if (!(h >= lowest_m && h < lowest_m + bin_m * bins)) continue;
        const bool ground = classes ? (*classes)[i] == 2 : std::abs(h) <= ground_m;
        look(points_.positions()[i].cast<double>(), h, ground, feet);
      }
    });
    std::vector<Foot> feet(axes_.size());
    for (const auto& part : seen)
      for (std::size_t k = 0; k < feet.size(); ++k) feet[k].add(part[k]);
    return feet;
  }

 private:
  static int tile(double x) { return static_cast<int>(std::floor(x / tile_m)); }

  void look(const Eigen::Vector3d& p, double h, bool ground, std::vector<Foot>& feet) const {
    const auto it = stems_at_.find({tile(p.x()), tile(p.y())});
    if (it == stems_at_.end()) return;
    for (const auto k : it->second) {
      const double beside = (p.head<2>() - axes_[k].at(p.z())).norm() - axes_[k].radius;
      if (h >= 0 && h < foot_m && beside < axes_[k].radius) feet[k].at_foot.push_back(beside + axes_[k].radius);
      if (std::abs(beside) <= bark_m)
        ++feet[k].bark[std::min(bins - 1, static_cast<std::size_t>((h - lowest_m) / bin_m))];
      else if (ground && beside > 0 && beside <= look_around_m)
        ++feet[k].ground_points;
    }
  }

  std::vector<TreeAxis> axes_;
  const PointCloud& points_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> stems_at_;
};

// Where the bark ends below the lowest section that was fitted, height above the terrain. A bin counts when it holds a
// tenth of what those of the fitted stem hold.
double bark_begins(const Foot& foot, const Stem& stem) {
  const auto bin = [](double h) {
    return static_cast<std::size_t>(std::clamp((h - lowest_m) / bin_m, 0.0, static_cast<double>(bins - 1)));
  };
  const std::size_t top = bin(std::max(stem.lowest, 0.0)), high = std::min(bins, bin(stem.highest) + 1);
  double usual = 0;
  for (std::size_t b = top; b < high; ++b) usual += foot.bark[b];
  usual /= static_cast<double>(std::max<std::size_t>(1, high - top));
  const int enough = std::max(2, static_cast<int>(0.1 * usual));
  std::size_t lowest = top, gap = 0;
  for (std::size_t b = top; b-- > 0 && gap <= max_gap_bins;) {
    if (foot.bark[b] >= enough)
      lowest = b, gap = 0;
    else
      ++gap;
  }
  return lowest_m + bin_m * static_cast<double>(lowest);
}

// A stem widens at its foot, and soil lies beside it. One that was cut off higher up does neither.
bool shows_foot(const Foot& foot, const Stem& stem, double breast_height_m) {
  if (foot.at_foot.size() < static_cast<std::size_t>(min_ground_points)) return false;
  const double expected = stem.radius + std::max(0.0, -stem.taper) * breast_height_m;
  return upper_median(std::vector<double>(foot.at_foot)) > (1 + min_flare) * expected;
}

enum class Fault { none, below, in_air, filled, no_foot };

void lower(Stem& s, int steps, Reason reason) {
  s.reasons.push_back(std::move(reason));
  if (steps == 1 && s.quality == "good") {
    s.quality = "fair";
  } else {
    s.quality = "poor";
    s.state = "check";
  }
}

Fault check_foot(Stem& s, const Foot& foot, double breast_height_m, bool of_lowest_points) {
  if (of_lowest_points) {
    if (foot.ground_points >= min_ground_points || shows_foot(foot, s, breast_height_m)) return Fault::none;
    lower(s, 1, {StemReason::foot_not_seen});
    return Fault::no_foot;
  }
  const double begins = bark_begins(foot, s);
  if (begins < -max_depth_m) {
    lower(s, 2, {StemReason::below_terrain, {-begins, breast_height_m}});
    return Fault::below;
  }
  if (foot.ground_points >= min_ground_points) return Fault::none;
  if (begins > max_start_m) {
    lower(s, 2, {StemReason::above_unseen_terrain, {begins}});
    return Fault::in_air;
  }
  lower(s, 1, {StemReason::no_ground_near, {look_around_m}});
  return Fault::filled;
}

constexpr float layer_m = 0.1F, above_m = 0.3F, top_m = 1.3F;  // the terrain, and what stands on it
constexpr double layers_above = 5;                             // from above_m to top_m, each 2 layer_m thick

struct Layers {
  std::size_t at_terrain = 0, above = 0;
  void add(float h) {
    at_terrain += std::abs(h) < layer_m;
    above += h >= above_m && h < top_m;
  }
  // How much denser points lie at the terrain than above it, layer for layer.
  double contrast() const { return static_cast<double>(at_terrain) * layers_above / static_cast<double>(above); }
};

// Of the cells of 1 m with points enough, the share where ground stands out.
double cells_with_ground(const PointCloud& points, const std::vector<float>& heights, const Run& run) {
  constexpr std::size_t min_points = 20;
  constexpr double stands_out = 2;
  std::unordered_map<std::int64_t, Layers> cells;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % (std::size_t{1} << 20) == 0) run.check_cancel();
    const auto& p = points.positions()[i];
    if (heights[i] > -layer_m && heights[i] < top_m)
      cells[(static_cast<std::int64_t>(std::floor(p.y())) << 32) + static_cast<std::int64_t>(std::floor(p.x()))].add(
          heights[i]);
  }
  std::size_t known = 0, clear = 0;
  for (const auto& [place, cell] : cells)
    if (cell.at_terrain + cell.above >= min_points) ++known, clear += cell.above == 0 || cell.contrast() > stands_out;
  return known > 0 ? static_cast<double>(clear) / static_cast<double>(known) : 1;
}

// Ground that was seen has 10 times as many points as what stands on it, and more, also under shrubs. Where a cloud was
// cut above the ground its lowest points are twigs, grass and bark like those above them. Bark can be dense where
// ground is not: the cells tell that apart.
void judge_contrast(std::size_t stems, const PointCloud& points, const Run& run, Report& report) {
  constexpr double no_ground = 2, doubtful = 3, max_share_of_cells = 0.5;
  constexpr std::size_t min_stems = 3, min_above = 1000;
  const auto& heights = points.values<float>(arrays::height_above_ground);
  Layers all;
  for (const float h : heights) all.add(h);
  if (stems < min_stems || all.above < min_above || all.contrast() >= doubtful) return;
  if (cells_with_ground(points, heights, run) > max_share_of_cells) return;
  report.find(
      all.contrast() < no_ground ? Severity::refused : Severity::look, "ground_no_surface",
      fmt::format(
          "points lie only {:.1f} times as dense at the terrain as 0.3 to 1.3 m above it (ground that was seen: "
          "10 times and more): the cloud was cut above the ground, or the ground was hardly seen. Breast height "
          "of all {} stems is a guess. Give the cloud with its ground, or set ground.method=normalised if z is "
          "the height above ground",
          all.contrast(), stems));
}

}  // namespace

void check_ground(std::vector<Stem>& stems, const PointCloud& points, double breast_height_m, const Run& run,
                  Report& report) {
  if (stems.empty()) return;
  const auto feet = FeetFinder(stems, points).find(run);
  // Heights above z = 0 need no ground, and without the fact nobody looked for it.
  const auto terrain = fact_text(points.facts, facts::terrain);
  const bool feet_alone = terrain == choice_name(TerrainSource::feet);
  const bool needs_ground = feet_alone || terrain == choice_name(TerrainSource::ground);
  const bool of_lowest_points = terrain == choice_name(TerrainSource::lowest);
  if (terrain == choice_name(TerrainSource::ground)) judge_contrast(stems.size(), points, run, report);
  std::map<Fault, std::size_t> found;
  for (std::size_t k = 0; k < stems.size(); ++k) {
    Foot foot = feet[k];
    if (!needs_ground && !of_lowest_points) foot.ground_points = min_ground_points;
    ++found[check_foot(stems[k], foot, breast_height_m, of_lowest_points)];
  }
  const auto tell = [&](Fault fault, Severity most, const char* code, const char* words, const char* remedy) {
    const auto n = found[fault];
    report.counts[code] = static_cast<std::int64_t>(n);
    if (n == 0) return;
    const bool refused = most == Severity::refused && 2 * n >= stems.size();
    report.find(refused ? Severity::refused : Severity::look, code,
                fmt::format("{} of {} stems {}: {}", n, stems.size(), words, remedy));
  };
  tell(
      Fault::below, Severity::refused, "points_below_terrain", "go on well below the terrain",
      "the terrain is not the ground there, breast height is too high. Set ground.method=normalised if z is the height "
      "above ground, else lower ground.max_slope or give the cloud with its ground");
  tell(Fault::in_air, Severity::refused, "stems_begin_in_air", "begin in the air and no ground was seen below them",
       "breast height is uncertain. Give the cloud with its ground, or scan from more sides");
  tell(Fault::no_foot, Severity::look, "foot_not_seen",
       "do not widen at the lowest points of the cloud, and no ground lies there",
       "heights count from those points. If feet are missing, breast height is too high and the diameter too small. "
       "Give the tree with some ground around it");
  // Between seen ground a terrain can be filled in. Where feet are all there is, nobody knows what is missing of them.
  tell(Fault::filled, feet_alone ? Severity::refused : Severity::look, "terrain_filled_under_stems",
       "stand where no ground was seen within 1 m",
       feet_alone
           ? "breast height counts from where these stems begin in the cloud, which may be above the ground. Give "
             "the cloud with its ground, or set ground.method=normalised if z is the height above ground"
           : "breast height hangs on an interpolated terrain. Compare the heights of these feet with the plot");
}

}  // namespace bole::stems
