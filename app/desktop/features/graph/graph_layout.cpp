#include "features/graph/graph_layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

namespace bole::desktop {
namespace {

constexpr int order_sweeps = 24, place_sweeps = 400;
// How straight an arrow wants to be: most where it passes layers.
constexpr double box_weight = 1, end_weight = 2, lane_weight = 8;
constexpr double min_bend = 0.05;    // of the distance between lanes: smaller ones count as this
constexpr double max_wobble = 0.3;   // likewise: lanes that differ by less are drawn as one line
constexpr double entry_share = 0.8;  // of the side of a box where arrows come in

// Whether each arrow points forward: those that close a circle do not.
std::vector<bool> forward_arrows(std::size_t boxes, const std::vector<GraphArrow>& arrows) {
  std::vector<bool> forward(arrows.size(), true);
  std::vector<int> mark(boxes, 0);  // 1: being visited, 2: done
  const std::function<void(std::size_t)> visit = [&](std::size_t box) {
    mark[box] = 1;
    for (std::size_t a = 0; a < arrows.size(); ++a) {
      if (arrows[a].from != box) continue;
      if (mark[arrows[a].to] == 1) forward[a] = false;
      if (mark[arrows[a].to] == 0) visit(arrows[a].to);
    }
    mark[box] = 2;
  };
  for (std::size_t box = 0; box < boxes; ++box)
    if (mark[box] == 0) visit(box);
  return forward;
}

std::vector<int> layers_of(std::size_t boxes, const std::vector<GraphArrow>& arrows) {
  std::vector<int> layers(boxes, 0);
  for (bool moved = true; moved;) {
    moved = false;
    for (const auto& arrow : arrows)
      if (layers[arrow.to] <= layers[arrow.from]) {
        layers[arrow.to] = layers[arrow.from] + 1;
        moved = true;
      }
  }
  // What begins somewhere on the way stands right before the first that takes from it.
  for (std::size_t box = 0; box < boxes; ++box) {
    if (std::ranges::any_of(arrows, [&](const auto& a) { return a.to == box; })) continue;
    std::optional<int> first;
    for (const auto& a : arrows)
      if (a.from == box) first = std::min(first.value_or(layers[a.to]), layers[a.to]);
    layers[box] = first.value_or(1) - 1;
  }
  return layers;
}

// Boxes, and the lanes in which arrows pass layers: one for all arrows of a box.
class LayeredGraph {
 public:
  LayeredGraph(std::vector<int> layers, const std::vector<GraphArrow>& arrows, double box_size, double box_gap,
               double lane_gap)
      : boxes_(layers.size()), layer_of_(std::move(layers)), box_gap_(box_gap), lane_gap_(lane_gap), size_(box_size) {
    for (std::size_t box = 0; box < boxes_; ++box) put(box);
    before_.resize(boxes_);
    after_.resize(boxes_);
    for (const auto& arrow : arrows) join(before(arrow), arrow.to);
    find_order();
    find_places();
  }

  double place(std::size_t node) const { return place_[node]; }
  const std::vector<std::size_t>& before(std::size_t node) const { return before_[node]; }
  int layer_count() const { return static_cast<int>(rows_.size()); }

  // The lane of the arrows of `box` in a layer behind it; the box itself in its own layer.
  std::size_t lane(std::size_t box, int layer) {
    if (layer == layer_of_[box]) return box;
    const auto [found, added] = lanes_.try_emplace({box, layer}, layer_of_.size());
    if (!added) return found->second;
    const std::size_t node = found->second;
    layer_of_.push_back(layer);
    before_.emplace_back();
    after_.emplace_back();
    put(node);
    join(lane(box, layer - 1), node);
    return node;
  }

 private:
  using Lanes = std::map<std::pair<std::size_t, int>, std::size_t>;  // by box and layer

  bool is_lane(std::size_t node) const { return node >= boxes_; }
  std::size_t before(const GraphArrow& arrow) { return lane(arrow.from, layer_of_[arrow.to] - 1); }

  void put(std::size_t node) {
    const auto layer = static_cast<std::size_t>(layer_of_[node]);
    if (rows_.size() <= layer) rows_.resize(layer + 1);
    rows_[layer].push_back(node);
  }

  void join(std::size_t from, std::size_t to) {
    after_[from].push_back(to);
    before_[to].push_back(from);
  }

