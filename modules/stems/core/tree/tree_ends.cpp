#include "stems/core/tree/tree_ends.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/statistics.h"
#include "stems/core/tree/tree_axis.h"

namespace bole::stems {
namespace {

// No stem narrows from its last measured diameter to nothing within fewer diameters: the thickest tips have 18.
constexpr double min_diameters_to_top = 10;

// Slices of a tree below its highest point. Crowns narrow upwards, and so do the points in them.
constexpr double tip_slice_m = 0.3, below_from_m = 0.5, below_to_m = 1.5;
constexpr std::uint32_t min_points_below = 30;
constexpr double blunt_width = 0.6, blunt_density = 0.5;  // of the slice below, per metre of height

// What certainly is a tip, whatever a circle fitted to branches says of the stem.
constexpr double tip_density = 0.3, tip_width = 0.5, crown_in_radii = 3;

// Of all trees together.
constexpr double level_step_m = 0.1;
constexpr int tip_steps = 3, below_steps = 10;
constexpr std::uint32_t min_points_at_cut = 100;
constexpr double max_share_above = 0.01, cut_density = 0.5;
constexpr double ends_at_cut_m = 0.5;    // a tree that ends so near to the cut speaks for it ...
constexpr double hidden_by_cut_m = 1.0;  // ... and one that ends so near may go on
constexpr int min_ends_at_cut = 3;

constexpr double neighbours_m = 15, like_neighbours_m = 1;
constexpr int min_stopped_neighbours = 3;

// Horizontal scatter of the points of a slice.
struct Slice {
  std::uint32_t points = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double squares = 0;
  void add(const Eigen::Vector2d& p) {
    ++points;
    sum += p;
    squares += p.squaredNorm();
  }
  double width() const {
    return points == 0 ? 0 : std::sqrt(std::max(0.0, squares / points - (sum / points).squaredNorm()));
  }
};

struct TipShape {
  Slice tip, below;
  double density() const { return tip.points / tip_slice_m / (below.points / (below_to_m - below_from_m)); }
  bool blunt() const {
    return below.points >= min_points_below && density() > blunt_density && tip.width() > blunt_width * below.width();
  }
  // So that no bare stem of which the last returns lie on one side passes for it.
  bool tip_of_a_crown(double stem_radius) const {
    return below.points >= min_points_below && density() < tip_density && tip.width() < tip_width * below.width() &&
           below.width() > crown_in_radii * stem_radius;
  }
};

bool is_thick_at_top(const Stem& s, double height_m, const TipShape& shape) {
  const Section* last = nullptr;
  for (const auto& section : s.sections)
    if (section.curve && (last == nullptr || section.height > last->height)) last = &section;
  return last != nullptr && height_m - last->height < min_diameters_to_top * 2 * last->radius &&
         !shape.tip_of_a_crown(last->radius);
}

// Points by level, from the lowest upwards.
class Levels {
 public:
  void add(double value) { ++counts_[static_cast<long>(std::floor(value / level_step_m))]; }

  // The highest level at which points end as densely as they lie below it.
  std::optional<double> dense_end() const {
    double above = 0;
    for (auto it = counts_.rbegin(); it != counts_.rend(); ++it) {
      const double tip = between(it->first - tip_steps + 1, it->first),
                   below = between(it->first - tip_steps - below_steps + 1, it->first - tip_steps);
      if (below >= min_points_at_cut && above <= max_share_above * (tip + below) &&
          tip >= cut_density * below * tip_steps / below_steps)
        return static_cast<double>(it->first + 1) * level_step_m;
      above += it->second;
    }
    return std::nullopt;
  }

 private:
  double between(long first, long last) const {
    double sum = 0;
    for (auto it = counts_.lower_bound(first); it != counts_.end() && it->first <= last; ++it) sum += it->second;
    return sum;
  }
  std::map<long, std::uint32_t> counts_;
};

class EndFinder {
 public:
  EndFinder(const std::vector<Stem>& stems, const std::vector<double>& height_m)
      : stems_(stems), height_m_(height_m), shapes_(stems.size()) {}

