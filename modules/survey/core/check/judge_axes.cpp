#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/no_number.h"
#include "cloud/core/walk_facts.h"
#include "cloud/known_facts.h"
#include "cloud/robust_mean.h"
#include "cloud/stem_rows.h"
#include "cloud/table_columns.h"
#include "survey/core/check/judge_map.h"

namespace bole::survey {
namespace {

struct Disagreement {
  double shift_m = 0, turn_deg = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
};

// What the loop closures say of the relative pose of two keyframes, less what the trajectory says.
std::vector<Disagreement> disagreements(const Table& loops, const Trajectory& trajectory, std::size_t& outside) {
  std::vector<Disagreement> all;
  const auto from = loops.numbers("from_time_s"), to = loops.numbers("to_time_s");
  const auto x = loops.numbers("x_m"), y = loops.numbers("y_m"), z = loops.numbers("z_m");
  const auto qx = loops.numbers("qx"), qy = loops.numbers("qy"), qz = loops.numbers("qz"), qw = loops.numbers("qw");
  const double begin = trajectory.poses.front().time_s, end = trajectory.poses.back().time_s;
  constexpr double slack_s = 0.15;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto known = [&](double t) { return t >= begin - slack_s && t <= end + slack_s; };
    if (!known(from[i]) || !known(to[i])) {
      ++outside;
      continue;
    }
    Pose loop = Pose::Identity();
    loop.linear() = Eigen::Quaterniond(qw[i], qx[i], qy[i], qz[i]).normalized().toRotationMatrix();
    loop.translation() = Eigen::Vector3d(x[i], y[i], z[i]);
    const Pose T_map_from = trajectory.at(from[i]), T_map_to = trajectory.at(to[i]);
    const Pose off = loop.inverse() * T_map_from.inverse() * T_map_to;
    all.push_back({off.translation().norm(), degrees(so3_log(Eigen::Quaterniond(off.linear())).norm()),
                   T_map_to.translation().head<2>()});
  }
  return all;
}

// The robust mean of the directions of the stems, as the tangents of their lean along x and y.
RobustMean common_lean(const Table& stems) {
  const auto lean = numbers_or_nan(stems, "lean_deg"), azimuth = numbers_or_nan(stems, "lean_azimuth_deg");
  std::vector<Eigen::VectorXd> all;
  for (const auto i : kept_rows(stems)) {
    if (!std::isfinite(lean[i])) continue;
    const double turn = std::isfinite(azimuth[i]) ? radians(azimuth[i]) : 0;
    all.emplace_back(std::tan(radians(lean[i])) * Eigen::Vector2d(std::sin(turn), std::cos(turn)));
  }
  constexpr std::size_t needed = 5;
  constexpr double min_sigma = 0.003;
  return all.size() < needed ? RobustMean{} : robust_mean(all, {}, min_sigma);
}

void judge_level(const CheckedMap& map, CheckFindings& out) {
  if (map.in.stems == nullptr) return out.skip("level", "there is no stem table");
  const auto lean = common_lean(*map.in.stems);
  if (lean.mean.size() == 0) return out.skip("level", "fewer than 5 stems with a lean");
  const Eigen::Vector2d mean = lean.mean;
  const double tilt = degrees(std::atan(mean.norm())), error = degrees(lean.standard_error);
  map.report.metrics["common_lean"] = {tilt, Unit::degree};
  map.report.metrics["common_lean_se"] = {error, Unit::degree};
  constexpr double certain = 3.5;
  if (tilt <= map.options.max_tilt_deg || tilt < certain * error) return;
  const auto gravity_deg = map.in.points ? fact_number(map.in.points->facts, facts::level_sigma) : std::nullopt;
  if (gravity_deg && tilt > certain * std::hypot(error, *gravity_deg))
    return out.skip("level", fmt::format("the stems lean by {:.1f} deg together, and z is up by gravity to {:.2f} deg: "
                                         "the stand leans, not the frame",
                                         tilt, *gravity_deg));
  double bearing = degrees(std::atan2(mean.x(), mean.y()));
  if (bearing < 0) bearing += 360;
  out.add(
      Severity::look, "frame_tilted",
      fmt::format("the stems lean by {:.1f} +- {:.1f} deg together, towards {:.0f} deg from north: the frame is "
                  "tilted, or the whole stand leans. A tilt moves stems by {:.1f} cm at breast height and terrain by "
                  "{:.0f} cm over 10 m. Level by the stems (level=stems), or check the slope by hand",
                  tilt, 1.96 * error, bearing, 130 * mean.norm(), 1000 * mean.norm()));
}

void judge_targets(const CheckedMap& map, CheckFindings& out) {
  const auto& o = map.options;
  if (map.in.targets == nullptr) return out.skip("targets", "targets are not connected");
  if (o.targets == 0) return out.skip("targets", "none are needed (targets=0)");
  const auto names = texts_or_empty(*map.in.targets, "name");
  const auto x = numbers_or_nan(*map.in.targets, "x_m"), y = numbers_or_nan(*map.in.targets, "y_m");
  const auto found = map.in.targets->rows();
  if (found < static_cast<std::size_t>(o.targets)) {
    out.add(Severity::look, "target_missing",
            fmt::format("{} of {} targets were found{}: {} not known. Say targets={} if no more stood there", found,
                        o.targets, found > 0 ? " (" + names.front() + ")" : "",
                        found == 0 ? "origin and north of the plot are" : "north of the plot is", found));
    return;
  }
  if (o.targets < 2 || found < 2) return;
  const double distance = std::hypot(x[1] - x[0], y[1] - y[0]);
  map.report.metrics["target_distance"] = {distance, Unit::metre};
  if (o.target_distance <= 0) return out.skip("distance of the targets", "the distance by tape is not given");
  const double error = distance - o.target_distance;
  if (std::abs(error) <= o.target_tolerance) return;
  constexpr double hopeless = 10;
  out.add(
      std::abs(error) > hopeless * o.target_tolerance ? Severity::refused : Severity::look, "target_distance",
      fmt::format("the targets stand {:.3f} m apart in the map and {:.3f} m by tape ({:+.3f} m): the map is bent, or "
                  "something else was taken for a target",
                  distance, o.target_distance, error),
      Eigen::Vector2d(x[1], y[1]));
}

// Distances, areas and values per hectare of a map rest on the length of the walk; stems.measure has it from the stems.
void judge_length(const CheckedMap& map, CheckFindings& out) {
  const auto stretch = map.in.stems == nullptr ? std::nullopt : fact_number(map.in.stems->facts, facts::range_stretch);
  if (!stretch) return out.skip("length of the walk", "no stems were measured along rays");
  map.report.metrics["length_error"] = {-*stretch, Unit::percent};
  if (std::abs(*stretch) <= map.options.max_length_error_pct) return;
  const char* is = *stretch > 0 ? "short" : "long";
  if (fact_number(map.in.stems->facts, facts::walk_lengthened))
    return out.add(
        Severity::look, "walk_length",
        fmt::format("the walk is {:.2f} % too {} in the map of SLAM: {:.1f} cm in 30 m. Cloud and stems were "
                    "made to fit the ranges; trajectory, terrain and targets were not. Run SLAM with "
                    "preset=best, or compare with control points",
                    std::abs(*stretch), is, 30 * std::abs(*stretch)));
  out.add(Severity::look, "walk_length",
          fmt::format("the walk is {:.2f} % too {} in the map, and distances between stems with it: {:.1f} cm in 30 m, "
                      "and {:.1f} % in values per hectare. Run SLAM with preset=best, or compare with control points",
                      std::abs(*stretch), is, 30 * std::abs(*stretch), 2 * std::abs(*stretch)));
}

}  // namespace