  std::vector<std::size_t> ranks() const {
    std::vector<std::size_t> rank(layer_of_.size());
    for (const auto& row : rows_)
      for (std::size_t i = 0; i < row.size(); ++i) rank[row[i]] = i;
    return rank;
  }

  // Between the arrows that come in to (or go out of) two nodes, when `a` stands before `b`.
  static int crossings(const std::vector<std::size_t>& of_a, const std::vector<std::size_t>& of_b,
                       const std::vector<std::size_t>& rank) {
    int count = 0;
    for (const auto p : of_a)
      for (const auto q : of_b) count += rank[p] > rank[q];
    return count;
  }

  int crossings() const {
    const auto rank = ranks();
    int count = 0;
    for (const auto& row : rows_)
      for (std::size_t i = 0; i < row.size(); ++i)
        for (std::size_t j = i + 1; j < row.size(); ++j) count += crossings(before_[row[i]], before_[row[j]], rank);
    return count;
  }

  void sweep(bool forward) {
    auto rank = ranks();
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      auto& row = rows_[forward ? k : rows_.size() - 1 - k];
      const auto& others = forward ? before_ : after_;
      std::map<std::size_t, double> middle;
      for (const auto node : row) {
        double sum = 0;
        for (const auto other : others[node]) sum += static_cast<double>(rank[other]);
        middle[node] =
            others[node].empty() ? static_cast<double>(rank[node]) : sum / static_cast<double>(others[node].size());
      }
      std::ranges::stable_sort(row, {}, [&](std::size_t node) { return middle.at(node); });
      for (std::size_t i = 0; i < row.size(); ++i) rank[row[i]] = i;
    }
  }

  // Neighbours change places while that leaves fewer crossings.
  void swap_neighbours() {
    for (bool better = true; better;) {
      better = false;
      for (auto& row : rows_)
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
          const auto rank = ranks();
          const auto a = row[i], b = row[i + 1];
          const int now = crossings(before_[a], before_[b], rank) + crossings(after_[a], after_[b], rank);
          const int then = crossings(before_[b], before_[a], rank) + crossings(after_[b], after_[a], rank);
          if (then >= now) continue;
          std::swap(row[i], row[i + 1]);
          better = true;
        }
    }
  }

  void find_order() {
    auto best = rows_;
    int fewest = std::numeric_limits<int>::max();
    for (int k = 0; k < order_sweeps && fewest > 0; ++k) {
      sweep(k % 2 == 0);
      const auto swept = rows_;
      swap_neighbours();
      if (const int count = crossings(); count < fewest) {
        fewest = count;
        best = rows_;
      }
      rows_ = swept;
    }
    rows_ = best;
  }

  double distance(std::size_t a, std::size_t b) const {
    const double sizes = (is_lane(a) ? 0 : size_ / 2) + (is_lane(b) ? 0 : size_ / 2);
    return sizes + (is_lane(a) || is_lane(b) ? lane_gap_ : box_gap_);
  }

  // Squares alone would bend an arrow a little at every layer. Divided by the bend itself (reweighted least squares)
  // the sum is that of the lengths, which one bend leaves as short as many.
  double weight(std::size_t a, std::size_t b) const {
    const double bend = std::abs(place_[a] - place_[b]) / lane_gap_;
    return (is_lane(a) && is_lane(b)   ? lane_weight
            : is_lane(a) || is_lane(b) ? end_weight
                                       : box_weight) /
           std::max(bend, min_bend);
  }

