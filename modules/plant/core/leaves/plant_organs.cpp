#include "plant/core/leaves/plant_organs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/statistics.h"
#include "plant/core/leaves/branching.h"
#include "plant/core/leaves/leaf_node.h"

namespace bole::plant {
namespace {

class Finding {
 public:
  Finding(const Points3& plant, const OrganScales& s, const Run& run) : plant_(plant), s_(s), run_(run) {}

  PlantOrgans all() {
    link();
    out_.gaps = graph_.gaps;
    out_.widest_gap = graph_.widest_gap;
    out_.organ_of_point.assign(plant_.size(), -1);
    if (graph_.size() < 20) return std::move(out_);
    run_.report(0.4, "stem and leaves");
    from_foot_ = distances_from(graph_, foot(), run_);
    step_ = 2 * graph_.cell;
    levels_ = levels_of(graph_, from_foot_, step_);
    BranchingScales scales{0.5 * s_.unit, 0.2 * s_.unit, 0.75 * s_.unit, 0.3 * s_.unit};
    branching_ = branching_of(levels_, organ_ends(graph_, from_foot_, scales.tip), scales);
    if (branching_.axes.empty()) return std::move(out_);
    label();
    join_fragments();
    find_axes();
    run_.report(0.6, "leaves");
    measure_organs();
    drop_bare_branches();
    order_leaves();
    count_lost();
    return std::move(out_);
  }

 private:
  // Nodes as near as the points allow: where many have few neighbours, they are taken further apart.
  void link() {
    double cell = std::max({0.05 * s_.unit, 1.2 * s_.spacing, 0.8 * s_.noise});
    for (;; cell *= 1.4) {
      graph_ = plant_graph(plant_, cell, s_.noise, s_.max_gap, run_.part(0, 0.4));
      std::size_t lonely = 0;  // on a full sheet a node has about 15 links
      for (std::size_t i = 0; i < graph_.size(); ++i) lonely += graph_.first[i + 1] - graph_.first[i] < 4;
      out_.sparse = 4 * lonely > graph_.size();
      if (!out_.sparse || 1.4 * cell > 0.2 * s_.unit) return;
    }
  }

  // Nodes at the lower end of the plant near the origin, of what most of it is connected with.
  std::vector<std::uint32_t> foot() const {
    const auto connected = largest_part(graph_);
    const double reach = 0.4 * s_.unit;
    double low = std::numeric_limits<double>::infinity(), near = low;
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 0; i < graph_.size(); ++i) {
      const auto& p = graph_.places[i];
      if (!connected[i]) continue;
      if (p.head<2>().norm() < reach) low = std::min(low, p.z());
      if (p.norm() < near) {
        near = p.norm();
        nearest = i;
      }
    }
    if (low > 2 * s_.unit) return {nearest};
    std::vector<std::uint32_t> out;
    for (std::uint32_t i = 0; i < graph_.size(); ++i) {
      const auto& p = graph_.places[i];
      if (connected[i] && p.head<2>().norm() < reach && p.z() < low + 0.15 * s_.unit) out.push_back(i);
    }
    return out;
  }

  Points3 middles_of(const std::vector<std::uint32_t>& levels) const {
    Points3 out;
    for (const auto l : levels) out.push_back(levels_.levels[l].middle);
    return out;
  }

  // Every node goes to the axis or the organ whose middle it is nearest to along the sheets.
  void label() {
    std::vector<int> axis_of_level(levels_.levels.size(), -1), organ_of_level(levels_.levels.size(), -1);
    for (std::size_t a = 0; a < branching_.axes.size(); ++a)
      for (const auto l : branching_.axes[a].levels) axis_of_level[l] = static_cast<int>(a);
    for (std::size_t o = 0; o < branching_.organs.size(); ++o)
      for (const auto l : branching_.organs[o].levels) organ_of_level[l] = static_cast<int>(o);
    std::vector<std::uint32_t> starts;
    std::vector<int> labels;  // axes as -1 - number
    for (std::uint32_t i = 0; i < graph_.size(); ++i) {
      const auto l = levels_.of_node[i];
      if (l == no_node || axis_of_level[l] < 0) continue;
      if ((graph_.places[i] - levels_.levels[l].middle).norm() > 0.6 * s_.unit) continue;
      starts.push_back(i);
      labels.push_back(-1 - axis_of_level[l]);
    }
    for (std::size_t o = 0; o < branching_.organs.size(); ++o) {
      const auto& organ = branching_.organs[o];
      for (auto at = organ.end; at != no_node; at = from_foot_.previous[at]) {
        // Side levels that end nowhere lie on the way too.
        const auto l = levels_.of_node[at];
        if (axis_of_level[l] >= 0 || (organ_of_level[l] >= 0 && organ_of_level[l] != static_cast<int>(o))) break;
        starts.push_back(at);
        labels.push_back(static_cast<int>(o));
      }
    }
    nearest_ = distances_from(graph_, starts, run_);
    label_.assign(graph_.size(), nothing);
    for (std::size_t i = 0; i < graph_.size(); ++i)
      if (nearest_.origin[i] != no_node) label_[i] = labels[nearest_.origin[i]];
  }