void judge_loops(const CheckedMap& map, CheckFindings& out) {
  const auto* loops = map.in.loops;
  const auto* path = map.in.trajectory;
  if (loops == nullptr || path == nullptr || path->poses.size() < 2)
    return out.skip("loop closures", "there are no loop closures or no trajectory");
  if (loops->rows() == 0) return out.skip("loop closures", "none were found, or the poses were given");
  std::size_t outside = 0;
  const auto all = disagreements(*loops, *path, outside);
  if (outside > 0) out.skip("loop closures", fmt::format("{} lie outside of the trajectory", outside));
  if (all.empty()) return;
  double worst_turn = 0;
  for (const auto& d : all) worst_turn = std::max(worst_turn, d.turn_deg);
  const auto& worst = *std::ranges::max_element(all, {}, &Disagreement::shift_m);
  map.report.metrics["loop_residual_max"] = {worst.shift_m, Unit::metre};
  map.report.metrics["loop_turn_max"] = {worst_turn, Unit::degree};
  const auto& o = map.options;
  const auto bad = std::ranges::count_if(
      all, [&](const auto& d) { return d.shift_m > o.max_loop_residual || d.turn_deg > o.max_loop_turn_deg; });
  if (bad == 0) return;
  constexpr double slipped = 5;
  out.add(
      worst.shift_m > slipped * o.max_loop_residual ? Severity::refused : Severity::look, "loops_disagree",
      fmt::format("{} of {} loop closures disagree with the final trajectory, by up to {:.2f} m and {:.1f} deg: one of "
                  "them is wrong, or the map is strained. Run slam again without it",
                  bad, all.size(), worst.shift_m, worst_turn),
      worst.at);
}

void judge_axes(const CheckedMap& map, CheckFindings& out) {
  judge_level(map, out);
  judge_targets(map, out);
  judge_length(map, out);
}

}  // namespace bole::survey
