#include "rgbd/core/poses/grow_poses.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "rgbd/core/at.h"
#include "rgbd/core/matching/ray_motion.h"
#include "rgbd/core/poses/make_bundle.h"
#include "rgbd/core/poses/start_points.h"

namespace bole::rgbd {
namespace {

constexpr double reference_width = 1280;
constexpr double share_of_best = 0.7;  // of the known points that the best view sees: views above it are added at once
constexpr double min_start_rad = 0.05, enough_start_rad = 0.2;  // angle between the rays of the first two views
constexpr double point_error_factor = 2;

class Grower {
 public:
  Grower(const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs, bool with_board,
         const PoseOptions& options, std::vector<std::optional<Pose>>& poses, const Run& run)
      : data_(data), pairs_(pairs), with_board_(with_board), o_(options), poses_(poses), run_(run) {
    std::vector<const Features*> features;
    for (const auto& d : data) features.push_back(&d.features);
    const std::vector<std::optional<Pose>> all(data.size(), Pose::Identity());
    tracks_ = join_tracks(features, pairs, all);
  }

  GrownPoses grow() {
    const auto placed = [&] { return std::ranges::count_if(poses_, [](const auto& p) { return p.has_value(); }); };
    const auto before = placed();
    if (before == 0 && !begin()) return out_;
    while (!run_.asked_to_finish() && static_cast<std::size_t>(placed()) < data_.size()) {
      run_.check_cancel();
      run_.report(static_cast<double>(placed()) / static_cast<double>(data_.size()), "adding views");
      triangulate();
      if (!add_views()) break;
      settle();
    }
    out_.added = static_cast<int>(placed() - before);
    return out_;
  }

 private:
  double max_error_px(int view) const {
    return o_.max_match_error * std::max(1.0, data_[at(view)].camera->color.width / reference_width);
  }

  MotionOptions motion_options(int view) const {
    MotionOptions m;
    m.max_error = max_error_px(view) / std::abs(data_[at(view)].camera->color.fx);
    m.min_inliers = o_.min_matches;
    return m;
  }

  // The angle between the rays of a match, once the second view is turned like the first.
  double parallax(const MatchedPair& pair) const {
    std::vector<double> angles;
    const Eigen::Matrix3d R = pair.T_b_a.linear().transpose();
    for (const auto& m : pair.kept) {
      const Eigen::Vector3d a = data_[at(pair.view_a)].features.features[m.a].direction.normalized();
      const Eigen::Vector3d b = R * data_[at(pair.view_b)].features.features[m.b].direction.normalized();
      angles.push_back(std::acos(std::clamp(a.dot(b), -1.0, 1.0)));
    }
    return median(std::move(angles));
  }

  bool begin() {
    const MatchedPair* best = nullptr;
    double best_score = 0;
    for (const auto& p : pairs_) {
      if (!p.connected()) continue;
      const double angle = parallax(p);
      if (angle < min_start_rad) continue;
      const double score = static_cast<double>(p.kept.size()) * std::min(angle, enough_start_rad);
      if (score <= best_score) continue;
      best_score = score;
      best = &p;
    }
    if (best == nullptr) return false;
    poses_[at(best->view_a)] = Pose::Identity();
    poses_[at(best->view_b)] = best->T_b_a.inverse();
    out_.start = best->view_a;
    settle();
    return true;
  }

  void triangulate() {
    const StartPoints start(data_, poses_);
    points_.assign(tracks_.size(), std::nullopt);
    for (std::size_t i = 0; i < tracks_.size(); ++i)
      points_[i] = start.of(tracks_[i], point_error_factor * max_error_px(tracks_[i].front().view));
  }

  bool add_views() {
    std::vector<std::vector<PointRay>> sights(data_.size());
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (!points_[i]) continue;
      for (const auto& t : tracks_[i])
        if (!poses_[at(t.view)])
          sights[at(t.view)].push_back({*points_[i], data_[at(t.view)].features.features[t.feature].direction});
    }
    std::size_t most = 0;
    for (std::size_t v = 0; v < sights.size(); ++v)
      if (!refused(v, sights[v].size())) most = std::max(most, sights[v].size());
    bool any = false;
    for (std::size_t v = 0; v < sights.size(); ++v) {
      if (poses_[v] || sights[v].empty() || refused(v, sights[v].size())) continue;
      if (static_cast<double>(sights[v].size()) < share_of_best * static_cast<double>(most)) continue;
      tried_with_[v] = sights[v].size();
      const auto found = find_view(sights[v], motion_options(static_cast<int>(v)));
      if (!found) {
        any = true;  // others may follow; this one waits until it sees more
        continue;
      }
      poses_[v] = found->T_world_camera;
      any = true;
    }
    return any;
  }

  // A view that was not found is tried again only when it sees clearly more points.
  bool refused(std::size_t view, std::size_t sights) {
    tried_with_.resize(data_.size(), 0);
    return 4 * sights < 5 * tried_with_[view] + 4 && tried_with_[view] > 0;
  }

  void settle() {
    auto made = make_bundle(data_, pairs_, poses_, with_board_);
    BundleOptions options;
    options.fixed_view = with_board_ ? -1 : first_placed();
    options.passes = 2;
    options.hold_scale = out_.start >= 0;
    const auto report = adjust(made.bundle, options, run_.part(0, 0));
    if (!report.converged) return;
    for (std::size_t v = 0; v < poses_.size(); ++v)
      if (poses_[v]) poses_[v] = made.bundle.T_world_camera[v];
  }

  int first_placed() const {
    if (out_.start >= 0) return out_.start;
    return static_cast<int>(std::ranges::find_if(poses_, [](const auto& p) { return p.has_value(); }) - poses_.begin());
  }

  const std::vector<ViewData>& data_;
  const std::vector<MatchedPair>& pairs_;
  const bool with_board_;
  const PoseOptions& o_;
  std::vector<std::optional<Pose>>& poses_;
  const Run& run_;
  std::vector<std::vector<TrackedFeature>> tracks_;
  std::vector<std::optional<Eigen::Vector3d>> points_;
  std::vector<std::size_t> tried_with_;
  GrownPoses out_;
};

}  // namespace

GrownPoses grow_poses(const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs, bool with_board,
                      const PoseOptions& options, std::vector<std::optional<Pose>>& poses, const Run& run) {
  return Grower(data, pairs, with_board, options, poses, run).grow();
}

}  // namespace bole::rgbd