  // A slit in a blade makes two ends of it. The smaller part goes back where the sheet goes on over their border.
  void join_fragments() {
    std::vector<std::size_t> sizes(branching_.organs.size(), 0);
    for (const int l : label_)
      if (l >= 0 && l < nothing) ++sizes[static_cast<std::size_t>(l)];
    for (std::size_t o = 0; o < branching_.organs.size(); ++o) {
      if (!branching_.organs[o].through_other) continue;
      std::map<int, std::pair<double, double>> borders;  // links to each other organ: all, and smooth ones
      for (std::uint32_t i = 0; i < graph_.size(); ++i) {
        if (label_[i] != static_cast<int>(o)) continue;
        for (auto l = graph_.first[i]; l < graph_.first[i + 1]; ++l) {
          const auto k = graph_.neighbour[l];
          if (label_[k] < 0 || label_[k] >= nothing || label_[k] == label_[i]) continue;
          auto& border = borders[label_[k]];
          border.first += 1;
          border.second += graph_.cost[l] < 1.5 * (graph_.places[k] - graph_.places[i]).norm();
        }
      }
      for (const auto& [other, links] : borders) {
        if (links.first < 20 || links.second < 0.6 * links.first) continue;
        if (static_cast<double>(sizes[o]) > 0.35 * static_cast<double>(sizes[static_cast<std::size_t>(other)]))
          continue;
        for (auto& l : label_)
          if (l == static_cast<int>(o)) l = other;
        break;
      }
    }
  }

  void find_axes() {
    for (std::size_t a = 0; a < branching_.axes.size(); ++a) {
      Points3 points;
      for (std::size_t i = 0; i < plant_.size(); ++i)
        if (label_[graph_.node_of_point[i]] == -1 - static_cast<int>(a)) points.push_back(plant_[i]);
      auto middles = middles_of(branching_.axes[a].levels);
      PlantAxisFound axis;
      axis.parent = branching_.axes[a].parent;
      axis.curve = axis_curve(middles, points, {0.1 * s_.unit, 0.3 * s_.unit, (a == 0 ? 0.35 : 0.25) * s_.unit});
      if (axis.parent >= 0) {
        join(axis, a);
      } else {
        to_soil(axis.curve);
      }
      out_.axes.push_back(std::move(axis));
    }
  }

  static void prepend(AxisCurve& curve, const Eigen::Vector3d& place) {
    const double more = (curve.places.front() - place).norm();
    if (!(more > 0)) return;
    curve.places.insert(curve.places.begin(), place);
    curve.radii.insert(curve.radii.begin(), std::numeric_limits<double>::quiet_NaN());
    for (auto& s : curve.arc) s += more;
    curve.arc.insert(curve.arc.begin(), 0.0);
  }

  // From its lowest place straight on to the soil, or up to it.
  void to_soil(AxisCurve& curve) const {
    while (curve.places.size() > 3 && curve.places.front().z() < 0) {
      curve.places.erase(curve.places.begin());
      curve.radii.erase(curve.radii.begin());
      curve.arc.erase(curve.arc.begin());
    }
    if (curve.places.size() < 2) return;
    const double first = curve.arc.front();
    for (auto& s : curve.arc) s -= first;
    const Eigen::Vector3d up = curve.tangent(0.3 * s_.unit, 0.3 * s_.unit);
    const double drop = curve.places.front().z();
    if (drop > 0 && up.z() > 0.3) prepend(curve, curve.places.front() - drop / up.z() * up);
  }

