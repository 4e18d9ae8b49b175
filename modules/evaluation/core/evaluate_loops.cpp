#include "evaluation/core/evaluate_loops.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/statistics.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {
namespace {

struct Place {
  Eigen::Vector3d at;
  double way_m;
};

constexpr double spacing_m = 1;

// The reference as places a metre apart.
std::vector<Place> places_along(const Trajectory& reference) {
  std::vector<Place> places;
  double way_m = 0;
  for (std::size_t i = 0; i < reference.poses.size(); ++i) {
    const Eigen::Vector3d p = reference.poses[i].T_target_sensor.translation();
    if (i > 0) way_m += (p - reference.poses[i - 1].T_target_sensor.translation()).norm();
    if (places.empty() || way_m - places.back().way_m >= spacing_m) places.push_back({p, way_m});
  }
  return places;
}

double way_until(const Trajectory& reference, double time_s) {
  double way_m = 0;
  for (std::size_t i = 1; i < reference.poses.size() && reference.poses[i].time_s <= time_s; ++i)
    way_m += (reference.poses[i].T_target_sensor.translation() - reference.poses[i - 1].T_target_sensor.translation())
                 .norm();
  return way_m;
}

bool is_chance(const std::vector<Place>& places, std::size_t k, const EvaluationOptions& options) {
  for (std::size_t j = 0; j < k && places[k].way_m - places[j].way_m >= options.loop_path_m; ++j)
    if ((places[k].at - places[j].at).norm() <= options.loop_radius_m) return true;
  return false;
}

struct PoseErrors {
  std::vector<double> shift_m, turn_deg;
  std::vector<std::int64_t> within;
};

PoseErrors pose_errors(const Table& loops, const Trajectory& reference, const EvaluationOptions& options) {
  const auto from_s = loops.numbers("from_time_s"), to_s = loops.numbers("to_time_s");
  const auto x = loops.numbers("x_m"), y = loops.numbers("y_m"), z = loops.numbers("z_m"), qx = loops.numbers("qx"),
             qy = loops.numbers("qy"), qz = loops.numbers("qz"), qw = loops.numbers("qw");
  PoseErrors out;
  for (std::size_t i = 0; i < from_s.size(); ++i) {
    Pose T = Pose::Identity();
    T.linear() = Eigen::Quaterniond(qw[i], qx[i], qy[i], qz[i]).normalized().toRotationMatrix();
    T.translation() = Eigen::Vector3d(x[i], y[i], z[i]);
    const Pose error = (reference.at(from_s[i]).inverse() * reference.at(to_s[i])).inverse() * T;
    out.shift_m.push_back(error.translation().norm());
    out.turn_deg.push_back(degrees(Eigen::AngleAxisd(error.linear()).angle()));
    out.within.push_back(out.shift_m.back() <= options.loop_shift_m && out.turn_deg.back() <= options.loop_turn_deg);
  }
  return out;
}

}  // namespace

LoopEvaluation evaluate_loops(const Table& loops, const Trajectory& reference, const EvaluationOptions& options) {
  const auto from_s = loops.numbers("from_time_s"), to_s = loops.numbers("to_time_s");
  if (reference.poses.size() < 2)
    throw bad_input("the reference has " + std::to_string(reference.poses.size()) + " poses", "at least 2");
  LoopEvaluation out;
  std::vector<double> distance_m, right_way_m;
  std::vector<std::int64_t> right;
  for (std::size_t i = 0; i < from_s.size(); ++i) {
    const double d = (reference.at(from_s[i]).translation() - reference.at(to_s[i]).translation()).norm();
    distance_m.push_back(d);
    right.push_back(d <= options.loop_radius_m);
    if (right.back()) right_way_m.push_back(way_until(reference, to_s[i]));
  }
  out.found = from_s.size();
  out.right = right_way_m.size();
  out.wrong = out.found - out.right;

  const auto places = places_along(reference);
  std::size_t chances = 0, used = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!is_chance(places, k, options)) continue;
    ++chances;
    used += std::ranges::any_of(right_way_m,
                                [&](double w) { return std::abs(w - places[k].way_m) <= options.loop_radius_m; });
  }
  SummaryRows summary(PublishedPlot::none);
  const auto percent = [](std::size_t part, std::size_t whole) {
    return whole ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : std::nan("");
  };
  summary.add("loops_found", static_cast<double>(out.found), "");
  summary.add("loops_right", static_cast<double>(out.right), "");
  summary.add("loops_wrong", static_cast<double>(out.wrong), "");
  summary.add("loop_precision", percent(out.right, out.found), "%");
  out.loops = loops;
  out.loops.set("distance_m", distance_m);
  out.loops.set("right", right);
  if (loops.has("qw")) {
    const auto errors = pose_errors(loops, reference, options);
    out.true_poses = static_cast<std::size_t>(std::ranges::count(errors.within, 1));
    summary.add("loops_true_pose", static_cast<double>(out.true_poses), "");
    summary.add("loop_pose_precision", percent(out.true_poses, out.found), "%");
    summary.add("loop_shift_error_median", median(errors.shift_m), "m");
    summary.add("loop_turn_error_median", median(errors.turn_deg), "deg");
    out.loops.set("shift_error_m", errors.shift_m);
    out.loops.set("turn_error_deg", errors.turn_deg);
    out.loops.set("true_pose", errors.within);
  }
  summary.add("loop_chances", static_cast<double>(chances), "");
  summary.add("loop_recall", percent(used, chances), "%");
  out.summary = summary.table();
  return out;
}

}  // namespace bole::evaluation
