#include "rgbd/core/poses/estimate_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/statistics.h"
#include "rgbd/core/at.h"
#include "rgbd/core/matching/view_graph.h"
#include "rgbd/core/poses/given_poses.h"
#include "rgbd/core/poses/grow_poses.h"
#include "rgbd/core/poses/make_bundle.h"
#include "rgbd/core/poses/match_views.h"
#include "rgbd/core/poses/pose_report.h"

namespace bole::rgbd {
namespace {

constexpr std::size_t max_pose_views = 3000;  // about a gigabyte of features
constexpr double usual_depth_noise = 0.004;   // 1 / m: 4 mm at 1 m
constexpr double screen_depth_noise = 0.01;   // wide, until the noise is learnt
constexpr double max_scale_gap = 0.02;        // between board and depth, that nobody needs to know of
constexpr double board_edge_weight = 1e4;     // the board ties a view before any match does
constexpr double ambiguous_edge_weight = 1;
constexpr double max_ring_turn_rad = 0.06, max_ring_shift_share = 0.06;  // of the depth
constexpr int min_observations = 10, min_corners = 6;                    // below both, a view is lost

class Estimator {
 public:
  Estimator(const ViewSource& views, const PoseOptions& options, const Run& run)
      : views_(views), o_(options), run_(run) {}

  EstimatedPoses slam() {
    read(0.45);
    if (views_.size() == 1) need_board_for_one();
    compare_depth_with_board();
    need_scale();
    ViewMatcher matcher(data_, o_, o_.depth_noise.value_or(screen_depth_noise));
    matcher.match_neighbours(run_.part(0.45, 0.6));
    matcher.settle_turntable(run_.part(0.6, 0.62), out_.report);
    matcher.match_alike(run_.part(0.62, 0.66));
    first_poses(matcher);
    matcher.match_overlapping(poses_, run_.part(0.66, 0.75));
    first_poses(matcher);
    grow(matcher);
    solve(matcher);
    tell(matcher);
    return std::move(out_);
  }

  EstimatedPoses given(const Trajectory& trajectory) {
    poses_ = take_given(views_, trajectory);
    read(0.6);
    ViewMatcher matcher(data_, o_, o_.depth_noise.value_or(screen_depth_noise));
    matcher.match_neighbours(run_.part(0.6, 0.8));
    check_given(poses_, data_, matcher.pairs(), out_.report);
    check_given_scale(poses_, data_, out_.report);
    made_ = make_bundle(data_, matcher.pairs(), poses_, false);
    BundleOptions options;
    options.fixed_poses = true;
    adjust(made_.bundle, options, run_.part(0.8, 1));
    for (const auto& p : poses_) states_.push_back(p ? TrackingState::given : TrackingState::lost);
    out_.report.facts["world_axes"] = "given";
    out_.report.facts["scale_source"] = "given";
    tell(matcher);
    return std::move(out_);
  }

 private:
  void read(double until) {
    if (views_.size() == 0) throw bad_input("there are no views", "at least 2", "Check the folder of the views.");
    if (views_.size() > max_pose_views)
      throw bad_input(fmt::format("there are {} views", views_.size()), fmt::format("at most {}", max_pose_views),
                      "Read every n-th view, or a part of them (options every and max_views of io.read_views).");
    data_ = read_views(views_, o_, run_.part(0, until), out_.report);
  }

  // Ratio of measured depth to the distance of the board's corners, where enough of them have depth.
  void compare_depth_with_board() {
    std::vector<double> ratios;
    for (const auto& d : data_) {
      if (!d.board || d.board->ambiguous) continue;
      const Pose T_camera_board = d.board->T_board_camera.inverse();
      for (std::size_t i = 0; i < d.corners.size(); ++i)
        if (d.corner_depths[i] > 0) ratios.push_back(d.corner_depths[i] / (T_camera_board * d.corners[i].point).z());
    }
    constexpr std::size_t enough = 12;
    if (ratios.size() < enough) return;
    depth_ratio_ = median(std::move(ratios));
    out_.report.metrics["depth_to_board"] = {depth_ratio_, Unit::none};
    if (std::abs(depth_ratio_ - 1) <= max_scale_gap) return;
    constexpr double max_ratio = 1.6;  // beyond it no calibration is off: the unit is another one
    if (depth_ratio_ > max_ratio || depth_ratio_ < 1 / max_ratio)
      throw bad_input(fmt::format("measured depth is {:.4g} times what the board says", depth_ratio_),
                      "depth and board of one size",
                      "Correct depth_scale (units per metre) in camera.json, or square_mm in mat.json.");
    out_.report.find(Severity::look, "depth_scale",
                     fmt::format("measured depth is {:.4g} times what the board says; the scale of the board is used. "
                                 "Check depth_scale in camera.json and square_mm in mat.json",
                                 depth_ratio_));
    for (auto& d : data_)
      for (auto& f : d.features.features) f.inverse_depth *= depth_ratio_;
    corrected_ = depth_ratio_;
  }