  // A branch begins where its lower end meets the middle of its parent.
  void join(PlantAxisFound& axis, std::size_t number) {
    const auto& parent = out_.axes[static_cast<std::size_t>(axis.parent)].curve;
    if (axis.curve.empty() || parent.empty()) return;
    const double contact = parent.nearest(levels_.levels[branching_.axes[number].leaves_at].middle).along;
    Points3 lower;
    for (std::size_t i = 0; i < axis.curve.places.size() && axis.curve.arc[i] < 0.6 * s_.unit; ++i)
      lower.push_back(axis.curve.places[i]);
    const auto node = leaf_node(parent, lower, contact, node_scales());
    axis.parent_arc = node.along;
    axis.angle = node.angle;
    prepend(axis.curve, parent.at(node.along));
  }

  NodeScales node_scales() const { return {0.025 * s_.unit, s_.unit, 0.2 * s_.unit, 0.25 * s_.unit}; }

  void measure_organs() {
    std::vector<std::vector<std::uint32_t>> points(branching_.organs.size());
    for (std::uint32_t i = 0; i < plant_.size(); ++i)
      if (const int l = label_[graph_.node_of_point[i]]; l >= 0 && l < nothing)
        points[static_cast<std::size_t>(l)].push_back(i);
    leaf_of_organ_.assign(branching_.organs.size(), -1);
    for (std::size_t o = 0; o < branching_.organs.size(); ++o) {
      run_.check_cancel();
      measure_organ(o, points[o]);
    }
    for (std::size_t i = 0; i < plant_.size(); ++i)
      if (const int l = label_[graph_.node_of_point[i]]; l >= 0 && l < nothing)
        out_.organ_of_point[i] = leaf_of_organ_[static_cast<std::size_t>(l)];
    find_touching();
  }

  void measure_organ(std::size_t number, const std::vector<std::uint32_t>& members) {
    const auto& organ = branching_.organs[number];
    auto& own = out_.axes[static_cast<std::size_t>(organ.axis)].curve;
    if (own.empty()) return;
    // The axis goes on straight to the node of its last leaf.
    const auto axis = organ.ends_axis ? extended(own, 1.2 * s_.unit, s_.unit) : own;
    Points3 points;
    std::vector<double> distance;
    for (const auto i : members) {
      const auto& p = plant_[i];
      const auto near = axis.nearest(p);
      const double radius = axis.radius_at(near.along);
      if (std::isfinite(radius) && near.distance < 1.2 * radius) continue;  // of the stem
      points.push_back(p);
      distance.push_back(from_foot_.value[graph_.node_of_point[i]]);
    }
    Leaf leaf;
    leaf.sheet = leaf_sheet(points, distance, {0.8 * graph_.cell, 0.15 * s_.unit, s_.noise, 0.3 * s_.unit});
    const double smallest = 0.125 * s_.unit * s_.unit;
    const bool crumbs = std::ranges::all_of(points, [&](const auto& p) { return p.z() < 0.5 * s_.unit; });
    if (!leaf.sheet.blade || leaf.sheet.area < smallest || crumbs) {
      ++out_.twigs;
      return;
    }
    leaf.axis = organ.axis;
    const double contact = axis.nearest(levels_.levels[organ.leaves_at].middle).along;
    auto scales = node_scales();
    if (organ.ends_axis) {
      scales.above = 1.2 * s_.unit;
      // Farther from the blade they may be of the stem.
      std::erase_if(leaf.sheet.stalk_middles,
                    [&](const auto& p) { return (p - leaf.sheet.blade_foot).norm() > 0.35 * s_.unit; });
    }
    const auto node = leaf_node(axis, leaf.sheet.stalk_middles, contact, scales);
    leaf.arc = node.along;
    leaf.node = axis.at(node.along);
    leaf.direction = node.direction;
    leaf.angle = node.angle;
    const double radius = axis.radius_at(node.along);
    leaf.petiole = std::max(0.0, (leaf.sheet.blade_foot - leaf.node).norm() - (std::isfinite(radius) ? radius : 0));
    if (organ.ends_axis) {
      out_.stem_ends_in_leaf = out_.stem_ends_in_leaf || organ.axis == 0;
      if (node.along > own.length()) own = extended(own, node.along - own.length(), s_.unit);
    }
    leaf.on_other = organ.through_other;
    if (organ.through_other) leaf.doubt = "its petiole was not found: it hangs on another leaf";
    if (!node.good && leaf.doubt.empty()) leaf.doubt = "where it stands on the stem is uncertain";
    leaf_of_organ_[number] = static_cast<int>(out_.leaves.size());
    out_.leaves.push_back(std::move(leaf));
  }

