#include "rgbd/core/poses/pose_tables.h"

#include <algorithm>
#include <map>

#include "base/angles.h"
#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t max_pairs_shown = 8;
constexpr std::size_t max_rows_of_state = 300;  // of each pair
constexpr std::uint16_t color_step = 257;       // of 8 bit in 16 bit

// Evenly spread over the tried pairs of neighbours, and over the connected loops.
std::vector<std::pair<int, int>> pairs_to_show(const std::vector<MatchedPair>& pairs) {
  std::vector<std::pair<int, int>> neighbours, loops, out;
  for (const auto& p : pairs) {
    if (p.view_b == p.view_a + 1) neighbours.emplace_back(p.view_a, p.view_b);
    if (p.view_b > p.view_a + 1 && p.connected()) loops.emplace_back(p.view_a, p.view_b);
  }
  const auto take = [&](const auto& from, std::size_t count) {
    for (std::size_t i = 0; i < std::min(count, from.size()); ++i)
      out.push_back(from[i * from.size() / std::min(count, from.size())]);
  };
  take(neighbours, max_pairs_shown / 2);
  take(loops, max_pairs_shown - out.size());
  return out;
}

// Up to `count` of them, evenly.
std::vector<ScreenedMatch> thinned(const std::vector<ScreenedMatch>& all, std::size_t count) {
  if (all.size() <= count) return all;
  std::vector<ScreenedMatch> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(all[i * all.size() / count]);
  return out;
}

class MatchRows {
 public:
  void add(const ViewSource& views, const ViewData& a, const ViewData& b, int ia, int ib, const ScreenedMatch& m) {
    const auto &pa = a.features.features[m.match.a].pixel, &pb = b.features.features[m.match.b].pixel;
    view_a_.push_back(ia);
    view_b_.push_back(ib);
    name_a_.push_back(views.name(at(ia)));
    name_b_.push_back(views.name(at(ib)));
    x_a_.push_back(pa.x());
    y_a_.push_back(pa.y());
    x_b_.push_back(pb.x());
    y_b_.push_back(pb.y());
    state_.emplace_back(m.fate == MatchFate::kept ? "kept" : "refused");
    reason_.emplace_back(choice_name(m.fate));
  }
  Table table() {
    Table t;
    t.set("view_a", std::move(view_a_));
    t.set("view_b", std::move(view_b_));
    t.set("name_a", std::move(name_a_));
    t.set("name_b", std::move(name_b_));
    t.set("x_a_px", std::move(x_a_));
    t.set("y_a_px", std::move(y_a_));
    t.set("x_b_px", std::move(x_b_));
    t.set("y_b_px", std::move(y_b_));
    t.set("state", std::move(state_));
    t.set("reason", std::move(reason_));
    return t;
  }

 private:
  std::vector<std::int64_t> view_a_, view_b_;
  std::vector<std::string> name_a_, name_b_, state_, reason_;
  std::vector<double> x_a_, y_a_, x_b_, y_b_;
};

}  // namespace

Table tracking_table(const ViewSource& views, const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs,
                     const std::vector<TrackingState>& states, const std::vector<ViewResidual>& residuals,
                     const std::vector<PoseSigma>& sigmas) {
  const std::size_t n = data.size();
  std::vector<std::int64_t> view(n), features(n), matches(n, 0), inliers(n), corners(n);
  std::vector<double> time(n), pixel(n), depth(n), place(n, no_number), turn(n, no_number);
  std::vector<std::string> name(n), state(n);
  for (const auto& p : pairs)
    for (const int v : {p.view_a, p.view_b}) matches[at(v)] += static_cast<std::int64_t>(p.kept.size());
  for (std::size_t v = 0; v < n; ++v) {
    view[v] = static_cast<std::int64_t>(v);
    time[v] = views.time_s(v);
    name[v] = views.name(v);
    state[v] = choice_name(states[v]);
    features[v] = static_cast<std::int64_t>(data[v].features.size());
    inliers[v] = residuals[v].observations;
    corners[v] = residuals[v].corners;
    pixel[v] = residuals[v].pixel;
    depth[v] = 1000 * residuals[v].depth;
    if (v >= sigmas.size()) continue;
    place[v] = 1000 * sigmas[v].place;
    turn[v] = degrees(sigmas[v].turn_rad);
  }
  Table t;
  t.set("view", std::move(view));
  t.set("time_s", std::move(time));
  t.set("name", std::move(name));
  t.set("state", std::move(state));
  t.set("features", std::move(features));
  t.set("matches", std::move(matches));
  t.set("inliers", std::move(inliers));
  t.set("corners", std::move(corners));
  t.set("residual_px", std::move(pixel));
  t.set("residual_depth_mm", std::move(depth));
  t.set("place_sd_mm", std::move(place));
  t.set("turn_sd_deg", std::move(turn));
  return t;
}

Table match_table(const ViewSource& views, const std::vector<ViewData>& data, const ViewMatcher& matcher) {
  MatchRows rows;
  std::map<std::string, int> counts;
  for (const auto& [a, b] : pairs_to_show(matcher.pairs())) {
    std::vector<ScreenedMatch> fates, kept, refused;
    matcher.match(a, b, &fates);
    for (const auto& m : fates) {
      (m.fate == MatchFate::kept ? kept : refused).push_back(m);
      ++counts[std::string(choice_name(m.fate))];
    }
    for (const auto& part : {thinned(kept, max_rows_of_state), thinned(refused, max_rows_of_state)})
      for (const auto& m : part) rows.add(views, data[at(a)], data[at(b)], a, b, m);
  }
  Table t = rows.table();
  for (const auto& [reason, count] : counts) t.facts["matches_" + reason] = std::to_string(count);
  return t;
}

PointCloud sparse_cloud(const MadeBundle& made) {
  const auto& b = made.bundle;
  std::vector<int> seen(b.points.size(), 0);
  for (const auto& o : b.observations) ++seen[at(o.point)];
  PointCloud::Positions positions;
  std::vector<std::uint16_t> red, green, blue;
  for (std::size_t i = 0; i < b.points.size(); ++i) {
    if (seen[i] < 2) continue;
    positions.push_back(b.points[i].cast<float>());
    red.push_back(static_cast<std::uint16_t>(made.colors[i][0] * color_step));
    green.push_back(static_cast<std::uint16_t>(made.colors[i][1] * color_step));
    blue.push_back(static_cast<std::uint16_t>(made.colors[i][2] * color_step));
  }
  PointCloud cloud(std::move(positions));
  cloud.axes = Axes::map;
  cloud.set_column(arrays::red, std::move(red));
  cloud.set_column(arrays::green, std::move(green));
  cloud.set_column(arrays::blue, std::move(blue));
  return cloud;
}

}  // namespace bole::rgbd
