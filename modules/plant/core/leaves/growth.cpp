#include "plant/core/leaves/growth.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace bole::plant {
namespace {

constexpr double max_smooth_cost = 2;  // of a link, in its lengths

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) {
    parent[i] = parent[parent[i]];
    i = parent[i];
  }
  return i;
}

}  // namespace

Distances distances_from(const PlantGraph& graph, const std::vector<std::uint32_t>& starts, const Run& run) {
  Distances out;
  out.value.assign(graph.size(), std::numeric_limits<double>::infinity());
  out.previous.assign(graph.size(), no_node);
  out.origin.assign(graph.size(), no_node);
  using Item = std::pair<double, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (std::uint32_t k = 0; k < starts.size(); ++k) {
    if (out.value[starts[k]] == 0) continue;
    out.value[starts[k]] = 0;
    out.origin[starts[k]] = k;
    queue.emplace(0, starts[k]);
  }
  for (std::size_t popped = 0; !queue.empty(); ++popped) {
    if (popped % 65536 == 0) run.check_cancel();
    const auto [d, i] = queue.top();
    queue.pop();
    if (d > out.value[i]) continue;
    for (auto l = graph.first[i]; l < graph.first[i + 1]; ++l) {
      const auto k = graph.neighbour[l];
      const double through = d + graph.cost[l];
      if (!(through < out.value[k])) continue;
      out.value[k] = through;
      out.previous[k] = i;
      out.origin[k] = out.origin[i];
      queue.emplace(through, k);
    }
  }
  return out;
}

std::vector<bool> largest_part(const PlantGraph& graph) {
  std::vector<std::uint32_t> part(graph.size(), no_node), stack, sizes;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    if (part[i] != no_node) continue;
    const auto number = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    part[i] = number;
    stack.assign(1, i);
    while (!stack.empty()) {
      const auto at = stack.back();
      stack.pop_back();
      ++sizes[number];
      for (auto l = graph.first[at]; l < graph.first[at + 1]; ++l)
        if (part[graph.neighbour[l]] == no_node) {
          part[graph.neighbour[l]] = number;
          stack.push_back(graph.neighbour[l]);
        }
    }
  }
  const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
  std::vector<bool> out(graph.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = part[i] == largest;
  return out;
}

std::vector<OrganEnd> organ_ends(const PlantGraph& graph, const Distances& from_foot, double min_length) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    if (std::isfinite(from_foot.value[i])) order.push_back(i);
  const auto further = [&](std::uint32_t a, std::uint32_t b) {
    return from_foot.value[a] != from_foot.value[b] ? from_foot.value[a] > from_foot.value[b] : a < b;
  };
  std::ranges::sort(order, further);
  // Parts beyond a distance, while it falls: each is known by its furthest node.
  std::vector<std::uint32_t> parent(graph.size(), no_node);
  std::vector<std::uint32_t> furthest(graph.size(), no_node);
  std::vector<OrganEnd> out;
  for (const auto i : order) {
    parent[i] = i;
    furthest[i] = i;
    for (auto l = graph.first[i]; l < graph.first[i + 1]; ++l) {
      const auto k = graph.neighbour[l];
      if (parent[k] == no_node) continue;
      auto a = root_of(parent, i), b = root_of(parent, k);
      if (a == b) continue;
      if (further(furthest[b], furthest[a])) std::swap(a, b);
      const double stands_out = from_foot.value[furthest[b]] - from_foot.value[i];
      if (stands_out >= min_length) out.push_back({furthest[b], stands_out});
      parent[b] = a;
    }
  }
  if (!order.empty()) out.push_back({order.front(), from_foot.value[order.front()]});
  std::ranges::sort(out, [&](const auto& a, const auto& b) { return further(a.node, b.node); });
  return out;
}

Levels levels_of(const PlantGraph& graph, const Distances& from_foot, double step) {
  Levels out;
  out.of_node.assign(graph.size(), no_node);
  const auto step_of = [&](std::uint32_t i) { return std::floor(from_foot.value[i] / step); };
  std::vector<std::uint32_t> stack, members;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    if (out.of_node[i] != no_node || !std::isfinite(from_foot.value[i])) continue;
    const auto number = static_cast<std::uint32_t>(out.levels.size());
    out.of_node[i] = number;
    stack.assign(1, i);
    members.clear();
    while (!stack.empty()) {
      const auto at = stack.back();
      stack.pop_back();
      members.push_back(at);
      for (auto l = graph.first[at]; l < graph.first[at + 1]; ++l) {
        const auto k = graph.neighbour[l];
        if (out.of_node[k] != no_node || step_of(k) != step_of(i) || !std::isfinite(from_foot.value[k])) continue;
        // What touches without going on smoothly is another sheet.
        if (graph.cost[l] > max_smooth_cost * (graph.places[k] - graph.places[at]).norm()) continue;
        out.of_node[k] = number;
        stack.push_back(k);
      }
    }
    Level level;
    level.nodes = members.size();
    for (const auto m : members) {
      level.middle += graph.places[m];
      level.distance += from_foot.value[m];
    }
    level.middle /= static_cast<double>(members.size());
    level.distance /= static_cast<double>(members.size());
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const auto m : members) {
      const Eigen::Vector3d d = graph.places[m] - level.middle;
      squares += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares / static_cast<double>(members.size()),
                                                                Eigen::EigenvaluesOnly);
    level.breadth = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[2]));
    level.depth = std::sqrt(12 * std::max(0.0, solver.eigenvalues()[1]));
    out.levels.push_back(level);
  }
  // The way to the foot from the node of a level that is nearest to it leads to the level below.
  std::vector<std::uint32_t> nearest(out.levels.size(), no_node);
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const auto l = out.of_node[i];
    if (l == no_node) continue;
    if (nearest[l] == no_node || from_foot.value[i] < from_foot.value[nearest[l]]) nearest[l] = i;
  }
  for (std::uint32_t l = 0; l < out.levels.size(); ++l) {
    auto at = nearest[l];
    while (at != no_node && out.of_node[at] == l) at = from_foot.previous[at];
    if (at != no_node) out.levels[l].parent = out.of_node[at];
  }
  return out;
}

}  // namespace bole::plant
