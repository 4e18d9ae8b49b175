#include "plant/core/separate/plant_parts.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "base/statistics.h"
#include "cloud/voxels.h"

namespace bole::plant {
namespace {

struct Group {
  std::uint32_t id = 0;
  std::size_t points = 0;
  std::vector<std::uint32_t> cells;
  double min_height = std::numeric_limits<double>::max();
  double min_centre_distance = std::numeric_limits<double>::max();
};

struct Cells {
  std::vector<std::uint32_t> of_point;
  Points3 middle;                    // mean of the points of each
  std::vector<std::uint32_t> group;  // of each
  std::vector<Group> groups;
};

Cells cells_of(const Points3& level, const PartSearch& search) {
  Cells out;
  std::vector<std::uint64_t> keys(level.size());
  for (std::size_t i = 0; i < level.size(); ++i) keys[i] = voxel_key(level[i], search.link);
  auto unique = keys;
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  out.group = connected_groups(unique);
  out.middle.assign(unique.size(), Eigen::Vector3d::Zero());
  out.of_point.resize(level.size());
  std::vector<double> count(unique.size(), 0);
  const std::uint32_t groups = out.group.empty() ? 0 : *std::ranges::max_element(out.group) + 1;
  out.groups.resize(groups);
  for (std::size_t i = 0; i < level.size(); ++i) {
    const auto cell = static_cast<std::uint32_t>(std::ranges::lower_bound(unique, keys[i]) - unique.begin());
    out.of_point[i] = cell;
    out.middle[cell] += level[i];
    count[cell] += 1;
    auto& group = out.groups[out.group[cell]];
    ++group.points;
    group.min_height = std::min(group.min_height, level[i].z() - search.soil_height);
    group.min_centre_distance = std::min(group.min_centre_distance, (level[i].head<2>() - search.centre).norm());
  }
  for (std::uint32_t c = 0; c < unique.size(); ++c) {
    out.middle[c] /= count[c];
    out.groups[out.group[c]].id = out.group[c];
    out.groups[out.group[c]].cells.push_back(c);
  }
  return out;
}

// The part that is taken for the plant: the largest that comes near the centre, and not one that ends at the soil's
// crumbs.
std::uint32_t core_of(const Cells& cells, const PartSearch& search) {
  std::uint32_t best = 0;
  double best_score = -1;
  for (const auto& g : cells.groups) {
    double score = static_cast<double>(g.points);
    if (search.reach > 0 && g.min_centre_distance > search.reach) score *= 0.01;
    if (score > best_score) {
      best_score = score;
      best = g.id;
    }
  }
  return best;
}

}  // namespace

PlantParts plant_parts(const Points3& level, const PartSearch& search, const Run& run) {
  PlantParts out;
  out.kind.assign(level.size(), 0);
  if (level.empty()) return out;
  const Cells cells = cells_of(level, search);
  out.parts = cells.groups.size();
  const auto core = core_of(cells, search);
  const auto core_points = static_cast<double>(cells.groups[core].points);
  std::vector<bool> joined(cells.groups.size(), false);
  joined[core] = true;

  // Parts join across gaps, the narrowest first; a small part must be near, a large one may be further.
  const PointGrid grid(cells.middle, std::max(search.link, search.max_gap / 2));
  const auto allowed = [&](const Group& g) {
    const double share = static_cast<double>(g.points) / core_points;
    if (g.points < 8) return 1.5 * search.link;
    if (share < 0.002) return std::min(search.max_gap, 2.5 * search.link);
    if (share < 0.02) return search.max_gap;
    return 2 * search.max_gap;
  };
  std::map<std::pair<double, std::uint32_t>, std::uint32_t> queue;  // by gap and group
  std::vector<double> gap(cells.groups.size(), std::numeric_limits<double>::max());
  const auto spread = [&](std::uint32_t group) {
    for (const auto cell : cells.groups[group].cells) {
      grid.near(cells.middle[cell], 2 * search.max_gap + search.link, [&](std::uint32_t other, double d2) {
        const auto g = cells.group[other];
        if (joined[g]) return;
        const double d = std::sqrt(d2);
        if (d >= gap[g] || d > allowed(cells.groups[g])) return;
        if (gap[g] < std::numeric_limits<double>::max()) queue.erase({gap[g], g});
        gap[g] = d;
        queue[{d, g}] = g;
      });
    }
  };
  spread(core);
  while (!queue.empty()) {
    run.check_cancel();
    const auto next = queue.begin()->second;
    const double d = queue.begin()->first.first;
    queue.erase(queue.begin());
    joined[next] = true;
    ++out.joined;
    out.widest_gap = std::max(out.widest_gap, d);
    spread(next);
  }
  out.soil_gap = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < level.size(); ++i) {
    const auto g = cells.group[cells.of_point[i]];
    const bool large = static_cast<double>(cells.groups[g].points) > 0.05 * core_points && cells.groups[g].points > 50;
    out.kind[i] = joined[g] ? 1 : large ? 2 : 0;
    if (joined[g]) out.soil_gap = std::min(out.soil_gap, level[i].z() - search.soil_height);
  }
  return out;
}

