#include "sim/core/walk/route.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "base/error.h"
#include "base/option.h"

namespace bole::sim {
namespace {

constexpr double cell_m = 0.1;

// A thin pole is passed closer than a stem.
double clearance_to(const Tree& tree, double clearance_m) { return tree.pole ? 0.5 * clearance_m : clearance_m; }

// Where one may walk and at what cost per metre.
class CostGrid {
 public:
  CostGrid(const Forest& forest, const std::vector<Obstacle>& soft, double reach_m, double clearance_m)
      : n_(static_cast<int>(std::ceil(2 * reach_m / cell_m))), reach_m_(reach_m) {
    cost_.assign(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_), 1.0f);
    for (const auto& s : soft)
      spread(s.xy, s.radius_m + 0.5,
             [&](double d) { return 1 + 5 * std::clamp((s.radius_m + 0.5 - d) / 0.5, 0.0, 1.0); });
    for (const auto& tree : forest.trees) {
      // The stem where the walker meets it, knee to chest.
      const Eigen::Vector2d at = tree.stem.axis(0.9).head<2>();
      const double r = tree.stem.mean_radius(0.4);
      spread(at, r + 1.0, [&](double d) {
        return d < r + clearance_to(tree, clearance_m) ? blocked : 1 + 4 * std::clamp((r + 1.0 - d) / 0.5, 0.0, 1.0);
      });
    }
    for (const auto& t : forest.targets)
      spread(t.middle.head<2>(), 0.8, [&](double d) { return d < 0.5 ? blocked : 3.0; });
  }

  static constexpr double blocked = 1e6;
  int n() const { return n_; }
  int index(const Eigen::Vector2d& p) const {
    const auto c = [&](double v) { return std::clamp(static_cast<int>((v + reach_m_) / cell_m), 0, n_ - 1); };
    return c(p.y()) * n_ + c(p.x());
  }
  Eigen::Vector2d point(int i) const {
    const int column = i % n_, row = i / n_;
    return {(column + 0.5) * cell_m - reach_m_, (row + 0.5) * cell_m - reach_m_};
  }
  bool is_free(int i) const { return cost_[static_cast<std::size_t>(i)] < blocked; }
  double cost(int i) const { return cost_[static_cast<std::size_t>(i)]; }

  int nearest_free(const Eigen::Vector2d& p) const {
    if (is_free(index(p))) return index(p);
    int best = -1;
    double distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < n_ * n_; ++i)
      if (const double d = (point(i) - p).squaredNorm(); is_free(i) && d < distance) {
        best = i;
        distance = d;
      }
    return best;
  }

 private:
  template <class Cost>
  void spread(const Eigen::Vector2d& middle, double radius, Cost&& cost_at) {
    const auto first = [&](double v) { return std::max(0, static_cast<int>((v - radius + reach_m_) / cell_m)); };
    const auto last = [&](double v) { return std::min(n_ - 1, static_cast<int>((v + radius + reach_m_) / cell_m)); };
    for (int y = first(middle.y()); y <= last(middle.y()); ++y)
      for (int x = first(middle.x()); x <= last(middle.x()); ++x) {
        const int i = y * n_ + x;
        const double d = (point(i) - middle).norm();
        if (d <= radius)
          cost_[static_cast<std::size_t>(i)] =
              std::max(cost_[static_cast<std::size_t>(i)], static_cast<float>(cost_at(d)));
      }
  }
  int n_;
  double reach_m_;
  std::vector<float> cost_;
};

// A* over the grid's 8 neighbours; leaving the straight line costs extra, so that lines stay lines. Empty: no way.
std::vector<Eigen::Vector2d> cheapest_way(const CostGrid& grid, int from, int to) {
  const Eigen::Vector2d a = grid.point(from), b = grid.point(to);
  const Eigen::Vector2d along = (b - a).norm() > 0 ? Eigen::Vector2d((b - a).normalized()) : Eigen::Vector2d(1, 0);
  const auto detour = [&](const Eigen::Vector2d& p) {
    return 0.8 * std::abs(along.x() * (p - a).y() - along.y() * (p - a).x());
  };
  const int cells = grid.n() * grid.n();
  std::vector<double> best(static_cast<std::size_t>(cells), std::numeric_limits<double>::infinity());
  std::vector<int> came(static_cast<std::size_t>(cells), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  best[static_cast<std::size_t>(from)] = 0;
  open.emplace((b - a).norm(), from);
  while (!open.empty()) {
    const auto [estimate, i] = open.top();
    open.pop();
    if (i == to) break;
    const double so_far = best[static_cast<std::size_t>(i)];
    if (estimate > so_far + (b - grid.point(i)).norm() + 1e-9) continue;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = i % grid.n() + dx, y = i / grid.n() + dy, j = y * grid.n() + x;
        if ((dx == 0 && dy == 0) || x < 0 || y < 0 || x >= grid.n() || y >= grid.n() || !grid.is_free(j)) continue;
        const Eigen::Vector2d p = grid.point(j);
        const double reached = so_far + cell_m * std::hypot(dx, dy) * (grid.cost(j) + detour(p));
        if (reached >= best[static_cast<std::size_t>(j)]) continue;
        best[static_cast<std::size_t>(j)] = reached;
        came[static_cast<std::size_t>(j)] = i;
        open.emplace(reached + (b - p).norm(), j);
      }
  }
  if (from != to && came[static_cast<std::size_t>(to)] < 0) return {};
  std::vector<Eigen::Vector2d> way;
  for (int i = to; i >= 0; i = i == from ? -1 : came[static_cast<std::size_t>(i)]) way.push_back(grid.point(i));
  std::ranges::reverse(way);
  return way;
}

