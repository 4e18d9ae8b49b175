#include "rgbd/core/poses/match_views.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/statistics.h"
#include "rgbd/core/at.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t pairs_per_batch = 24;  // pairs between two looks at cancel
constexpr int likeness_features = 200;
constexpr int min_likeness = 8;
constexpr std::size_t max_likeness_views = 150;
constexpr int overlap_samples = 60;
constexpr double min_overlap = 0.25;
constexpr double min_view_cosine = 0.6;  // between the rays to one point: features are not found again beyond
constexpr double min_turntable_share = 0.5;
constexpr double board_still_px = 2;

// How much of what view `a` sees view `b` sees as well, from a similar direction.
double overlap(const ViewData& a, const Pose& T_world_a, const ViewData& b, const Pose& T_world_b) {
  const auto& features = a.features.features;
  if (features.empty()) return 0;
  const std::size_t step = std::max<std::size_t>(1, features.size() / overlap_samples);
  const Pose T_b_a = T_world_b.inverse() * T_world_a;
  const Eigen::Vector3d b_in_a = T_b_a.inverse().translation();
  const double usual_depth = a.board ? T_world_a.translation().norm() : 0;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < features.size(); i += step) {
    const auto& f = features[i];
    const double z = f.inverse_depth > 0 ? 1 / f.inverse_depth : usual_depth;
    if (!(z > 0)) continue;
    ++count;
    const Eigen::Vector3d p = f.direction * z;
    const auto pixel = b.camera->color.project(T_b_a * p);
    if (!pixel || !b.camera->color.contains(*pixel)) continue;
    const double cosine = p.normalized().dot((p - b_in_a).normalized());
    if (cosine >= min_view_cosine) sum += cosine;
  }
  constexpr int enough = 5;
  return count < enough ? 0 : sum / count;
}

}  // namespace

ViewMatcher::ViewMatcher(const std::vector<ViewData>& data, const PoseOptions& options, double depth_noise)
    : data_(data), o_(options) {
  screen_.max_ratio = options.max_ratio;
  screen_.gms = options.gms;
  screen_.max_error_px = options.max_match_error;
  screen_.min_inliers = options.min_matches;
  screen_.depth_noise = depth_noise;
  screen_.drop_still = options.turntable == Turntable::yes;
}

MatchedPair ViewMatcher::match(int a, int b, std::vector<ScreenedMatch>* fates) const {
  const auto& da = data_[at(a)];
  const auto& db = data_[at(b)];
  return match_pair({&da.features, &da.camera->color, a}, {&db.features, &db.camera->color, b}, screen_, fates);
}

void ViewMatcher::match_all(const Pairs& wanted, const Run& run, const char* what) {
  Pairs fresh;
  for (const auto& p : wanted)
    if (tried_.insert(p).second) fresh.push_back(p);
  std::vector<MatchedPair> found(fresh.size());
  for (std::size_t first = 0; first < fresh.size(); first += pairs_per_batch) {
    run.check_cancel();
    run.report(static_cast<double>(first) / static_cast<double>(fresh.size()), what);
    tbb::parallel_for(first, std::min(first + pairs_per_batch, fresh.size()), [&](std::size_t i) {
      if (!run.cancelled()) found[i] = match(fresh[i].first, fresh[i].second, nullptr);
    });
  }
  run.check_cancel();
  for (auto& p : found) {
    loops_ += p.connected() && p.view_b - p.view_a > o_.neighbours ? 1 : 0;
    pairs_.push_back(std::move(p));
  }
  std::ranges::sort(pairs_, {}, [](const auto& p) { return std::tuple(p.view_a, p.view_b); });
}

void ViewMatcher::match_neighbours(const Run& run) {
  Pairs wanted;
  const int n = static_cast<int>(data_.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < std::min(n, a + 1 + o_.neighbours); ++b) wanted.emplace_back(a, b);
  match_all(wanted, run, "matching neighbours");
}

ViewMatcher::Pairs ViewMatcher::best_partners(const std::vector<std::vector<double>>& score,
                                              const std::vector<int>& views, int count) const {
  Pairs out;
  for (std::size_t i = 0; i < views.size(); ++i) {
    std::vector<std::size_t> order;
    for (std::size_t j = 0; j < views.size(); ++j)
      if (score[i][j] > 0 && std::abs(views[i] - views[j]) > o_.neighbours) order.push_back(j);
    std::ranges::sort(order, {}, [&](std::size_t j) { return std::tuple(-score[i][j], j); });
    std::vector<int> chosen;
    for (const auto j : order) {
      if (static_cast<int>(chosen.size()) >= count) break;
      const int v = views[j];
      if (std::ranges::any_of(chosen, [&](int c) { return std::abs(c - v) < o_.neighbours; })) continue;
      chosen.push_back(v);
      out.emplace_back(std::min(views[i], v), std::max(views[i], v));
    }
  }
  return out;
}

