#include "evaluation/core/evaluate_trajectory.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {
namespace {

struct PosePair {
  double time;
  Pose estimate, reference;
};

std::vector<PosePair> associate(const Trajectory& estimate, const Trajectory& reference, double max_gap) {
  std::vector<PosePair> pairs;
  for (const auto& e : estimate.poses) {
    const auto after = std::ranges::lower_bound(reference.poses, e.time_s, {}, &StampedPose::time_s);
    if (after == reference.poses.end()) break;
    if (after->time_s == e.time_s) {
      pairs.push_back({e.time_s, e.T_target_sensor, after->T_target_sensor});
      continue;
    }
    if (after == reference.poses.begin()) continue;
    const auto& a = *(after - 1);
    if (after->time_s - a.time_s > max_gap) continue;
    pairs.push_back(
        {e.time_s, e.T_target_sensor,
         interpolate(a.T_target_sensor, after->T_target_sensor, (e.time_s - a.time_s) / (after->time_s - a.time_s))});
  }
  return pairs;
}

Pose best_pose_motion(const std::vector<PosePair>& pairs) {
  Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(pairs.size())), to = from;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    from.col(static_cast<Eigen::Index>(i)) = pairs[i].estimate.translation();
    to.col(static_cast<Eigen::Index>(i)) = pairs[i].reference.translation();
  }
  return Pose(Eigen::umeyama(from, to, false));
}

double angle_of(const Pose& T) { return Eigen::AngleAxisd(T.linear()).angle(); }

struct Spread {
  double rmse = 0, mean = 0, median = 0, largest = 0, sd = 0;
};

Spread spread_of(std::vector<double> v) {
  Spread s;
  const auto n = static_cast<double>(v.size());
  for (const double e : v) s.mean += e / n, s.rmse += e * e / n;
  s.sd = std::sqrt(std::max(0.0, s.rmse - s.mean * s.mean));
  s.rmse = std::sqrt(s.rmse);
  std::ranges::sort(v);
  const auto half = v.size() / 2;
  s.median = v.size() % 2 == 1 ? v[half] : (v[half - 1] + v[half]) / 2;
  s.largest = v.back();
  return s;
}

void add_spread(const std::string& name, const std::vector<double>& values, const std::string& unit, SummaryRows& out) {
  if (values.empty()) return;
  const auto s = spread_of(values);
  out.add(name + "_rmse", s.rmse, unit);
  out.add(name + "_mean", s.mean, unit);
  out.add(name + "_median", s.median, unit);
  out.add(name + "_sd", s.sd, unit);
  out.add(name + "_max", s.largest, unit);
}

void add_relative_errors(const std::vector<PosePair>& pairs, double step, SummaryRows& out) {
  std::vector<double> translation, rotation;
  for (std::size_t i = 0, j = 0; i < pairs.size(); ++i) {
    while (j < pairs.size() && pairs[j].time < pairs[i].time + step - 1e-9) ++j;
    if (j == pairs.size()) break;
    if (pairs[j].time - pairs[i].time > 1.5 * step) continue;  // a gap
    const Pose error = (pairs[i].reference.inverse() * pairs[j].reference).inverse() *
                       (pairs[i].estimate.inverse() * pairs[j].estimate);
    translation.push_back(error.translation().norm());
    rotation.push_back(angle_of(error) * deg_per_rad);
  }
  add_spread("rpe_translation", translation, "m", out);
  add_spread("rpe_rotation", rotation, "deg", out);
}

std::vector<double> way_along(const std::vector<PosePair>& pairs) {
  std::vector<double> way_m(pairs.size(), 0);
  for (std::size_t i = 1; i < pairs.size(); ++i)
    way_m[i] = way_m[i - 1] + (pairs[i].reference.translation() - pairs[i - 1].reference.translation()).norm();
  return way_m;
}

// From every pose to the first one at least `distance_m` of way later. Nothing where the path is too short. The error
// of length is that of the steps along themselves, so that noise across them does not count.
void add_relative_errors_by_distance(const std::vector<PosePair>& pairs, double distance_m, SummaryRows& out) {
  const auto way_m = way_along(pairs);
  std::vector<double> translation, rotation;
  double along = 0, square = 0;
  for (std::size_t i = 0, j = 0; i < pairs.size(); ++i) {
    while (j < pairs.size() && way_m[j] < way_m[i] + distance_m) ++j;
    if (j == pairs.size()) break;
    const Pose step = pairs[i].reference.inverse() * pairs[j].reference,
               estimated = pairs[i].estimate.inverse() * pairs[j].estimate, error = step.inverse() * estimated;
    along += estimated.translation().dot(step.translation()), square += step.translation().squaredNorm();
    translation.push_back(error.translation().norm());
    rotation.push_back(angle_of(error) * deg_per_rad);
  }
  add_spread("rpe_distance_translation", translation, "m", out);
  add_spread("rpe_distance_rotation", rotation, "deg", out);
  if (square > 0) out.add("length_error", 100 * (along / square - 1), "%");
}

