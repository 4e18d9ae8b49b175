#include "survey/core/check/check_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "base/angles.h"
#include "base/no_number.h"
#include "cloud/stem_rows.h"
#include "survey/core/check/point_views.h"

namespace bole::survey {
namespace {

constexpr double ground_band_m = 0.15, shown_band_m = 0.5, view_height_m = 3, window_s = 20;
constexpr int sectors = 16, bins = 100;  // of the heights within the shown band, 1 cm each
constexpr std::uint32_t min_sector_points = 5, min_pass_points = 30;
constexpr double max_cells = 250e3;
constexpr std::size_t cells_between_checks = std::size_t{1} << 20;

struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  void add(const Eigen::Vector2d& p) {
    if (!p.allFinite()) return;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  bool empty() const { return !(low.array() <= high.array()).all(); }
};

Box stems_box(const Table* stems) {
  Box box;
  if (stems == nullptr) return box;
  const auto x = stems->numbers("x_m"), y = stems->numbers("y_m");
  for (const auto i : kept_rows(*stems)) box.add({x[i], y[i]});
  return box;
}

Box cloud_box(const PointCloud* points) {
  Box box;
  if (points != nullptr)
    for (std::size_t i = 0; i < points->size(); ++i) box.add(points->position(i).head<2>());
  return box;
}

Box region_box(const CheckInputs& in, const PlotArea& area) {
  Box box;
  for (const auto& p : area.outline()) box.add(p);
  if (box.empty()) box = stems_box(in.stems);
  if (box.empty() || (box.high - box.low).minCoeff() < 2) box = cloud_box(in.points);
  if (box.empty()) box.add({0, 0});
  return box;
}

// Heights in a cell, as a histogram about the terrain.
struct Heights {
  std::array<std::uint32_t, bins> count{};
  std::uint32_t total = 0;
  void add(double h) {
    const auto bin = static_cast<std::size_t>((h + shown_band_m) / (2 * shown_band_m) * bins);
    if (bin < bins) ++count[bin], ++total;
  }
  // Of the heights about the most frequent one: the feet of stems and herbs spread over the whole band, and the ground
  // does not. Of equal ones the lowest.
  double quantile_cm(double q) const {
    constexpr std::size_t reach = 15;
    std::size_t peak = 1;
    const auto three = [&](std::size_t i) { return count[i - 1] + count[i] + count[i + 1]; };
    for (std::size_t i = 1; i + 1 < bins; ++i)
      if (three(i) > three(peak)) peak = i;
    const std::size_t begin = peak > reach ? peak - reach : 0, end = std::min<std::size_t>(bins, peak + reach + 1);
    double all = 0, before = 0;
    for (std::size_t i = begin; i < end; ++i) all += count[i];
    const double wanted = q * all;
    for (std::size_t i = begin; i < end; ++i) {
      const double n = count[i];
      if (before + n >= wanted && n > 0)
        return 100 * shown_band_m * (2 * (static_cast<double>(i) + (wanted - before) / n) / bins - 1);
      before += n;
    }
    return no_number;
  }
};

double span_deg(const std::array<std::uint32_t, sectors>& views, int& directions) {
  int first = -1, last = -1, widest = 0;
  directions = 0;
  for (int s = 0; s < sectors; ++s) {
    if (views[static_cast<std::size_t>(s)] < min_sector_points) continue;
    ++directions;
    if (first < 0) first = s;
    if (last >= 0) widest = std::max(widest, s - last - 1);
    last = s;
  }
  if (first < 0) return 0;
  widest = std::max(widest, first + sectors - last - 1);
  return 360.0 * (sectors - widest) / sectors;
}

class Measuring {
 public:
  Measuring(CheckGrid& grid, const CheckInputs& in, const std::vector<float>& heights,
            const std::vector<std::int32_t>& passes, const Run& run)
      : grid_(grid), in_(in), heights_(heights), passes_(passes), run_(run) {}

  void measure() {
    if (in_.points != nullptr) {
      scan();
      finish();
    }
    measure_walk();
  }

