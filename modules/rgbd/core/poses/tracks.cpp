#include "rgbd/core/poses/tracks.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace bole::rgbd {
namespace {

constexpr int cells_x = 12, cells_y = 8;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<std::vector<TrackedFeature>> join_tracks(const std::vector<const Features*>& features,
                                                     const std::vector<MatchedPair>& pairs,
                                                     const std::vector<std::optional<Pose>>& poses) {
  std::vector<std::size_t> first(features.size() + 1, 0);
  for (std::size_t v = 0; v < features.size(); ++v) first[v + 1] = first[v] + features[v]->size();
  std::vector<std::size_t> parent(first.back());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto node = [&](int view, std::uint32_t f) { return first[at(view)] + features[at(view)]->features[f].place; };
  for (const auto& p : pairs) {
    if (!poses[at(p.view_a)] || !poses[at(p.view_b)]) continue;
    for (const auto& m : p.kept) {
      const auto a = find(node(p.view_a, m.a)), b = find(node(p.view_b, m.b));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> track_of(parent.size(), -1);
  std::vector<std::vector<TrackedFeature>> tracks;
  for (int v = 0; v < static_cast<int>(features.size()); ++v)
    for (std::uint32_t f = 0; f < features[at(v)]->size(); ++f) {
      if (features[at(v)]->features[f].place != f) continue;
      const auto root = find(first[at(v)] + f);
      if (root == first[at(v)] + f) {
        track_of[root] = static_cast<int>(tracks.size());
        tracks.emplace_back();
      }
      tracks[at(track_of[root])].push_back({v, f});
    }
  std::erase_if(tracks, [](const auto& t) {
    if (t.size() < 2) return true;
    for (std::size_t i = 1; i < t.size(); ++i)
      if (t[i].view == t[i - 1].view) return true;
    return false;
  });
  std::ranges::stable_sort(tracks, std::greater{}, [](const auto& t) { return t.size(); });
  return tracks;
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