// KITTI (Geiger et al. 2012): the error of the motion over segments of 1 to 8 times `segment_m`, started every tenth of
// that, as a share of the length; translation in %, rotation in deg / m. Nothing where the path is too short.
void add_segment_errors(const std::vector<PosePair>& pairs, double segment_m, SummaryRows& out) {
  const auto way_m = way_along(pairs);
  double translation = 0, rotation = 0, next_m = 0;
  std::size_t segments = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (way_m[i] < next_m) continue;
    next_m = way_m[i] + 0.1 * segment_m;
    for (int k = 1; k <= 8; ++k) {
      const double length_m = k * segment_m;
      const auto end = std::ranges::lower_bound(way_m, way_m[i] + length_m);
      if (end == way_m.end()) break;
      const auto& last = pairs[static_cast<std::size_t>(end - way_m.begin())];
      const Pose error =
          (pairs[i].reference.inverse() * last.reference).inverse() * (pairs[i].estimate.inverse() * last.estimate);
      translation += 100 * error.translation().norm() / length_m;
      rotation += deg_per_rad * angle_of(error) / length_m;
      ++segments;
    }
  }
  if (segments == 0) return;
  out.add("kitti_segments", static_cast<double>(segments), "");
  out.add("kitti_translation", translation / static_cast<double>(segments), "%");
  out.add("kitti_rotation", rotation / static_cast<double>(segments), "deg/m");
}

Table error_table(const std::vector<PosePair>& pairs) {
  std::vector<double> time, x, y, z, e, ex, ey, ez, er;
  for (const auto& p : pairs) {
    const Eigen::Vector3d at = p.reference.translation(), d = p.estimate.translation() - at;
    time.push_back(p.time);
    x.push_back(at.x());
    y.push_back(at.y());
    z.push_back(at.z());
    e.push_back(d.norm());
    ex.push_back(d.x());
    ey.push_back(d.y());
    ez.push_back(d.z());
    er.push_back(angle_of(p.reference.inverse() * p.estimate) * deg_per_rad);
  }
  Table t;
  t.set("time_s", time);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("z_m", z);
  t.set("error_m", e);
  t.set("error_x_m", ex);
  t.set("error_y_m", ey);
  t.set("error_z_m", ez);
  t.set("rotation_error_deg", er);
  return t;
}

}  // namespace

TrajectoryEvaluation evaluate_trajectory(const Trajectory& estimate, const Trajectory& reference,
                                         const EvaluationOptions& options) {
  auto pairs = associate(estimate, reference, options.max_time_gap);
  if (pairs.size() < 3) {
    const auto span = [](const Trajectory& t) {
      return t.empty() ? std::string("empty")
                       : fmt::format("{:.3f} to {:.3f} s", t.poses.front().time_s, t.poses.back().time_s);
    };
    throw bad_input(fmt::format("{} of {} poses have a reference at their time (estimate {}, reference {})",
                                pairs.size(), estimate.poses.size(), span(estimate), span(reference)),
                    "at least 3", "Check that both trajectories use the same clock, or raise max_time_gap");
  }
  TrajectoryEvaluation out;
  out.poses = pairs.size();
  double length = 0;
  for (std::size_t i = 1; i < pairs.size(); ++i)
    length += (pairs[i].reference.translation() - pairs[i - 1].reference.translation()).norm();
  const Pose end_error = (pairs.front().reference.inverse() * pairs.back().reference).inverse() *
                         (pairs.front().estimate.inverse() * pairs.back().estimate);
  if (options.align_trajectory == AlignTrajectory::se3) out.T_reference_estimate = best_pose_motion(pairs);
  for (auto& p : pairs) p.estimate = out.T_reference_estimate * p.estimate;

  std::vector<double> position, rotation;
  for (const auto& p : pairs) {
    position.push_back((p.estimate.translation() - p.reference.translation()).norm());
    rotation.push_back(angle_of(p.reference.inverse() * p.estimate) * deg_per_rad);
  }
  SummaryRows summary(options.published_plot);
  summary.add("poses", static_cast<double>(pairs.size()), "");
  summary.add("length", length, "m");
  add_spread("ate", position, "m", summary);
  add_spread("rotation_error", rotation, "deg", summary);
  add_relative_errors(pairs, options.rpe_step, summary);
  add_relative_errors_by_distance(pairs, options.rpe_distance_m, summary);
  add_segment_errors(pairs, options.segment_m, summary);
  summary.add("end_error", end_error.translation().norm(), "m");
  if (length > 0) summary.add("drift", 100 * end_error.translation().norm() / length, "%");
  out.summary = summary.table();
  out.errors = error_table(pairs);
  return out;
}

}  // namespace bole::evaluation