void ViewMatcher::match_alike(const Run& run) {
  if (o_.loops == 0 || data_.size() < 2) return;
  const std::size_t step = (data_.size() + max_likeness_views - 1) / max_likeness_views;
  std::vector<int> views;
  std::vector<Likeness> likeness;
  for (std::size_t v = 0; v < data_.size(); v += step) {
    views.push_back(static_cast<int>(v));
    likeness.emplace_back(data_[v].features, likeness_features);
  }
  std::vector<std::vector<double>> score(views.size(), std::vector<double>(views.size(), 0));
  for (std::size_t i = 0; i < views.size(); ++i) {
    run.check_cancel();
    tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t j) {
      if (views[j] - views[i] <= o_.neighbours) return;
      const int found = likeness[i].with(likeness[j]);
      if (found >= min_likeness) score[i][j] = found;
    });
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) score[i][j] = score[j][i];
  match_all(best_partners(score, views, (o_.loops + 1) / 2), run, "matching views that look alike");
}

void ViewMatcher::match_overlapping(const std::vector<std::optional<Pose>>& poses, const Run& run) {
  if (o_.loops == 0) return;
  std::vector<int> views;
  for (std::size_t v = 0; v < data_.size(); ++v)
    if (poses[v]) views.push_back(static_cast<int>(v));
  std::vector<std::vector<double>> score(views.size(), std::vector<double>(views.size(), 0));
  for (std::size_t i = 0; i < views.size(); ++i) {
    run.check_cancel();
    tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t j) {
      if (std::abs(views[i] - views[j]) <= o_.neighbours) return;
      const double share =
          overlap(data_[at(views[i])], *poses[at(views[i])], data_[at(views[j])], *poses[at(views[j])]);
      if (share >= min_overlap) score[i][j] = share;
    });
  }
  match_all(best_partners(score, views, o_.loops), run, "matching loops");
}

// Whether the corners of the board move in the image from view to view.
bool ViewMatcher::board_moves() const {
  std::vector<double> moved;
  for (std::size_t v = 0; v + 1 < data_.size(); ++v)
    for (const auto& a : data_[v].corners)
      for (const auto& b : data_[v + 1].corners)
        if ((a.point - b.point).norm() < 1e-6) moved.push_back((a.pixel - b.pixel).norm());
  return moved.empty() || median(std::move(moved)) > board_still_px;
}

void ViewMatcher::settle_turntable(const Run& run, Report& report) {
  bool turns = o_.turntable == Turntable::yes;
  if (o_.turntable == Turntable::automatic) {
    int judged = 0, two = 0;
    std::vector<double> still, moving;
    for (const auto& p : pairs_) {
      if (p.candidates < 2 * screen_.min_inliers) continue;
      ++judged;
      if (!p.two_motions) continue;
      ++two;
      if (p.still_depth > 0 && p.moving_depth > 0) {
        still.push_back(p.still_depth);
        moving.push_back(p.moving_depth);
      }
    }
    if (judged == 0 || two < min_turntable_share * judged) return;
    const bool board = std::ranges::any_of(data_, [](const auto& d) { return d.board.has_value(); });
    // The object carries the board; without one it is what is nearer to the camera. Depth that ends behind the object
    // shows no background at all.
    turns = board ? board_moves() : still.empty() || median(std::move(still)) > median(std::move(moving));
    report.facts["two_motions"] = fmt::format("{} of {} pairs", two, judged);
    if (!turns)
      report.find(Severity::look, "moving_background",
                  "a part of the images moves and the object does not; what moves is left out where it disagrees");
  }
  if (!turns) return;
  report.facts["turntable"] = "yes";
  if (screen_.drop_still) return;  // done so from the beginning
  screen_.drop_still = true;
  Pairs again;
  for (const auto& p : pairs_) again.emplace_back(p.view_a, p.view_b);
  pairs_.clear();
  tried_.clear();
  loops_ = 0;
  match_all(again, run, "matching without the still background");
}

}  // namespace bole::rgbd