 private:
  void scan() {
    const auto& points = *in_.points;
    const PointViews views(points);
    grid_.has_views = views.known();
    grid_.has_heights = !heights_.empty();
    grid_.has_passes = !passes_.empty();
    views_.resize(grid_.cells.size());
    all_.resize(grid_.cells.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % cells_between_checks == 0) run_.check_cancel();
      const Eigen::Vector2d p = points.position(i).head<2>();
      const auto c = grid_.index(p);
      if (!c) continue;
      ++grid_.cells[*c].points;
      const double h = heights_.empty() ? 0 : static_cast<double>(heights_[i]);
      if (!heights_.empty() && std::abs(h) < shown_band_m) add_height(*c, i, h);
      if (grid_.has_views && h < view_height_m)
        if (const auto from = views.sensor(i)) {
          const Eigen::Vector2d d = *from - p;
          const double turn = (std::atan2(d.y(), d.x()) + std::numbers::pi) / (2 * std::numbers::pi);
          ++views_[*c][std::min<std::size_t>(sectors - 1, static_cast<std::size_t>(turn * sectors))];
        }
    }
  }

  void add_height(std::size_t cell, std::size_t point, double h) {
    grid_.cells[cell].ground_points += std::abs(h) <= ground_band_m;
    all_[cell].add(h);
    if (!passes_.empty()) by_pass_[{cell, passes_[point]}].add(h);
  }

  void finish() {
    for (std::size_t c = 0; c < grid_.cells.size(); ++c) {
      auto& cell = grid_.cells[c];
      cell.view_span_deg = grid_.has_views ? span_deg(views_[c], cell.directions) : no_number;
      cell.pass_spread_cm = no_number;
      const bool enough = all_[c].total >= min_pass_points;
      cell.thickness_cm = enough ? (all_[c].quantile_cm(0.84) - all_[c].quantile_cm(0.16)) / 2 : no_number;
    }
    std::map<std::size_t, std::pair<double, double>> range;
    std::map<std::size_t, int> count;
    for (const auto& [key, heights] : by_pass_) {
      if (heights.total < min_pass_points) continue;
      const double middle = heights.quantile_cm(0.5);
      const auto [it, first] = range.try_emplace(key.first, middle, middle);
      it->second = {std::min(it->second.first, middle), std::max(it->second.second, middle)};
      ++count[key.first];
    }
    for (const auto& [cell, n] : count)
      if (n > 1) grid_.cells[cell].pass_spread_cm = range[cell].second - range[cell].first;
  }

  void measure_walk() {
    std::vector<Eigen::Vector2d> walk;
    constexpr double step_m = 0.25;
    if (in_.trajectory != nullptr)
      for (const auto& pose : in_.trajectory->poses)
        if (const Eigen::Vector2d p = pose.T_target_sensor.translation().head<2>();
            walk.empty() || (p - walk.back()).norm() >= step_m)
          walk.push_back(p);
    for (std::size_t c = 0; c < grid_.cells.size(); ++c) {
      if (c % 1024 == 0) run_.check_cancel();
      double best = std::numeric_limits<double>::infinity();
      const auto middle = grid_.middle(c);
      for (const auto& p : walk) best = std::min(best, (p - middle).squaredNorm());
      grid_.cells[c].walk_m = walk.size() > 1 ? std::sqrt(best) : no_number;
    }
  }

  CheckGrid& grid_;
  const CheckInputs& in_;
  const std::vector<float>& heights_;
  const std::vector<std::int32_t>& passes_;
  const Run& run_;
  std::vector<std::array<std::uint32_t, sectors>> views_;
  std::vector<Heights> all_;
  std::map<std::pair<std::size_t, std::int32_t>, Heights> by_pass_;
};

// Without a boundary only what is enclosed by seen cells is judged: nobody said that the rest belongs to the plot.
void keep_enclosed(CheckGrid& grid) {
  std::vector<std::uint8_t> outside(grid.cells.size(), 0);
  std::vector<std::size_t> open;
  const auto try_cell = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= grid.nx || y >= grid.ny) return;
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.nx) + static_cast<std::size_t>(x);
    if (outside[i] != 0 || grid.cells[i].ground_points > 0) return;
    outside[i] = 1;
    open.push_back(i);
  };
  for (int x = 0; x < grid.nx; ++x) try_cell(x, 0), try_cell(x, grid.ny - 1);
  for (int y = 0; y < grid.ny; ++y) try_cell(0, y), try_cell(grid.nx - 1, y);
  while (!open.empty()) {
    const auto i = open.back();
    open.pop_back();
    const int x = static_cast<int>(i % static_cast<std::size_t>(grid.nx)),
              y = static_cast<int>(i / static_cast<std::size_t>(grid.nx));
    try_cell(x - 1, y), try_cell(x + 1, y), try_cell(x, y - 1), try_cell(x, y + 1);
  }
  for (std::size_t i = 0; i < grid.cells.size(); ++i) grid.cells[i].inside = outside[i] == 0;
}

}  // namespace

