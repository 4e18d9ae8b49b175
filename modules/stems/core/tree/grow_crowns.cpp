#include "stems/core/tree/grow_crowns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>

#include "base/statistics.h"
#include "cloud/core/whole/whole_cloud.h"
#include "stems/core/tree/crown_cells.h"
#include "stems/core/tree/tree_axis.h"

namespace bole::stems {
namespace {

constexpr double cell_m = 0.25, bottom_m = 0.3;
constexpr int reach_cells = 2;       // a way leaps this many cells at most
constexpr int coarse_times = 3;      // what is left is reached in cells this much larger
constexpr double upward = 0.6;       // cost of a metre up, of one sideways: branches rise
constexpr double along_stem = 0.25;  // the same along the continuation of the stem
constexpr double leader_m = 0.30;    // reach about the continuation
constexpr double widest_gap_m = 3;   // in a stem or crown
constexpr float never = std::numeric_limits<float>::infinity();

// The two trees with the shortest ways to a node, the best first.
struct Claim {
  std::array<float, 2> cost{never, never};
  std::array<std::int32_t, 2> tree{-1, -1};  // index of the stem

  // Whether the way is shorter than what the tree had, or than those of two other trees.
  bool take(float c, std::int32_t t) {
    if (t == tree[0]) {
      if (c >= cost[0]) return false;
      cost[0] = c;
      return true;
    }
    if (c >= cost[1]) return false;
    cost[1] = c;
    tree[1] = t;
    if (cost[1] < cost[0]) {
      std::swap(cost[0], cost[1]);
      std::swap(tree[0], tree[1]);
    }
    return true;
  }
  bool holds(float c, std::int32_t t) const { return (tree[0] == t && cost[0] == c) || (tree[1] == t && cost[1] == c); }
};

struct Step {
  float cost;
  std::uint32_t node;
  std::int32_t tree;
  bool operator>(const Step& o) const {
    return std::tie(cost, node, tree) > std::tie(o.cost, o.node, o.tree);  // an order that does not depend on the past
  }
};

// Centres of a stem by height: its sections, straight on above them.
class StemLine {
 public:
  explicit StemLine(const Stem& s) : axis_(s) {
    for (const auto& c : s.sections)
      if (c.curve || c.used) centres_.push_back(c.centre);
    std::ranges::sort(centres_, {}, [](const Eigen::Vector3d& c) { return c.z(); });
  }
  double top_z() const { return centres_.empty() ? axis_.breast_height.z() : centres_.back().z(); }
  Eigen::Vector2d at(double z) const {
    if (centres_.size() < 2 || z <= centres_.front().z()) return axis_.at(z);
    if (z >= top_z()) return centres_.back().head<2>() + (axis_.at(z) - axis_.at(top_z()));
    const auto above = std::ranges::lower_bound(centres_, z, {}, [](const Eigen::Vector3d& c) { return c.z(); });
    const auto &a = *(above - 1), &b = *above;
    const double share = (z - a.z()) / std::max(1e-6, b.z() - a.z());
    return (a + share * (b - a)).head<2>();
  }

 private:
  TreeAxis axis_;
  std::vector<Eigen::Vector3d> centres_;
};

class Growth {
 public:
  Growth(const std::vector<Stem>& stems, const MeasureOptions& options, const Run& run)
      : stems_(stems), options_(options), run_(run) {
    std::vector<double> radii;
    for (const auto& s : stems) {
      lines_.emplace_back(s);
      radii.push_back(s.radius);
    }
    const double usual = std::max(0.01, upper_median(radii));
    for (const auto& s : stems) vigour_.push_back(std::clamp(std::sqrt(s.radius / usual), 0.7, 1.5));
  }

  std::vector<Claim> grow(const CrownCells& cells) {
    std::vector<Claim> claims(cells.nodes());
    Queue queue;
    for (std::size_t k = 0; k < stems_.size(); ++k) seed(cells, k, queue, claims);
    spread(cells, queue, claims);
    const CrownCells coarse = cells.coarser(coarse_times);
    std::vector<Claim> coarse_claims(coarse.nodes());
    for (std::uint32_t n = 0; n < cells.nodes(); ++n) {
      const auto c = coarse.node_at(cells.middle(n));
      for (std::size_t i = 0; i < 2; ++i)
        if (claims[n].tree[i] >= 0) offer({claims[n].cost[i], c, claims[n].tree[i]}, queue, coarse_claims);
    }
    spread(coarse, queue, coarse_claims);
    for (std::uint32_t n = 0; n < cells.nodes(); ++n)
      if (claims[n].tree[0] < 0) claims[n] = coarse_claims[coarse.node_at(cells.middle(n))];
    return claims;
  }

 private:
  using Queue = std::priority_queue<Step, std::vector<Step>, std::greater<>>;

  static void offer(const Step& step, Queue& queue, std::vector<Claim>& claims) {
    if (claims[step.node].take(step.cost, step.tree)) queue.push(step);
  }

  void seed(const CrownCells& cells, std::size_t k, Queue& queue, std::vector<Claim>& claims) const {
    const Stem& s = stems_[k];
    const auto& line = lines_[k];
    const double highest = s.ground_z + std::min(tallest_m, 3 + 240 * s.radius);  // no tree is more slender
    double last_z = line.top_z();
    for (double z = s.ground_z + bottom_m; z < highest && z - last_z < widest_gap_m; z += cells.cell_m()) {
      const double above = std::max(0.0, z - line.top_z()), reach = (above > 0 ? leader_m : s.radius) + cells.cell_m();
      const Eigen::Vector2d at = line.at(z);
      const int steps = static_cast<int>(std::ceil(reach / cells.cell_m()));
      bool met = false;
      for (int iy = -steps; iy <= steps; ++iy)
        for (int ix = -steps; ix <= steps; ++ix) {
          const Eigen::Vector2d off = cells.cell_m() * Eigen::Vector2d(ix, iy);
          if (off.norm() > reach) continue;
          const auto node = cells.node_at({at.x() + off.x(), at.y() + off.y(), z});
          if (node == CrownCells::none) continue;
          met = true;
          const double cost = (along_stem * above + (above > 0 ? off.norm() : 0.0)) / vigour_[k];
          offer({static_cast<float>(cost), node, static_cast<std::int32_t>(k)}, queue, claims);
        }
      if (met) last_z = std::max(last_z, z);
    }
  }