  TreeEnds find(const PointCloud& points, const PointLabels& labels, const Run& run) {
    look(points, labels, run);
    TreeEnds ends;
    for (std::size_t k = 0; k < stems_.size(); ++k) ends.by_stem.push_back(own_end(k));
    const auto own = ends.by_stem;
    ends.cut = confirmed(levels_.dense_end(), true, own);
    if (!ends.cut) ends.cut = confirmed(heights_.dense_end(), false, own);
    for (std::size_t k = 0; k < stems_.size(); ++k)
      if ((ends.cut && below_cut_m(k, *ends.cut) < hidden_by_cut_m) || ends_like_neighbours(k, own))
        ends.by_stem[k] = TreeEnd::cloud_edge;
    return ends;
  }

 private:
  void look(const PointCloud& points, const PointLabels& labels, const Run& run) {
    const auto& above_ground = points.values<float>(arrays::height_above_ground);
    std::vector<int> by_id;
    for (std::size_t k = 0; k < stems_.size(); ++k) {
      const auto id = static_cast<std::size_t>(stems_[k].id);
      if (id >= by_id.size()) by_id.resize(id + 1, -1);
      by_id[id] = static_cast<int>(k);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      if (labels.tree_id[i] == 0) continue;
      const auto k = static_cast<std::size_t>(by_id[static_cast<std::size_t>(labels.tree_id[i])]);
      const auto& p = points.positions()[i];
      const double below_top = stems_[k].ground_z + height_m_[k] - static_cast<double>(p.z());
      if (!p.allFinite() || below_top < 0) continue;
      levels_.add(static_cast<double>(p.z()));
      if (std::isfinite(above_ground[i])) heights_.add(static_cast<double>(above_ground[i]));
      const Eigen::Vector2d beside = p.head<2>().cast<double>() - stems_[k].breast_height.head<2>();
      if (below_top <= tip_slice_m) shapes_[k].tip.add(beside);
      if (below_top >= below_from_m && below_top <= below_to_m) shapes_[k].below.add(beside);
    }
  }

  TreeEnd own_end(std::size_t k) const {
    if (is_thick_at_top(stems_[k], height_m_[k], shapes_[k])) return TreeEnd::thick_stem;
    if (shapes_[k].blunt()) return TreeEnd::blunt;
    return std::isfinite(stems_[k].crown_base_m) ? TreeEnd::narrows : TreeEnd::bare_stem;
  }

  double below_cut_m(std::size_t k, const CloudCut& cut) const {
    return cut.z_m - height_m_[k] - (cut.level ? stems_[k].ground_z : 0);
  }

  // Dense ends are also those of shrubs, and of a few round crowns of one height. A cut leaves many trees that it meets
  // thick or wide.
  std::optional<CloudCut> confirmed(std::optional<double> end, bool level, const std::vector<TreeEnd>& own) const {
    if (!end) return std::nullopt;
    const CloudCut cut{level, *end};
    int near = 0, stopped = 0;
    for (std::size_t k = 0; k < stems_.size(); ++k) {
      if (std::abs(below_cut_m(k, cut)) > ends_at_cut_m) continue;
      ++near;
      stopped += own[k] == TreeEnd::thick_stem || own[k] == TreeEnd::blunt;
    }
    const int needed = std::min<int>(min_ends_at_cut, static_cast<int>(stems_.size()));
    return stopped >= needed && 4 * stopped >= near ? std::optional(cut) : std::nullopt;
  }

  // However much higher: a scanner sees the higher, the further away a tree stands.
  bool ends_like_neighbours(std::size_t k, const std::vector<TreeEnd>& own) const {
    int stopped = 0, others = 0;
    double lowest = 0;
    for (std::size_t j = 0; j < stems_.size(); ++j) {
      if (j == k) continue;
      if ((stems_[j].breast_height - stems_[k].breast_height).head<2>().norm() > neighbours_m) continue;
      ++others;
      if (own[j] != TreeEnd::thick_stem && own[j] != TreeEnd::blunt) continue;
      lowest = stopped == 0 ? height_m_[j] : std::min(lowest, height_m_[j]);
      ++stopped;
    }
    // Among whole trees some are broken.
    return stopped >= min_stopped_neighbours && 2 * stopped >= others && height_m_[k] > lowest - like_neighbours_m;
  }

  const std::vector<Stem>& stems_;
  const std::vector<double>& height_m_;
  std::vector<TipShape> shapes_;
  Levels levels_, heights_;
};

}  // namespace

TreeEnds tree_ends(const std::vector<Stem>& stems, const std::vector<double>& height_m, const PointCloud& points,
                   const PointLabels& labels, const Run& run) {
  return EndFinder(stems, height_m).find(points, labels, run);
}

}  // namespace bole::stems
