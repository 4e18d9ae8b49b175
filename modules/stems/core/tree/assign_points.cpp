#include "stems/core/tree/assign_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace bole::stems {
namespace {

constexpr double lowest_point_m = 0.10;
constexpr double max_slope_above = 0.15;  // above the measured stem a lean is followed no further than this
constexpr double tallest_m = 80;

// The axis of a stem at any z: straight over the measured part, less inclined above.
struct TreeAxis {
  explicit TreeAxis(const Stem& s)
      : stem(&s),
        breast_height(s.breast_height),
        slope(s.direction.head<2>() / s.direction.z()),
        bend_z(s.breast_height.z() + 3),
        radius(s.radius) {
    above = slope;
    if (above.norm() > max_slope_above) above *= max_slope_above / above.norm();
  }
  Eigen::Vector2d at(double z) const {
    const double low = std::min(z, bend_z) - breast_height.z(), high = std::max(0.0, z - bend_z);
    return breast_height.head<2>() + low * slope + high * above;
  }
  const Stem* stem;
  Eigen::Vector3d breast_height;  // here, and not looked up in the stem: every point of the cloud asks for it
  Eigen::Vector2d slope, above;
  double bend_z, radius;
};

class AxisGrid {
 public:
  AxisGrid(const std::vector<TreeAxis>& axes, double reach) {
    constexpr double cell = 1.0;
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const double sway = max_slope_above * tallest_m + 3;
    for (const auto& a : axes)
      low = low.cwiseMin(a.stem->breast_height.head<2>()), high = high.cwiseMax(a.stem->breast_height.head<2>());
    corner_ = low.array() - (reach + sway);
    cell_ = std::max(cell, (high - low).maxCoeff() / 2000);
    nx_ = static_cast<int>((high.x() + reach + sway - corner_.x()) / cell_) + 1,
    ny_ = static_cast<int>((high.y() + reach + sway - corner_.y()) / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
    for (std::uint32_t k = 0; k < axes.size(); ++k) {
      const double z = axes[k].stem->ground_z;
      const Eigen::Vector2d a = axes[k].at(z), b = axes[k].at(axes[k].bend_z), c = axes[k].at(z + tallest_m);
      const Eigen::Vector2d from = a.cwiseMin(b).cwiseMin(c).array() - reach,
                            to = a.cwiseMax(b).cwiseMax(c).array() + reach;
      for (int iy = clamp(from.y(), corner_.y(), ny_); iy <= clamp(to.y(), corner_.y(), ny_); ++iy)
        for (int ix = clamp(from.x(), corner_.x(), nx_); ix <= clamp(to.x(), corner_.x(), nx_); ++ix)
          cells_[index(ix, iy)].push_back(k);
    }
  }
  const std::vector<std::uint32_t>& near(double x, double y) const {
    static const std::vector<std::uint32_t> none;
    if (!(x >= corner_.x() && y >= corner_.y() && x < corner_.x() + nx_ * cell_ && y < corner_.y() + ny_ * cell_))
      return none;
    return cells_[index(clamp(x, corner_.x(), nx_), clamp(y, corner_.y(), ny_))];
  }

 private:
  int clamp(double v, double corner, int n) const {
    return static_cast<int>(std::clamp((v - corner) / cell_, 0.0, n - 1.0));
  }
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix);
  }
  Eigen::Vector2d corner_;
  double cell_ = 1;
  int nx_ = 0, ny_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool is_bark(const Stem& s, const Eigen::Vector3d& p, double tolerance) {
  const Eigen::Vector3d q = p - s.breast_height;
  const double along = q.dot(s.direction), height = p.z() - s.ground_z;
  if (height < lowest_point_m || height > s.highest + 0.5) return false;
  return std::abs((q - along * s.direction).norm() - s.radius - s.taper * along) <= tolerance;
}

}  // namespace

