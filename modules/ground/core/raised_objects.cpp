#include "ground/core/raised_objects.h"

#include <algorithm>
#include <cmath>

#include "base/groups.h"

namespace bole::ground {
namespace {

constexpr std::uint32_t no_point = ~std::uint32_t{0};
constexpr double min_falling_share = 0.8;  // of the pairs across the rim that show a step
constexpr double min_falling_rim = 4;      // such pairs by the side of a square of the object's size, in cells
constexpr int max_rounds = 6;              // the parts of a steep roof come off from its ridge down
constexpr int reach_cells = 2;

}  // namespace

std::vector<char> raised_objects(const std::vector<LowPoint>& candidates, const GridShape& shape,
                                 const RaisedLimits& limits, const Run& run) {
  std::vector<std::uint32_t> at(shape.cells(), no_point);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) at[candidates[i].cell] = i;
  // f(other) for the candidates near i, each pair once.
  const auto for_each_pair = [&](const auto& f) {
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
      if (i % 65536 == 0) run.check_cancel();
      const int ix = static_cast<int>(candidates[i].cell % static_cast<std::uint32_t>(shape.nx)),
                iy = static_cast<int>(candidates[i].cell / static_cast<std::uint32_t>(shape.nx));
      for (int dy = 0; dy <= reach_cells; ++dy)
        for (int dx = dy == 0 ? 1 : -reach_cells; dx <= reach_cells; ++dx) {
          if (!shape.contains(ix + dx, iy + dy)) continue;
          const auto j = at[shape.index(ix + dx, iy + dy)];
          if (j != no_point) f(i, j);
        }
    }
  };
  const auto joined = [&](std::uint32_t i, std::uint32_t j) {
    const Eigen::Vector3d d = candidates[i].position - candidates[j].position;
    return std::abs(d.z()) <= limits.join_slope_tan * d.head<2>().norm() + limits.roughness_m;
  };
  Groups groups(candidates.size());
  for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    if (joined(i, j)) groups.join(i, j);
  });
  std::vector<std::uint32_t> group(candidates.size());
  std::vector<double> cells(candidates.size(), 0);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    group[i] = static_cast<std::uint32_t>(groups.root(i));
    ++cells[group[i]];
  }
  const auto terrain = static_cast<std::uint32_t>(std::max_element(cells.begin(), cells.end()) - cells.begin());
  std::vector<char> raised(candidates.size(), 0);  // by group
  for (int round = 0; round < max_rounds; ++round) {
    std::vector<int> falling(candidates.size(), 0), rising(candidates.size(), 0);
    for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      const auto a = group[i], b = group[j];
      if (a == b || raised[a] || raised[b]) return;
      const double dz = candidates[i].position.z() - candidates[j].position.z();
      if (std::abs(dz) < limits.step_m) return;
      ++(dz > 0 ? falling : rising)[a];
      ++(dz > 0 ? rising : falling)[b];
    });
    bool found = false;
    for (std::uint32_t g = 0; g < candidates.size(); ++g) {
      const int steps = falling[g] + rising[g];
      if (raised[g] || g == terrain || cells[g] * shape.cell_m * shape.cell_m > limits.max_area_m2) continue;
      if (falling[g] < min_falling_share * steps || falling[g] < min_falling_rim * std::sqrt(cells[g])) continue;
      raised[g] = 1;
      found = true;
    }
    if (!found) break;
  }
  std::vector<char> out(candidates.size(), 0);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) out[i] = raised[group[i]];
  return out;
}

}  // namespace bole::ground
