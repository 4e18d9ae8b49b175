#include "plant/core/leaves/branching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>

#include "base/statistics.h"

namespace bole::plant {
namespace {

constexpr double straight_on = 0.85;  // cosine of a turn that a bare tip may make
constexpr double last_on = 0.7;       // the same where the way on ends in the last leaf, which itself turns away

class Growing {
 public:
  Growing(const Levels& levels, const std::vector<OrganEnd>& ends, const BranchingScales& s)
      : l_(levels.levels),
        s_(s),
        of_node_(levels.of_node),
        ends_(l_.size(), 0),
        children_(l_.size()),
        end_node_(l_.size(), no_node) {
    for (const auto& e : ends) {
      if (e.stands_out < s.organ) {
        short_ends_.push_back(of_node_[e.node]);
        continue;
      }
      auto at = of_node_[e.node];
      if (end_node_[at] != no_node) continue;
      end_node_[at] = e.node;
      for (; at != no_node; at = l_[at].parent) {
        if (ends_[at]++ > 0 || l_[at].parent == no_node) continue;
        children_[l_[at].parent].push_back(at);
      }
    }
    for (auto& c : children_) std::ranges::sort(c);
  }

  Branching all() {
    std::uint32_t root = no_node;
    for (std::uint32_t i = 0; i < l_.size(); ++i)
      if (l_[i].parent == no_node && ends_[i] > 0 && (root == no_node || ends_[i] > ends_[root])) root = i;
    if (root == no_node) return {};
    grow({root, -1, no_node});
    while (!waiting_.empty()) {
      const auto next = waiting_.front();
      waiting_.pop_front();
      grow_side(next);
    }
    return std::move(out_);
  }

 private:
  struct Side {
    std::uint32_t start;
    int axis;
    std::uint32_t leaves_at;
  };

  // The level about `length` further on; where ways part, the one with more ends.
  std::uint32_t ahead(std::uint32_t from, double length) const {
    auto at = from;
    while (!children_[at].empty() && (l_[at].middle - l_[from].middle).norm() < length)
      at = *std::ranges::max_element(children_[at], {}, [&](auto c) { return ends_[c]; });
    return at;
  }

  Eigen::Vector3d direction(std::uint32_t from, std::uint32_t to) const {
    const Eigen::Vector3d d = l_[to].middle - l_[from].middle;
    return d.norm() > 0 ? Eigen::Vector3d(d.normalized()) : Eigen::Vector3d::UnitZ().eval();
  }

  Eigen::Vector3d direction_behind(const std::vector<std::uint32_t>& chain) const {
    const auto last = chain.back();
    for (auto i = chain.size(); i-- > 0;)
      if ((l_[last].middle - l_[chain[i]].middle).norm() > s_.look) return direction(chain[i], last);
    if (chain.size() > 3) return direction(chain.front(), last);
    const auto far = ahead(chain.front(), s_.look);
    return out_.axes.size() <= 1 ? Eigen::Vector3d::UnitZ().eval() : direction(chain.front(), far);
  }

  // Follows an axis from its first level to the last one that carries more than one organ.
  void grow(const Side& side) {
    const int number = static_cast<int>(out_.axes.size());
    out_.axes.push_back({{side.start}, side.axis, side.leaves_at});
    std::vector<std::uint32_t> chain{side.start};
    std::vector<Side> sides;
    for (;;) {
      const auto at = chain.back();
      const auto& kids = children_[at];
      if (ends_[at] == 1 || kids.empty()) break;
      std::uint32_t best = no_node;
      double best_score = -10, best_turn = 0;
      const auto behind = direction_behind(chain);
      for (const auto c : kids) {
        const double turn = direction(at, ahead(c, s_.look)).dot(behind);
        const double share = static_cast<double>(ends_[c]) / ends_[at];
        const double score = turn + (ends_[c] >= 2 ? 0.6 : 0) + 0.4 * share;
        if (score <= best_score) continue;
        best_score = score;
        best_turn = turn;
        best = c;
      }
      const bool on = ends_[best] >= 2 || best_turn > last_on;
      for (const auto c : kids)
        if (!on || c != best) sides.push_back({c, number, at});
      if (!on) break;
      chain.push_back(best);
      if (cut_at_blade(chain, sides, number)) break;
    }
    out_.axes[static_cast<std::size_t>(number)].levels = chain;
    if (ends_[chain.back()] == 1) end_axis(number);
    waiting_.insert(waiting_.end(), sides.begin(), sides.end());
  }

  // An axis that runs on over a blade, to where it touches another, ends where the blade begins.
  bool cut_at_blade(std::vector<std::uint32_t>& chain, std::vector<Side>& sides, int number) const {
    constexpr std::size_t run = 6;  // levels; where petioles leave, fewer are broad
    if (chain.size() < 2 * run || ends_[chain.back()] > 3) return false;
    for (auto i = chain.size() - run; i < chain.size(); ++i)
      if (!broad(chain[i])) return false;
    const auto first = chain[chain.size() - run];
    std::erase_if(sides, [&](const auto& s) {
      return std::find(chain.end() - static_cast<std::ptrdiff_t>(run), chain.end(), s.leaves_at) != chain.end();
    });
    chain.resize(chain.size() - run);
    sides.push_back({first, number, chain.back()});
    return true;
  }

  bool broad(std::uint32_t level) const {
    return l_[level].breadth > s_.blade && l_[level].breadth > 1.8 * l_[level].depth;
  }

