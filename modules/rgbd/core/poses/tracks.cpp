#include "rgbd/core/poses/tracks.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <utility>

#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

constexpr int cells_x = 12, cells_y = 8;

// Joins features as long as no two of one view come together.
class Joiner {
 public:
  explicit Joiner(const std::vector<const Features*>& features) : features_(features), first_(features.size() + 1, 0) {
    for (std::size_t v = 0; v < features.size(); ++v) first_[v + 1] = first_[v] + features[v]->size();
    parent_.resize(first_.back());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    members_.resize(parent_.size());
    for (int v = 0; v < static_cast<int>(features.size()); ++v)
      for (std::uint32_t f = 0; f < features[at(v)]->size(); ++f) members_[first_[at(v)] + f] = {{v, f}};
  }

  void join(const TrackedFeature& one, const TrackedFeature& other) {
    std::size_t a = find(node(one)), b = find(node(other));
    if (a == b || share_a_view(members_[a], members_[b])) return;
    if (a > b) std::swap(a, b);
    parent_[b] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    std::ranges::sort(members_[a], {}, &TrackedFeature::view);
    members_[b].clear();
    members_[b].shrink_to_fit();
  }

  std::vector<std::vector<TrackedFeature>> tracks() {
    std::erase_if(members_, [](const auto& t) { return t.size() < 2; });
    std::ranges::stable_sort(members_, std::greater{}, [](const auto& t) { return t.size(); });
    return std::move(members_);
  }

 private:
  std::size_t node(const TrackedFeature& t) const {
    return first_[at(t.view)] + features_[at(t.view)]->features[t.feature].place;
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  static bool share_a_view(const std::vector<TrackedFeature>& a, const std::vector<TrackedFeature>& b) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (a[i].view == b[j].view) return true;
      ++(a[i].view < b[j].view ? i : j);
    }
    return false;
  }

  const std::vector<const Features*>& features_;
  std::vector<std::size_t> first_, parent_;
  std::vector<std::vector<TrackedFeature>> members_;  // of the joined features, at their first one
};

}  // namespace

std::vector<std::vector<TrackedFeature>> join_tracks(const std::vector<const Features*>& features,
                                                     const std::vector<MatchedPair>& pairs,
                                                     const std::vector<std::optional<Pose>>& poses) {
  Joiner joiner(features);
  // The pairs with most matches first: what they join is what weaker pairs must fit.
  std::vector<const MatchedPair*> order;
  for (const auto& p : pairs)
    if (poses[at(p.view_a)] && poses[at(p.view_b)]) order.push_back(&p);
  std::ranges::stable_sort(order, std::greater{}, [](const auto* p) { return p->kept.size(); });
  for (const auto* p : order)
    for (const auto& m : p->kept) joiner.join({p->view_a, m.a}, {p->view_b, m.b});
  return joiner.tracks();
}

std::vector<std::vector<TrackedFeature>> spread_tracks(const std::vector<std::vector<TrackedFeature>>& tracks,
                                                       const std::vector<const Features*>& features,
                                                       const std::vector<const CameraModel*>& cameras, int per_cell) {
  std::vector<std::array<int, cells_x * cells_y>> filled(features.size());
  for (auto& f : filled) f.fill(0);
  const auto cell = [&](const TrackedFeature& t) -> int& {
    const auto& pixel = features[at(t.view)]->features[t.feature].pixel;
    const auto& camera = *cameras[at(t.view)];
    const int x = std::clamp(static_cast<int>((pixel.x() + 0.5) * cells_x / camera.width), 0, cells_x - 1);
    const int y = std::clamp(static_cast<int>((pixel.y() + 0.5) * cells_y / camera.height), 0, cells_y - 1);
    return filled[at(t.view)][at(y * cells_x + x)];
  };
  std::vector<std::vector<TrackedFeature>> out;
  for (const auto& t : tracks) {
    const auto wanted = std::ranges::count_if(t, [&](const auto& f) { return cell(f) < per_cell; });
    if (2 * wanted < static_cast<std::ptrdiff_t>(t.size())) continue;
    for (const auto& f : t) ++cell(f);
    out.push_back(t);
  }
  return out;
}

}  // namespace bole::rgbd