std::size_t CheckGrid::inside_cells() const {
  return static_cast<std::size_t>(std::ranges::count_if(cells, [](const CheckCell& c) { return c.inside; }));
}

std::vector<float> heights_of(const CheckInputs& in, const Run& run) {
  if (in.points == nullptr) return {};
  if (in.points->has(arrays::height_above_ground)) return in.points->values<float>(arrays::height_above_ground);
  if (in.dem == nullptr) return {};
  std::vector<float> heights(in.points->size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i % cells_between_checks == 0) run.check_cancel();
    const Eigen::Vector3d p = in.points->position(i);
    heights[i] = static_cast<float>(p.z() - in.dem->sample(p.x(), p.y()));
  }
  return heights;
}

std::vector<std::int32_t> passes_of(const PointCloud& points) {
  std::vector<std::int32_t> passes;
  if (points.has(arrays::pass)) {
    passes = points.values<std::int32_t>(arrays::pass);
  } else if (points.has(arrays::time)) {
    const auto& times = points.values<double>(arrays::time);
    double begin = std::numeric_limits<double>::infinity();
    for (const double t : times)
      if (std::isfinite(t)) begin = std::min(begin, t);
    constexpr double longest_s = 1e6;  // of a survey; what is later has a damaged time
    passes.reserve(times.size());
    for (const double t : times)
      passes.push_back(std::isfinite(t) && t - begin < longest_s
                           ? static_cast<std::int32_t>(std::floor((t - begin) / window_s))
                           : -1);
  }
  if (passes.empty() || std::ranges::all_of(passes, [&](auto p) { return p == passes.front(); })) return {};
  return passes;
}

CheckGrid measure_cells(const CheckInputs& in, const PlotArea& area, const std::vector<float>& heights,
                        const std::vector<std::int32_t>& passes, const CheckOptions& o, const Run& run) {
  auto box = region_box(in, area);
  CheckGrid grid;
  grid.bounded = area.shape != PlotArea::Shape::none;
  grid.centre = grid.bounded ? area.centre : Eigen::Vector2d((box.low + box.high) / 2);
  grid.cell_m = o.cell;
  // A rim of a metre, so that trees on the boundary are measured too.
  const double rim_m = grid.cell_m * std::ceil(1 / grid.cell_m);
  box.low.array() -= rim_m;
  box.high.array() += rim_m;
  const Eigen::Vector2d size = box.high - box.low;
  while ((size.x() / grid.cell_m + 1) * (size.y() / grid.cell_m + 1) > max_cells) grid.cell_m *= 2;
  grid.nx = std::max(1, static_cast<int>(std::ceil(size.x() / grid.cell_m - 1e-9)));
  grid.ny = std::max(1, static_cast<int>(std::ceil(size.y() / grid.cell_m - 1e-9)));
  grid.low = box.low;
  grid.cells.resize(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
  for (auto& c : grid.cells) c.view_span_deg = c.thickness_cm = c.pass_spread_cm = no_number;
  Measuring(grid, in, heights, passes, run).measure();
  if (grid.bounded)
    for (std::size_t i = 0; i < grid.cells.size(); ++i) grid.cells[i].inside = area.contains(grid.middle(i));
  else
    keep_enclosed(grid);
  return grid;
}

}  // namespace bole::survey