  // The places of a row nearest to where its neighbours pull it that keep order and distances: nodes that would come
  // too near move as one block (pool adjacent violators).
  void place_row(const std::vector<std::size_t>& row) {
    struct Block {
      double sum, weight;
      std::size_t count;
      double mean() const { return sum / weight; }
    };
    std::vector<Block> blocks;
    std::vector<double> offsets;
    double offset = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) offset += distance(row[i - 1], row[i]);
      offsets.push_back(offset);
      double sum = 0, total = 0;
      for (const auto* others : {&before_[row[i]], &after_[row[i]]})
        for (const auto other : *others) {
          sum += weight(row[i], other) * place_[other];
          total += weight(row[i], other);
        }
      const double wish = total > 0 ? sum / total : place_[row[i]];
      if (total == 0) total = box_weight;
      blocks.push_back({total * (wish - offset), total, 1});
      while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
        const Block last = blocks.back();
        blocks.pop_back();
        blocks.back() = {blocks.back().sum + last.sum, blocks.back().weight + last.weight,
                         blocks.back().count + last.count};
      }
    }
    std::size_t i = 0;
    for (const auto& block : blocks)
      for (std::size_t k = 0; k < block.count; ++k, ++i) place_[row[i]] = block.mean() + offsets[i];
  }

  void find_places() {
    place_.assign(layer_of_.size(), 0);
    for (int k = 0; k < place_sweeps; ++k)
      for (std::size_t r = 0; r < rows_.size(); ++r) place_row(rows_[k % 2 == 0 ? r : rows_.size() - 1 - r]);
    for (auto first = lanes_.cbegin(); first != lanes_.cend();) first = straighten(first);
  }

  // Lanes of one box that follow each other and lie almost in a line, from `first` on; the box itself too, when the
  // first of them does. Gives the lane behind them.
  Lanes::const_iterator straighten(Lanes::const_iterator first) {
    const auto box = first->first.first;
    const bool from_box = first->first.second == layer_of_[box] + 1;
    double sum = place_[first->second];
    int count = 1;
    auto end = std::next(first);
    const auto near = [&](double place) { return std::abs(place - sum / count) < max_wobble * lane_gap_; };
    for (; end != lanes_.end() && end->first.first == box && near(place_[end->second]); ++end, ++count)
      sum += place_[end->second];
    const double line = from_box && near(place_[box]) ? place_[box] : sum / count;
    for (auto lane = first; lane != end; ++lane) place_[lane->second] = line;
    return end;
  }

  std::size_t boxes_;
  std::vector<int> layer_of_;
  double box_gap_, lane_gap_, size_;
  std::vector<std::vector<std::size_t>> rows_;            // nodes by layer, in their order
  std::vector<std::vector<std::size_t>> before_, after_;  // nodes of the layers beside
  Lanes lanes_;
  std::vector<double> place_;
};

// Where the arrow from the node `from` reaches the side of a box: spread in the order in which they come.
double entry(const LayeredGraph& graph, std::size_t box, std::size_t from, double size) {
  auto before = graph.before(box);
  std::ranges::stable_sort(before, {}, [&](std::size_t node) { return graph.place(node); });
  const auto n = static_cast<double>(before.size());
  const auto rank = static_cast<double>(std::ranges::find(before, from) - before.begin());
  return graph.place(box) + ((rank + 0.5) / n - 0.5) * entry_share * size;
}

}  // namespace

GraphLayout lay_out_graph(std::size_t boxes, const std::vector<GraphArrow>& arrows, const QSizeF& box,
                          const GraphSpacing& spacing, Qt::Orientation orientation) {
  const bool across_is_y = orientation == Qt::Horizontal;
  const double length = across_is_y ? box.width() : box.height(), size = across_is_y ? box.height() : box.width();
  const auto forward = forward_arrows(boxes, arrows);
  std::vector<GraphArrow> kept;
  for (std::size_t a = 0; a < arrows.size(); ++a)
    if (forward[a]) kept.push_back(arrows[a]);
  GraphLayout layout;
  layout.layers = layers_of(boxes, kept);
  LayeredGraph graph(layout.layers, kept, size, spacing.boxes, spacing.lanes);
  const auto begin = [&](int layer) { return layer * (length + spacing.layers); };
  const auto point = [&](double along, double across) {
    return across_is_y ? QPointF(along, across) : QPointF(across, along);
  };
  for (std::size_t b = 0; b < boxes; ++b) {
    layout.boxes.emplace_back(point(begin(layout.layers[b]), graph.place(b) - size / 2), box);
    layout.extent |= layout.boxes.back();
  }
  for (std::size_t a = 0; a < arrows.size(); ++a) {
    const auto [from, to] = arrows[a];
    const int first = layout.layers[from], last = layout.layers[to];
    std::vector<QPointF> way{point(begin(first) + length, graph.place(from))};
    for (int layer = first + 1; forward[a] && layer < last; ++layer)
      for (const double along : {begin(layer), begin(layer) + length})
        way.push_back(point(along, graph.place(graph.lane(from, layer))));
    way.push_back(
        point(begin(last), forward[a] ? entry(graph, to, graph.lane(from, last - 1), size) : graph.place(to)));
    for (const auto& p : way) layout.extent |= QRectF(p, QSizeF(1e-6, 1e-6));
    layout.arrows.push_back(std::move(way));
  }
  return layout;
}

}  // namespace bole::desktop