std::vector<Eigen::Vector2d> resample(const std::vector<Eigen::Vector2d>& path, double step) {
  std::vector<Eigen::Vector2d> out{path.front()};
  double carried = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d leg = path[i] - path[i - 1];
    const double length = leg.norm();
    for (; carried + length >= step * static_cast<double>(out.size());)
      out.push_back(path[i - 1] + leg * ((step * static_cast<double>(out.size()) - carried) / length));
    carried += length;
  }
  return out;
}

// Rounds corners and grid steps; what comes too close to a stem is pushed out again.
void smooth_route(std::vector<Eigen::Vector2d>& path, const Forest& forest, double clearance_m) {
  for (int iteration = 0; iteration < 80; ++iteration) {
    std::vector<Eigen::Vector2d> next = path;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) next[i] = 0.5 * path[i] + 0.25 * (path[i - 1] + path[i + 1]);
    for (auto& p : next)
      for (const auto& tree : forest.trees) {
        const Eigen::Vector2d from_stem = p - tree.stem.axis(0.9).head<2>();
        const double reach = tree.stem.mean_radius(0.4) + clearance_to(tree, clearance_m) + 0.05, d = from_stem.norm();
        if (d < reach && d > 1e-6) p += from_stem * ((reach - d) / d);
      }
    path = std::move(next);
  }
}

}  // namespace

std::vector<Eigen::Vector2d> walk_pattern(double plot_size_m, double line_spacing_m) {
  const double half = 0.5 * plot_size_m, end = std::max(1.0, half - 1.0);
  int lines = std::max(1, static_cast<int>(std::floor((plot_size_m - 2.0) / line_spacing_m)) + 1);
  if (lines % 2 == 0) --lines;
  const double top = 0.5 * line_spacing_m * (lines - 1), turn = std::min(1.5, 0.25 * plot_size_m);
  // The sharp turns in the two corners are rounded: a person does not spin on the spot.
  std::vector<Eigen::Vector2d> points{{0.9, -0.7}, {-end, top - turn}};
  for (int i = 0; i < lines; ++i) {
    const double y = top - i * line_spacing_m, side = i % 2 == 0 ? -1 : 1;
    points.emplace_back(side * end, y);
    points.emplace_back(-side * end, y);
  }
  points.emplace_back(end, -top + turn);
  points.emplace_back(0.9, -0.7);
  return points;
}

std::vector<Eigen::Vector2d> plan_route(const std::vector<Eigen::Vector2d>& way_points, const Forest& forest,
                                        const std::vector<Obstacle>& soft, double step_m) {
  if (way_points.size() < 2)
    throw bad_input("a walk of " + std::to_string(way_points.size()) + " way-points", "at least 2");
  double reach = forest.half_side_m() + 1;
  for (const auto& p : way_points) reach = std::max(reach, p.cwiseAbs().maxCoeff() + 1);
  for (const double clearance : {0.6, 0.5, 0.4, 0.3}) {
    const CostGrid grid(forest, soft, reach, clearance);
    std::vector<Eigen::Vector2d> path;
    bool complete = true;
    for (std::size_t i = 0; i + 1 < way_points.size() && complete; ++i) {
      const int from = grid.nearest_free(way_points[i]), to = grid.nearest_free(way_points[i + 1]);
      if (from < 0 || to < 0) throw failure("trees leave no free ground to walk on");
      const auto leg = cheapest_way(grid, from, to);
      complete = !leg.empty();
      path.insert(path.end(), leg.begin(), leg.end());
    }
    if (!complete) continue;
    path = resample(path, step_m);
    smooth_route(path, forest, clearance);
    return resample(path, step_m);
  }
  throw failure("trees block the walk between its way-points", "gaps of at least 0.6 m",
                "Use a wider spacing or another walk");
}

}  // namespace bole::sim
