#include "survey/core/plot_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "cloud/known_facts.h"
#include "survey/core/choose_targets.h"
#include "survey/core/ground_plane.h"
#include "survey/core/post_centre.h"
#include "survey/core/retro_clusters.h"
#include "survey/core/vertical.h"

namespace bole::survey {
namespace {

class FrameFinder {
 public:
  FrameFinder(const PointCloud& cloud, const Trajectory* trajectory, const FrameOptions& options, const Run& run)
      : cloud_(cloud), trajectory_(trajectory), options_(options), run_(run) {}

  PlotFrame find() {
    if (cloud_.empty()) throw bad_input("the cloud has no points", "at least one");
    run_.report(0.0, "Finding the vertical");
    level();
    run_.report(0.5, "Finding the targets");
    const auto choice = choose();
    run_.report(0.8, "Finding the ground at the centre");
    if (choice.targets.empty())
      keep_map_axes();
    else
      move_to(choice);
    fill_table(choice);
    tell(choice);
    return std::move(frame_);
  }

 private:
  void level() {
    vertical_ = find_vertical(cloud_, options_, run_);
    for (const auto& w : vertical_.warnings) frame_.report.warn(w);
    R_level_map_ = rotation_between(vertical_.up, Eigen::Vector3d::UnitZ());
    frame_.by_gravity = vertical_.method == Level::gravity;
  }

  TargetChoice choose() {
    if (!cloud_.has(arrays::intensity)) {
      frame_.report.warn("the cloud has no array intensity: targets could not be looked for");
      return {};
    }
    auto search = find_retro_clusters(cloud_, options_, run_);
    if (search.too_many)
      frame_.report.warn(
          fmt::format("{} of {} points have an intensity above min_intensity ({}): it does not suit this sensor, "
                      "targets were not looked for",
                      search.strong_points, cloud_.size(), number_text(options_.min_intensity)));
    std::vector<RetroCluster> candidates;
    for (auto& c : search.clusters) {
      if (c.rejected.empty())
        tell_blur(c), candidates.push_back(c);
      else if (c.points >= static_cast<std::size_t>(options_.min_target_points))
        rejected_.push_back(fmt::format("strong returns at ({:.2f}, {:.2f}, {:.2f}): {}", c.centre.x(), c.centre.y(),
                                        c.centre.z(), c.rejected));
    }
    for (std::size_t i = 0; i < rejected_.size(); ++i)
      frame_.report.facts[fmt::format("rejected_{}", i + 1)] = rejected_[i];
    frame_.report.counts["strong_points"] = static_cast<std::int64_t>(search.strong_points);
    frame_.report.counts["target_candidates"] = static_cast<std::int64_t>(candidates.size());
    for (auto& c : candidates) c.centre = levelled_centre(c);
    std::optional<Eigen::Vector3d> start;
    if (trajectory_ && !trajectory_->empty())
      start = R_level_map_ * trajectory_->poses.front().T_target_sensor.translation();
    auto choice = choose_targets(candidates, start, options_);
    for (const auto& w : choice.warnings) frame_.report.warn(w);
    if (choice.targets.size() == 1 && !rejected_.empty())
      frame_.report.warn(fmt::format("not taken for the other target: {}", rejected_.front()));
    return choice;
  }

  void tell_blur(const RetroCluster& c) {
    if (c.extent_m <= options_.target_size) return;
    frame_.report.warn(
        fmt::format("the target at ({:.2f}, {:.2f}, {:.2f}) is {:.2f} m long as seen from one position and {:.2f} m in "
                    "the map: the map is bent or doubled there, and its axes are only as good as that",
                    c.centre.x(), c.centre.y(), c.centre.z(), c.seen_extent_m, c.extent_m));
  }

  // The axis of a round post where that is what was seen, else the mean; its height is that of the mean.
  Eigen::Vector3d levelled_centre(const RetroCluster& cluster) {
    Eigen::Vector3d centre = R_level_map_ * cluster.centre;
    std::vector<Eigen::Vector2d> plan;
    for (const auto i : cluster.members) plan.emplace_back((R_level_map_ * cloud_.position(i) - centre).head<2>());
    const auto post = fit_post(plan, cluster.weights, options_.target_size / 2);
    if (post.valid) centre.head<2>() += post.centre, ++posts_;
    return centre;
  }

  void keep_map_axes() {
    frame_.new_origin = cloud_.origin;
    frame_.T_plot_map.linear() = R_level_map_;
    frame_.T_plot_map.translation() = cloud_.origin - R_level_map_ * cloud_.origin;
  }