  // Beyond the last parting there is one end: the bare tip of the axis, or a last leaf, at whose node the axis may end
  // with a short bare tip of its own.
  void end_axis(int number) {
    auto& chain = out_.axes[static_cast<std::size_t>(number)].levels;
    std::vector<std::uint32_t> rest;
    for (auto at = chain.back(); !children_[at].empty();) {
      at = children_[at].front();
      rest.push_back(at);
    }
    if (rest.empty()) return;
    std::size_t blade = 0;
    while (blade < rest.size() && !is_blade(rest, blade)) ++blade;
    if (blade == rest.size()) {
      chain.insert(chain.end(), rest.begin(), rest.end());
      return;
    }
    const auto leaf_from = [&](std::size_t first) {
      return std::vector<std::uint32_t>(rest.begin() + static_cast<std::ptrdiff_t>(first), rest.end());
    };
    if (const auto tip = bare_tip(rest, blade, chain)) {
      chain.insert(chain.end(), rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(tip->first) + 1);
      const auto parting = chain.back();
      chain.insert(chain.end(), tip->second.begin(), tip->second.end());
      add_organ(rest.back(), leaf_from(tip->first + 1), number, parting, false);
      return;
    }
    add_organ(rest.back(), leaf_from(0), number, chain.back(), false);
    out_.organs.back().ends_axis = true;
  }

  bool is_blade(const std::vector<std::uint32_t>& chain, std::size_t i) const {
    // The open end of a tube is broad too, but only over a few levels.
    constexpr std::size_t window = 5;
    if (i + window > chain.size()) return false;
    std::size_t flat = 0;
    for (auto k = i; k < i + window; ++k) flat += broad(chain[k]);
    return flat + 1 >= window;
  }

  std::optional<std::pair<std::size_t, std::vector<std::uint32_t>>> bare_tip(
      const std::vector<std::uint32_t>& rest, std::size_t blade, const std::vector<std::uint32_t>& chain) const {
    const auto behind = direction_behind(chain);
    for (const auto end : short_ends_) {
      std::vector<std::uint32_t> way;
      auto at = end;
      std::ptrdiff_t found = -1;
      for (; at != no_node; at = l_[at].parent) {
        const auto it = std::find(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(blade), at);
        if (it != rest.begin() + static_cast<std::ptrdiff_t>(blade)) {
          found = it - rest.begin();
          break;
        }
        way.push_back(at);
      }
      if (found < 0 || way.empty() || direction(rest[static_cast<std::size_t>(found)], end).dot(behind) < straight_on)
        continue;
      std::ranges::reverse(way);
      return std::pair(static_cast<std::size_t>(found), way);
    }
    return std::nullopt;
  }

  // Something that leaves an axis: a leaf, a branch, or leaves that touch.
  void grow_side(const Side& side) {
    if (ends_[side.start] == 1) {
      add_organ(side.start, side.axis, side.leaves_at, false);
      return;
    }
    if (is_branch(side)) {
      grow(side);
      return;
    }
    part_touching(side, false);
  }

  // A branch is thin up to where it parts, and that is away from its axis.
  bool is_branch(const Side& side) const {
    std::vector<double> breadths;
    auto at = side.start;
    for (; children_[at].size() == 1; at = children_[at].front()) breadths.push_back(l_[at].breadth);
    if ((l_[at].middle - l_[side.leaves_at].middle).norm() < 0.8 * s_.organ || breadths.empty()) return false;
    const auto half = breadths.begin() + static_cast<std::ptrdiff_t>(breadths.size() / 2);
    return median({half, breadths.end()}) < s_.blade;
  }

  // The straightest way is the organ that stands on the axis, the others touch it.
  void part_touching(const Side& side, bool through) {
    std::vector<std::uint32_t> levels;
    auto at = side.start;
    std::vector<Side> others;
    for (;;) {
      levels.push_back(at);
      if (children_[at].empty()) break;
      const auto behind = direction(side.leaves_at == no_node ? side.start : side.leaves_at, at);
      const auto next = *std::ranges::max_element(children_[at], {},
                                                  [&](auto c) { return direction(at, ahead(c, s_.look)).dot(behind); });
      for (const auto c : children_[at])
        if (c != next) others.push_back({c, side.axis, side.leaves_at});
      at = next;
    }
    add_organ(at, std::move(levels), side.axis, side.leaves_at, through);
    for (const auto& o : others) {
      if (ends_[o.start] == 1) {
        add_organ(o.start, o.axis, o.leaves_at, true);
      } else {
        part_touching(o, true);
      }
    }
  }

  void add_organ(std::uint32_t start, int axis, std::uint32_t leaves_at, bool through) {
    std::vector<std::uint32_t> levels{start};
    while (!children_[levels.back()].empty()) levels.push_back(children_[levels.back()].front());
    const auto last = levels.back();
    add_organ(last, std::move(levels), axis, leaves_at, through);
  }
  void add_organ(std::uint32_t end, std::vector<std::uint32_t> levels, int axis, std::uint32_t leaves_at,
                 bool through) {
    out_.organs.push_back({end_node_[end], std::move(levels), axis, leaves_at, through, false});
  }

  const std::vector<Level>& l_;
  const BranchingScales& s_;
  const std::vector<std::uint32_t>& of_node_;
  std::vector<int> ends_;  // organs beyond each level
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::uint32_t> end_node_, short_ends_;
  std::deque<Side> waiting_;
  Branching out_;
};

}  // namespace

Branching branching_of(const Levels& levels, const std::vector<OrganEnd>& ends, const BranchingScales& scales) {
  return Growing(levels, ends, scales).all();
}

}  // namespace bole::plant