std::optional<FoundBase> find_base(const Points3& plant, const Eigen::Vector2d& centre, double soil_height, double unit,
                                   double link) {
  // Strands: connected parts of the points in a layer above the soil. The stem is the one that fills the layer's whole
  // height, is narrow, and has the most of the plant above it.
  constexpr int layers = 6;
  const double bottom = soil_height + 0.15 * unit, top = soil_height + 1.2 * unit;
  Points3 low;
  for (const auto& p : plant)
    if (p.z() > bottom && p.z() < top) low.push_back(p);
  if (low.size() < 5) return std::nullopt;
  std::vector<std::uint64_t> keys(low.size());
  for (std::size_t i = 0; i < low.size(); ++i) keys[i] = voxel_key(low[i], 1.5 * link);
  auto unique = keys;
  std::ranges::sort(unique);
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  const auto groups = connected_groups(unique);
  std::map<std::uint32_t, Points3> strands;
  for (std::size_t i = 0; i < low.size(); ++i)
    strands[groups[static_cast<std::size_t>(std::ranges::lower_bound(unique, keys[i]) - unique.begin())]].push_back(
        low[i]);
  std::optional<FoundBase> best;
  double best_score = 0;
  for (const auto& [id, points] : strands) {
    std::array<std::vector<double>, layers> x, y;
    for (const auto& p : points) {
      const auto layer = static_cast<std::size_t>(
          std::clamp(static_cast<int>((p.z() - bottom) / (top - bottom) * layers), 0, layers - 1));
      x[layer].push_back(p.x());
      y[layer].push_back(p.y());
    }
    int filled = 0;
    std::vector<double> width;
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d b = Eigen::Matrix2d::Zero();
    for (std::size_t layer = 0; layer < layers; ++layer) {
      if (x[layer].empty()) continue;
      ++filled;
      const Eigen::Vector2d middle(median(x[layer]), median(y[layer]));
      std::vector<double> off;
      for (std::size_t k = 0; k < x[layer].size(); ++k)
        off.push_back((Eigen::Vector2d(x[layer][k], y[layer][k]) - middle).norm());
      width.push_back(median(off));
      const double w = 1 / (0.2 * unit + width.back());
      const double z = bottom - soil_height + (static_cast<double>(layer) + 0.5) * (top - bottom) / layers;
      const Eigen::Vector2d row(1, z);
      a += w * row * row.transpose();
      b += w * row * middle.transpose();
    }
    if (filled < 2) continue;
    a(1, 1) += 1e-3 * a(0, 0) * unit * unit;
    const Eigen::Matrix2d line = a.ldlt().solve(b);
    const Eigen::Vector2d place = line.row(0).transpose();
    const double spread = median(width);
    const double score = filled / (0.3 * unit + spread + 0.15 * (place - centre).norm());
    if (best && score <= best_score) continue;
    best_score = score;
    best = FoundBase{place, spread / std::sqrt(static_cast<double>(filled)) + 0.05 * unit};
  }
  return best;
}

}  // namespace bole::plant