  bool any_board() const {
    return std::ranges::any_of(data_, [](const auto& d) { return d.board.has_value(); });
  }
  bool any_depth() const {
    return std::ranges::any_of(data_, [](const auto& d) { return d.features_with_depth > 0; });
  }

  void need_board_for_one() const {
    if (any_board()) return;
    throw bad_input("there is one view and no board in it", "at least 2 views, or a board that fixes the pose",
                    "Give a folder with all views.");
  }

  void need_scale() {
    if (any_depth() || any_board() || o_.allow_unscaled) return;
    throw bad_input(views_.has_depth() ? "no feature of any view has depth" : "the views have no depth and no board",
                    "depth images, or a ChArUco board in the views",
                    "Check the depth images and depth_scale, or give poses and source=given. Poses without scale: "
                    "allow_unscaled=true.");
  }

  double usual_depth() const {
    std::vector<double> z;
    for (const auto& d : data_)
      for (const auto& f : d.features.features)
        if (f.inverse_depth > 0) z.push_back(1 / f.inverse_depth);
    return z.empty() ? 1 : median(std::move(z));
  }

  // Poses along the maximum spanning tree; the board is a node of its own behind the views.
  void first_poses(const ViewMatcher& matcher) {
    const int world = static_cast<int>(data_.size());
    std::vector<GraphEdge> edges;
    for (const auto& p : matcher.pairs())
      if (p.connected() && !p.by_rays)
        edges.push_back({p.view_a, p.view_b, p.T_b_a, static_cast<double>(p.kept.size())});
    for (int v = 0; v < world; ++v)
      if (const auto& board = data_[at(v)].board)
        edges.push_back({v, world, board->T_board_camera,
                         board->ambiguous ? ambiguous_edge_weight
                                          : board_edge_weight + static_cast<double>(data_[at(v)].corners.size())});
    const auto wrong = contradicted(world + 1, edges, max_ring_turn_rad, max_ring_shift_share * usual_depth());
    std::vector<GraphEdge> good;
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (!wrong[i]) good.push_back(edges[i]);
    contradicted_ = static_cast<int>(edges.size() - good.size());
    const auto spanned = span_poses(world + 1, good, world);
    with_board_ = spanned.nodes > 1 && spanned.T_root_node[at(world)].has_value();
    root_ = spanned.root;
    poses_.assign(data_.size(), std::nullopt);
    if (spanned.nodes < 2) return;
    poses_.assign(spanned.T_root_node.begin(), spanned.T_root_node.end() - 1);
  }

  // Views that no depth and no board ties follow by the points that the others see.
  void grow(const ViewMatcher& matcher) {
    const auto grown = grow_poses(data_, matcher.pairs(), with_board_, o_, poses_, run_.part(0.75, 0.8));
    out_.report.counts["views_by_points"] = grown.added;
    unscaled_ = grown.start >= 0;
    if (unscaled_) root_ = grown.start;
    if (std::ranges::none_of(poses_, [](const auto& p) { return p.has_value(); }))
      throw bad_input("no two of the views show the same thing",
                      fmt::format("at least {} matches between two views", o_.min_matches),
                      "Take views that overlap by half or more, with texture in them.");
  }