PointLabels assign_points(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                          const Run& run) {
  PointLabels labels{std::vector<std::int32_t>(points.size(), 0), std::vector<std::uint8_t>(points.size(), 0)};
  if (stems.empty()) return labels;
  std::vector<TreeAxis> axes;
  double widest = 0;
  for (const auto& s : stems) axes.emplace_back(s), widest = std::max(widest, s.radius);
  const AxisGrid grid(axes, options.crown_radius + widest);
  const auto& positions = points.positions();
  const auto& heights = points.values<float>(arrays::height_above_ground);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size(), 1 << 16), [&](const auto& block) {
    if (run.cancelled()) return;
    for (auto i = block.begin(); i != block.end(); ++i) {
      if (!(heights[i] >= static_cast<float>(lowest_point_m)) || !positions[i].allFinite()) continue;
      const Eigen::Vector3d p = positions[i].template cast<double>();
      // Shrubs below are not the tree's: the reach opens from near the bark at the base to the crown radius.
      const double opened = std::clamp(static_cast<double>(heights[i]) / options.search_top, 0.0, 1.0);
      const double reach = 0.3 + (std::max(0.3, options.crown_radius) - 0.3) * opened;
      double best = std::numeric_limits<double>::infinity();
      const Stem* owner = nullptr;
      for (const auto k : grid.near(p.x(), p.y())) {
        const double d = (p.head<2>() - axes[k].at(p.z())).norm() - axes[k].radius;
        if (d < best && d <= reach) best = d, owner = axes[k].stem;
      }
      if (!owner) continue;
      labels.tree_id[i] = owner->id;
      if (is_bark(*owner, p, options.bark_tolerance)) labels.stem[i] = 1;
    }
  });
  run.check_cancel();
  return labels;
}

namespace {

// The highest point of every square of the plot.
class CanopyTop {
 public:
  CanopyTop(const PointCloud& points, const Run& run) {
    constexpr double max_cells = 1 << 24;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      if (const auto& p = points.positions()[i]; p.allFinite())
        low = low.cwiseMin(p.head<2>()), high = high.cwiseMax(p.head<2>());
    }
    if (!(low.array() <= high.array()).all()) return;
    corner_ = low;
    while ((std::floor((high - low).x() / cell_) + 1) * (std::floor((high - low).y() / cell_) + 1) > max_cells)
      cell_ *= 2;
    nx_ = static_cast<int>((high - low).x() / cell_) + 1, ny_ = static_cast<int>((high - low).y() / cell_) + 1;
    highest_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_),
                    -std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      const auto& p = points.positions()[i];
      if (!p.allFinite()) continue;
      auto& top = highest_[index(static_cast<int>((p.x() - corner_.x()) / cell_),
                                 static_cast<int>((p.y() - corner_.y()) / cell_))];
      top = std::max(top, p.z());
    }
  }

  // Highest z of the squares whose middle lies between two distances of a place; -infinity for none.
  double around(const Eigen::Vector2d& place, double inner_m, double outer_m) const {
    double highest = -std::numeric_limits<double>::infinity();
    const Eigen::Vector2d q = (place - corner_.cast<double>()) / cell_;
    const double reach = outer_m / cell_;
    for (int iy = std::max(0, static_cast<int>(q.y() - reach));
         iy <= std::min(ny_ - 1, static_cast<int>(q.y() + reach)); ++iy)
      for (int ix = std::max(0, static_cast<int>(q.x() - reach));
           ix <= std::min(nx_ - 1, static_cast<int>(q.x() + reach)); ++ix)
        if (const double d = cell_ * std::hypot(ix + 0.5 - q.x(), iy + 0.5 - q.y()); d >= inner_m && d <= outer_m)
          highest = std::max(highest, static_cast<double>(highest_[index(ix, iy)]));
    return highest;
  }

 private:
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix);
  }
  Eigen::Vector2f corner_ = Eigen::Vector2f::Zero();
  float cell_ = 0.5F;
  int nx_ = 0, ny_ = 0;
  std::vector<float> highest_;
};

}  // namespace