  // Leaves that share a long border may have parts of one another.
  void find_touching() {
    std::map<std::pair<int, int>, std::size_t> borders;
    for (std::uint32_t i = 0; i < graph_.size(); ++i) {
      if (label_[i] < 0 || label_[i] >= nothing) continue;
      const int one = leaf_of_organ_[static_cast<std::size_t>(label_[i])];
      std::vector<int> met;
      for (auto l = graph_.first[i]; l < graph_.first[i + 1]; ++l) {
        const int k = label_[graph_.neighbour[l]];
        if (k < 0 || k >= nothing || k == label_[i]) continue;
        const int other = leaf_of_organ_[static_cast<std::size_t>(k)];
        if (one >= 0 && other >= 0 && std::ranges::find(met, other) == met.end()) met.push_back(other);
      }
      for (const int other : met) ++borders[{one, other}];
    }
    for (const auto& [pair, nodes] : borders)
      if (static_cast<double>(nodes) * graph_.cell > 0.3 * s_.unit)
        out_.leaves[static_cast<std::size_t>(pair.first)].touching.push_back(pair.second);
  }

  // A branch with one leaf is the petiole of that leaf; one without is a twig.
  void drop_bare_branches() {
    for (auto a = out_.axes.size(); a-- > 1;) {
      const int number = static_cast<int>(a);
      const auto carried = std::ranges::count(out_.leaves, number, &Leaf::axis) +
                           std::ranges::count(out_.axes, number, &PlantAxisFound::parent);
      if (carried >= 2 && !out_.axes[a].curve.empty()) continue;
      const auto& axis = out_.axes[a];
      const auto& parent = out_.axes[static_cast<std::size_t>(axis.parent)].curve;
      for (auto& leaf : out_.leaves) {
        if (leaf.axis != number) continue;
        leaf.axis = axis.parent;
        leaf.arc = axis.parent_arc;
        leaf.node = parent.empty() ? leaf.node : parent.at(axis.parent_arc);
        leaf.angle = axis.angle;
        leaf.petiole = (leaf.sheet.blade_foot - leaf.node).norm();
        if (!axis.curve.empty()) leaf.direction = axis.curve.tangent(0.3 * s_.unit, 0.3 * s_.unit);
        if (leaf.doubt.empty()) leaf.doubt = "its petiole looks like a branch";
      }
      for (auto& other : out_.axes)
        if (other.parent == number) {
          other.parent = axis.parent;
          other.parent_arc = axis.parent_arc;
        }
      out_.axes.erase(out_.axes.begin() + number);
      for (auto& other : out_.axes) other.parent -= other.parent > number;
      for (auto& leaf : out_.leaves) leaf.axis -= leaf.axis > number;
    }
  }

  void order_leaves() {
    std::vector<std::size_t> order(out_.leaves.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](auto a, auto b) {
      const auto &x = out_.leaves[a], &y = out_.leaves[b];
      return x.axis != y.axis ? x.axis < y.axis : x.arc < y.arc;
    });
    std::vector<int> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int>(i);
    std::vector<Leaf> sorted;
    for (const auto i : order) {
      sorted.push_back(std::move(out_.leaves[i]));
      for (auto& t : sorted.back().touching) t = place[static_cast<std::size_t>(t)];
      std::ranges::sort(sorted.back().touching);
    }
    out_.leaves = std::move(sorted);
    for (auto& leaf : out_.organ_of_point)
      if (leaf >= 0) leaf = place[static_cast<std::size_t>(leaf)];
  }

  void count_lost() {
    std::size_t lost = 0;
    for (const auto node : graph_.node_of_point) lost += !std::isfinite(from_foot_.value[node]);
    out_.lost_share = static_cast<double>(lost) / static_cast<double>(plant_.size());
  }

  static constexpr int nothing = std::numeric_limits<int>::max();

  const Points3& plant_;
  const OrganScales& s_;
  const Run& run_;
  PlantGraph graph_;
  Distances from_foot_, nearest_;
  double step_ = 0;
  Levels levels_;
  Branching branching_;
  std::vector<int> label_, leaf_of_organ_;
  PlantOrgans out_;
};

}  // namespace

PlantOrgans find_organs(const Points3& plant, const OrganScales& scales, const Run& run) {
  return Finding(plant, scales, run).all();
}

}  // namespace bole::plant