  void solve(const ViewMatcher& matcher) {
    std::vector<MatchedPair> pairs = matcher.pairs();
    drop_contradicting(pairs);
    made_ = make_bundle(data_, pairs, poses_, with_board_);
    auto& b = made_.bundle;
    b.inverse_depth_sigma = o_.depth_noise.value_or(usual_depth_noise);
    BundleOptions options;
    options.fixed_view = with_board_ ? -1 : root_;
    options.free_depth = with_board_;
    options.hold_scale = unscaled_;
    options.free_focal = o_.refine_focal;
    options.learn_depth_sigma = !o_.depth_noise;
    const auto report = adjust(b, options, run_.part(0.8, 0.98));
    out_.report.counts["iterations"] = report.iterations;
    if (!report.converged)
      out_.report.find(Severity::look, "adjustment_failed",
                       "the bundle adjustment found no solution, and the first poses are kept: " + report.message);
    if (unscaled_)
      set_unit_scale();
    else
      sigmas_ = pose_sigmas(b, options.fixed_view);
    keep_tracked();
  }

  // Without depth and board the median distance of the points becomes 1.
  void set_unit_scale() {
    auto& b = made_.bundle;
    std::vector<double> distances;
    for (const auto& o : b.observations)
      distances.push_back((b.points[at(o.point)] - b.T_world_camera[at(o.view)].translation()).norm());
    const double unit = distances.empty() ? 1 : median(std::move(distances));
    for (auto& p : b.points) p /= unit;
    for (auto& T : b.T_world_camera) T.translation() /= unit;
    out_.report.find(Severity::refused, "no_scale",
                     "the views have neither depth nor a board: lengths are in units of the median distance of the "
                     "points, not in metres");
  }

  // A pair whose motion is far from the first poses has matched two places that look alike.
  void drop_contradicting(std::vector<MatchedPair>& pairs) {
    constexpr double far_rad = 0.35, far_share = 0.35;
    const double shift = far_share * usual_depth();
    for (auto& p : pairs) {
      if (!p.connected() || !poses_[at(p.view_a)] || !poses_[at(p.view_b)]) continue;
      const Pose gap = p.T_b_a.inverse() * poses_[at(p.view_b)]->inverse() * *poses_[at(p.view_a)];
      const bool moved = !p.by_rays && gap.translation().norm() > shift;
      if (moved || so3_log(Eigen::Quaterniond(gap.linear())).norm() > far_rad) p.kept.clear();
    }
  }

  void keep_tracked() {
    const auto residuals = residuals_of(made_.bundle);
    for (std::size_t v = 0; v < data_.size(); ++v) {
      const bool held = residuals[v].observations >= min_observations || residuals[v].corners >= min_corners;
      if (poses_[v] && held)
        poses_[v] = made_.bundle.T_world_camera[v];
      else
        poses_[v].reset();
      states_.push_back(poses_[v] ? TrackingState::tracked : TrackingState::lost);
    }
    auto& report = out_.report;
    report.facts["world_axes"] = with_board_ ? "board" : "first_view";
    report.facts["scale_source"] = with_board_ ? "board" : (unscaled_ ? "none" : "depth");
    if (with_board_ && any_depth()) {
      report.metrics["depth_scale"] = {made_.bundle.depth_scale * corrected_, Unit::none};
      report.metrics["depth_bias_mm"] = {1000 * made_.bundle.depth_bias * corrected_, Unit::millimetre};
    }
    if (any_depth())
      report.metrics["depth_noise_at_1m_mm"] = {1000 * made_.bundle.inverse_depth_sigma, Unit::millimetre};
    if (o_.refine_focal) report.metrics["focal_factor"] = {made_.bundle.focal_factor, Unit::none};
  }

  void tell(const ViewMatcher& matcher) {
    tell_poses({views_, data_, matcher, poses_, states_, made_, sigmas_, o_.source == PoseSource::given, contradicted_},
               out_);
  }

  const ViewSource& views_;
  const PoseOptions& o_;
  const Run& run_;
  std::vector<ViewData> data_;
  std::vector<std::optional<Pose>> poses_;
  std::vector<TrackingState> states_;
  MadeBundle made_;
  std::vector<PoseSigma> sigmas_;
  EstimatedPoses out_;
  double depth_ratio_ = 1, corrected_ = 1;
  bool with_board_ = false, unscaled_ = false;
  int root_ = 0, contradicted_ = 0;
};

}  // namespace

EstimatedPoses estimate_poses(const ViewSource& views, const Trajectory* given, const PoseOptions& options,
                              const Run& run) {
  Estimator estimator(views, options, run);
  if (options.source == PoseSource::given) return estimator.given(given != nullptr ? *given : views.given_poses());
  return estimator.slam();
}

}  // namespace bole::rgbd