void measure_heights(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, const Run& run) {
  constexpr double bin_m = 0.5, widest_gap_m = 3;
  // What stands over a stem is its own top where nothing within the reach of a neighbour's branches is higher.
  constexpr double free_m = 2.5, overhang_m = 0.2;
  constexpr double leader_m = 1.0;  // a top stands over its stem; branches of a taller neighbour reach in from the side
  constexpr std::uint32_t min_points = 3;
  std::int32_t largest = 0;
  for (const auto& s : stems) largest = std::max(largest, s.id);
  std::vector<Stem*> by_id(static_cast<std::size_t>(largest) + 1, nullptr);
  for (auto& s : stems) by_id[static_cast<std::size_t>(s.id)] = &s;
  std::vector<TreeAxis> axes;  // by id less one
  for (std::size_t id = 1; id < by_id.size(); ++id)
    axes.emplace_back(by_id[id] != nullptr ? *by_id[id] : stems.front());
  struct Bin {
    std::uint32_t points = 0;
    double highest = 0;
  };
  std::vector<std::vector<Bin>> bins(by_id.size(), std::vector<Bin>(static_cast<std::size_t>(tallest_m / bin_m)));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto id = static_cast<std::size_t>(labels.tree_id[i]);
    if (id == 0) continue;
    const double h = static_cast<double>(points.positions()[i].z()) - by_id[id]->ground_z;
    if (h < 0 || h >= tallest_m) continue;
    const auto& p = points.positions()[i];
    if ((p.head<2>().cast<double>() - axes[id - 1].at(p.z())).norm() > by_id[id]->radius + leader_m) continue;
    auto& bin = bins[id][static_cast<std::size_t>(h / bin_m)];
    ++bin.points, bin.highest = std::max(bin.highest, h);
  }
  const CanopyTop canopy(points, run);
  for (auto& s : stems) {  // upwards until a gap that no tree has
    double gap = 0;
    for (const auto& bin : bins[static_cast<std::size_t>(s.id)]) {
      if (bin.points >= min_points) {
        s.height_m = bin.highest, gap = 0;
      } else if ((gap += bin_m) > widest_gap_m && s.height_m > 0) {
        break;
      }
    }
    const double top = s.ground_z + s.height_m;
    s.overhung = canopy.around(axes[static_cast<std::size_t>(s.id) - 1].at(top), leader_m, free_m) > top + overhang_m;
  }
  // A top that a neighbour's may be: both stems stand below it.
  for (auto& s : stems) {
    const double top = s.ground_z + s.height_m;
    const Eigen::Vector2d at = axes[static_cast<std::size_t>(s.id) - 1].at(top);
    s.overhung = s.overhung || std::ranges::any_of(stems, [&](const Stem& o) {
                   return o.id != s.id && o.ground_z + o.height_m > top - 2 * overhang_m &&
                          (axes[static_cast<std::size_t>(o.id) - 1].at(top) - at).norm() < free_m;
                 });
  }
}

namespace {

// How far up and how far away the sensor measures: of returns from trees, so that the many on the ground do not count.
struct SensorReach {
  double steepest = 0;  // tangent of the elevation
  double longest_m = 0;
  bool covers(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const Eigen::Vector3d ray = to - from;
    return ray.norm() < longest_m && ray.z() < steepest * std::max(0.01, ray.head<2>().norm());
  }
};

// Share `rank` of the values lie below; 0 for none.
double quantile(std::vector<double>& values, double rank) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

SensorReach sensor_reach(const PointCloud& points, const PointLabels& labels, const SensorOf& sensor_of,
                         const Run& run) {
  std::vector<double> steepness, ranges;
  for (std::size_t k = 0, i = 0; i < points.size(); ++k, i += 7) {
    if ((k & 0x1ffffU) == 0) run.check_cancel();
    if (labels.tree_id[i] == 0) continue;
    const auto sensor = sensor_of(i);
    if (!sensor) continue;
    const Eigen::Vector3d ray = (points.positions()[i] - *sensor).cast<double>();
    steepness.push_back(ray.z() / std::max(0.01, ray.head<2>().norm()));
    ranges.push_back(ray.norm());
  }
  // A jerk of the hand tilts the sensor for a moment; that is not how far it sees.
  return {quantile(steepness, 0.98), quantile(ranges, 0.999)};
}

}  // namespace

void judge_tops(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                const SensorOf& sensor_of, const Run& run) {
  constexpr double bare_stem_m = 5, beyond_m = 1.5;
  constexpr int min_views = 50;
  if (!sensor_of) {
    for (auto& s : stems) s.height_seen = s.height_m > bare_stem_m && !s.overhung;
    return;
  }
  const SensorReach reach = sensor_reach(points, labels, sensor_of, run);
  std::vector<int> views(stems.size() + 1, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto id = static_cast<std::size_t>(labels.tree_id[i]);
    if (id == 0 || views[id] >= min_views) continue;
    const auto& s = stems[id - 1];
    const auto sensor = sensor_of(i);
    if (!sensor) continue;
    const Eigen::Vector3d above_top(s.breast_height.x(), s.breast_height.y(), s.ground_z + s.height_m + beyond_m);
    views[id] += reach.covers(sensor->template cast<double>(), above_top) ? 1 : 0;
  }
  for (auto& s : stems) s.height_seen = views[static_cast<std::size_t>(s.id)] >= min_views && !s.overhung;
}

}  // namespace bole::stems