  // choice.targets hold levelled coordinates.
  void move_to(const TargetChoice& choice) {
    const Eigen::Vector3d centre = choice.targets.front().position;
    constexpr double radius_m = 1.0;
    const auto ground = ground_height_at(cloud_, R_level_map_, centre.head<2>(), radius_m, run_);
    if (!ground)
      frame_.report.warn(
          "there are too few points around the centre target to tell the height of the ground: z is zero at the "
          "target");
    double turn_rad = 0;
    if (choice.targets.size() == 2) {
      const Eigen::Vector3d to_north = choice.targets[1].position - centre;
      turn_rad =
          std::numbers::pi / 2 - options_.north_bearing_deg * rad_per_deg - std::atan2(to_north.y(), to_north.x());
      frame_.axes = Axes::plot;
      frame_.report.metrics["target_distance"] = {to_north.head<2>().norm(), Unit::metre};
    }
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    frame_.T_plot_map.linear() = turn * R_level_map_;
    frame_.T_plot_map.translation() = -(turn * Eigen::Vector3d(centre.x(), centre.y(), ground.value_or(centre.z())));
  }

  void fill_table(const TargetChoice& choice) {
    const Pose T_plot_level = frame_.T_plot_map * Pose(R_level_map_.transpose());
    std::vector<std::string> names;
    std::vector<double> x, y, z;
    std::vector<std::int64_t> points;
    for (const auto& t : choice.targets) {
      const Eigen::Vector3d p = T_plot_level * t.position;
      names.push_back(t.name), x.push_back(p.x()), y.push_back(p.y()), z.push_back(p.z());
      points.push_back(static_cast<std::int64_t>(t.points));
    }
    frame_.targets.set("name", std::move(names));
    frame_.targets.set("x_m", std::move(x));
    frame_.targets.set("y_m", std::move(y));
    frame_.targets.set("z_m", std::move(z));
    frame_.targets.set("points", std::move(points));
    frame_.targets.facts = cloud_.facts;
    set_fact(frame_.targets.facts, facts::axes, axes_name(frame_.axes));
  }

  void tell(const TargetChoice& choice) {
    auto& report = frame_.report;
    const double tilt_deg = std::acos(std::clamp(vertical_.up.z(), -1.0, 1.0)) / rad_per_deg;
    report.facts["axes"] = axes_name(frame_.axes);
    report.facts["level"] = choice_name(vertical_.method);
    if (!choice.reason.empty()) report.facts["centre"] = choice.reason;
    report.counts["targets"] = static_cast<std::int64_t>(choice.targets.size());
    report.counts["round_targets"] = posts_;
    report.counts["stems_for_level"] = static_cast<std::int64_t>(vertical_.stems);
    report.metrics["tilt"] = {tilt_deg, Unit::degree};
    std::string level = "not levelled";
    if (vertical_.method == Level::ground) level = fmt::format("levelled by the ground (tilt {:.2f} deg)", tilt_deg);
    if (vertical_.method == Level::gravity) {
      report.metrics["tilt_standard_error"] = {degrees(vertical_.standard_error_rad), Unit::degree};
      level = fmt::format("level by gravity (+- {:.2f} deg)", degrees(vertical_.standard_error_rad));
    }
    if (vertical_.method == Level::stems) {
      report.metrics["tilt_standard_error"] = {vertical_.standard_error_rad / rad_per_deg, Unit::degree};
      report.metrics["stem_lean_scatter"] = {vertical_.scatter_rad / rad_per_deg, Unit::degree};
      level = fmt::format("levelled by {} stems (tilt {:.2f} +- {:.2f} deg)", vertical_.stems, tilt_deg,
                          vertical_.standard_error_rad / rad_per_deg);
    }
    if (choice.targets.size() == 2)
      report.message =
          fmt::format("Plot axes from two targets {:.2f} m apart, {}.", report.metrics["target_distance"].value, level);
    else
      report.message = fmt::format("Map axes kept: {} found; {}.",
                                   choice.targets.empty() ? "no targets were" : "only one target was", level);
  }

  const PointCloud& cloud_;
  const Trajectory* trajectory_;
  const FrameOptions& options_;
  const Run& run_;
  Vertical vertical_;
  Eigen::Matrix3d R_level_map_ = Eigen::Matrix3d::Identity();
  PlotFrame frame_;
  std::vector<std::string> rejected_;  // most views first
  int posts_ = 0;
};

}  // namespace

PlotFrame find_plot_frame(const PointCloud& points_in_map, const Trajectory* trajectory_in_map,
                          const FrameOptions& options, const Run& run) {
  return FrameFinder(points_in_map, trajectory_in_map, options, run).find();
}

}  // namespace bole::survey