  // Near the stem low above the ground, so that shrubs are nobody's; further out above.
  bool may_reach(std::size_t k, const Eigen::Vector3d& p) const {
    const Stem& s = stems_[k];
    const double height = p.z() - s.ground_z, opened = std::clamp(height / options_.search_top, 0.0, 1.0);
    const double reach = 0.3 + (std::max(0.3, options_.crown_radius) - 0.3) * opened * opened;
    return height >= 0 && (p.head<2>() - lines_[k].at(p.z())).norm() - s.radius <= reach;
  }

  void spread(const CrownCells& cells, Queue& queue, std::vector<Claim>& claims) const {
    constexpr int n = 2 * reach_cells + 1;
    std::array<float, static_cast<std::size_t>(n * n * n)> cost{};
    const auto at = [](int dx, int dy, int dz) {
      const int cell = ((dz + reach_cells) * n + dy + reach_cells) * n + dx + reach_cells;
      return static_cast<std::size_t>(cell);
    };
    for (int dz = -reach_cells; dz <= reach_cells; ++dz)
      for (int dy = -reach_cells; dy <= reach_cells; ++dy)
        for (int dx = -reach_cells; dx <= reach_cells; ++dx) {
          const double length = std::sqrt(dx * dx + dy * dy + dz * dz), rise = dz > 0 ? upward * dz : dz;
          const double weighted = std::sqrt(dx * dx + dy * dy + rise * rise), beside = std::sqrt(3.0) + 1e-6;
          cost[at(dx, dy, dz)] =
              static_cast<float>(cells.cell_m() * weighted * std::max(1.0, std::pow(length / beside, 2)));
        }
    std::size_t done = 0;
    while (!queue.empty()) {
      if ((++done & 0xffffU) == 0) run_.check_cancel();
      const Step step = queue.top();
      queue.pop();
      if (!claims[step.node].holds(step.cost, step.tree)) continue;  // a shorter way was found since
      const auto k = static_cast<std::size_t>(step.tree);
      const auto ease = static_cast<float>(1 / vigour_[k]);
      cells.for_each_near(step.node, reach_cells, [&](std::uint32_t next, int dx, int dy, int dz) {
        const float c = step.cost + ease * cost[at(dx, dy, dz)];
        const Claim& other = claims[next];
        const float held = other.tree[0] == step.tree ? other.cost[0] : other.cost[1];
        if (c < held && may_reach(k, cells.middle(next))) offer({c, next, step.tree}, queue, claims);
      });
    }
  }

  const std::vector<Stem>& stems_;
  const MeasureOptions& options_;
  const Run& run_;
  std::vector<StemLine> lines_;
  std::vector<double> vigour_;
};

}  // namespace

CrownGrowth grow_crowns(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                        const Run& run, PointLabels& labels) {
  CrownGrowth growth{std::vector<float>(points.size(), std::nanf(""))};
  if (stems.empty()) return growth;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const double around = options.crown_radius + 1;
  for (const auto& s : stems) {
    const TreeAxis axis(s);
    for (const double z : {s.ground_z, s.ground_z + 30}) {
      const Eigen::Vector2d at = axis.at(z);
      low = low.cwiseMin(Eigen::Vector3d(at.x() - around, at.y() - around, s.ground_z));
      high = high.cwiseMax(Eigen::Vector3d(at.x() + around, at.y() + around, s.ground_z + 1));
    }
  }
  Eigen::Vector3f cloud_low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity()),
                  cloud_high = -cloud_low;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    const auto& p = points.positions()[i];
    if (!p.allFinite()) continue;
    cloud_low = cloud_low.cwiseMin(p);
    cloud_high = cloud_high.cwiseMax(p);
  }
  double tallest_z = low.z();
  for (const auto& s : stems) tallest_z = std::max(tallest_z, s.ground_z + tallest_m);
  high.z() = std::min(tallest_z, static_cast<double>(cloud_high.z()) + 0.01);
  for (int k = 0; k < 2; ++k) {
    low[k] = std::max(low[k], static_cast<double>(cloud_low[k]));
    high[k] = std::min(high[k], static_cast<double>(cloud_high[k]) + 0.01);
  }
  // Cells begin where the whole cloud does, so that one that is moved, or a part of it, has the same crowns.
  const Eigen::Vector3d anchor = grid_anchor(points, run);
  low = anchor.array() + cell_m * ((low - anchor) / cell_m).array().floor();
  const CrownCells cells(points, low, high, cell_m, bottom_m, run);
  const auto claims = Growth(stems, options, run).grow(cells);
  const auto& heights = points.values<float>(arrays::height_above_ground);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (!(heights[i] >= static_cast<float>(options.search_top))) continue;
    const auto node = cells.node_at(points.positions()[i].cast<double>());
    if (node == CrownCells::none) continue;
    const auto& claim = claims[node];
    labels.tree_id[i] = claim.tree[0] < 0 ? 0 : stems[static_cast<std::size_t>(claim.tree[0])].id;
    if (claim.tree[0] >= 0) growth.lead_m[i] = claim.cost[1] - claim.cost[0];
  }
  return growth;
}

}  // namespace bole::stems
