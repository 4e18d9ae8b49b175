#include "rgbd/core/matching/view_graph.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>

#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

struct Neighbour {
  int node;
  Pose T_node_this;
};

class Forest {
 public:
  explicit Forest(int nodes) : parent_(at(nodes)) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
    return i;
  }
  bool join(int a, int b) {
    a = find(a), b = find(b);
    if (a == b) return false;
    parent_[at(std::max(a, b))] = std::min(a, b);
    return true;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace

SpannedPoses span_poses(int nodes, const std::vector<GraphEdge>& edges, int root) {
  std::vector<std::size_t> order(edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(-edges[i].weight, edges[i].a, edges[i].b); });
  Forest forest(nodes);
  std::vector<std::vector<Neighbour>> tree(at(nodes));
  for (const auto i : order) {
    const auto& e = edges[i];
    if (!forest.join(e.a, e.b)) continue;
    tree[at(e.a)].push_back({e.b, e.T_b_a});
    tree[at(e.b)].push_back({e.a, e.T_b_a.inverse()});
  }
  std::map<int, int> sizes;
  for (int i = 0; i < nodes; ++i) ++sizes[forest.find(i)];
  int largest = 0;
  for (const auto& [part, size] : sizes) {
    // Of two parts of one size the one with the root, then the first.
    const bool with_root = forest.find(root) == part;
    if (largest == 0 || size > sizes[forest.find(largest - 1)] ||
        (size == sizes[forest.find(largest - 1)] && with_root))
      largest = part + 1;
  }
  const int part = largest - 1;
  SpannedPoses out;
  out.T_root_node.resize(at(nodes));
  if (nodes == 0) return out;
  out.root = forest.find(root) == part ? root : part;
  out.nodes = sizes[part];
  std::queue<int> open;
  open.push(out.root);
  out.T_root_node[at(out.root)] = Pose::Identity();
  while (!open.empty()) {
    const int node = open.front();
    open.pop();
    for (const auto& n : tree[at(node)]) {
      if (out.T_root_node[at(n.node)]) continue;
      out.T_root_node[at(n.node)] = *out.T_root_node[at(node)] * n.T_node_this.inverse();
      open.push(n.node);
    }
  }
  return out;
}

std::vector<char> contradicted(int nodes, const std::vector<GraphEdge>& edges, double max_turn_rad, double max_shift) {
  std::vector<std::map<int, std::size_t>> of(at(nodes));  // edge to a neighbour
  for (std::size_t i = 0; i < edges.size(); ++i) {
    of[at(edges[i].a)][edges[i].b] = i;
    of[at(edges[i].b)][edges[i].a] = i;
  }
  const auto motion = [&](std::size_t e, int from) {  // to the other end
    return edges[e].a == from ? edges[e].T_b_a : edges[e].T_b_a.inverse();
  };
  std::vector<int> agree(edges.size(), 0), against(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int a = edges[i].a, b = edges[i].b;
    for (const auto& [c, ac] : of[at(a)]) {
      const auto bc = of[at(b)].find(c);
      if (c == b || bc == of[at(b)].end()) continue;
      const Pose ring = motion(ac, a).inverse() * motion(bc->second, b) * edges[i].T_b_a;
      const bool same =
          so3_log(Eigen::Quaterniond(ring.linear())).norm() <= max_turn_rad && ring.translation().norm() <= max_shift;
      ++(same ? agree : against)[i];
    }
  }
  std::vector<char> out(edges.size(), 0);
  for (std::size_t i = 0; i < edges.size(); ++i) out[i] = against[i] > agree[i] ? 1 : 0;
  return out;
}

}  // namespace bole::rgbd
