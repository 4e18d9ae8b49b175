#include "survey/core/join_trajectory.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "cloud/core/path_passes.h"
#include "cloud/known_facts.h"
#include "survey/core/path_axes.h"
#include "survey/core/path_clock.h"
#include "survey/core/path_fit.h"
#include "survey/core/path_sight.h"

namespace bole::survey {

const OptionTable& option_table(const JoinOptions*) {
  using S = JoinOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<double>>{
          "time_offset",
          &S::time_offset,
          Unit::second,
          {-1e10, 1e10},
          "auto",
          Tier::advanced,
          "Seconds to add to the times of the trajectory to get those of the points. auto: "
          "by the clocks that both can have (GPS, GPS less 1e9 s, GPS week, UTC)."},
      Option<S, double>{"max_gap",
                        &S::max_gap,
                        Unit::second,
                        {0.001, 100},
                        Tier::advanced,
                        "Poses further apart than this are not connected: points between them get no ray."},
      Option<S, double>{"pass_radius",
                        &S::pass_radius,
                        Unit::metre,
                        {0.5, 100},
                        Tier::advanced,
                        "A new pass begins where the path comes this near to an earlier part of the pass. Passes are "
                        "measured apart from one another."},
      Option<S, double>{
          "max_distance",
          &S::max_distance,
          Unit::metre,
          {0.1, 10000},
          Tier::advanced,
          "Greatest distance of the nearest hundredth of the points from the sensor. More means that path "
          "and points have different coordinate systems, and is refused."},
  });
  return table;
}

namespace {

constexpr double longest_path_s = 1e6;

void check_inputs(const PointCloud& points, const Trajectory& trajectory) {
  if (!points.has(arrays::time))
    throw bad_input("the points have no times, so that a trajectory cannot be joined to them",
                    "the time of every point (GPS time in LAS and LAZ, a column time in text)",
                    "Export the cloud with times, or take the trajectory away");
  if (trajectory.poses.size() < 2)
    throw bad_input(fmt::format("the trajectory has {} poses", trajectory.poses.size()), "at least 2");
  const double length = trajectory.poses.back().time_s - trajectory.poses.front().time_s;
  if (!(length < longest_path_s))
    throw bad_input(fmt::format("the trajectory lasts {:.0f} s", length),
                    fmt::format("less than {:.0f} s", longest_path_s), "Check the unit of its times");
  if (const auto it = points.facts.find("turned"); it != points.facts.end())
    throw bad_input(
        "the cloud was turned or scaled when it was read (" + it->second + "): the path has the axes of the file",
        "a cloud and a path in the same axes", "Give both in metres with z up, and set level=none");
}

// The offset by the clocks, with what it means in the report.
double clock_offset(const PathSample& sample, const PathCurve& curve, Report& report) {
  const TimeSpan path{curve.begin_s(), curve.end_s()};
  constexpr double enough = 0.5;  // of the points must have a pose
  std::vector<ClockOffset> fitting;
  std::optional<ClockOffset> best;
  double best_share = 0;
  for (auto& candidate : possible_offsets(sample.span(), path)) {
    const double share = sample.share_with_pose(curve, candidate.offset_s);
    if (share > best_share) best = candidate, best_share = share;
    if (share >= enough) fitting.push_back(std::move(candidate));
  }
  const std::string ranges = fmt::format("the times of the points go {}, those of the trajectory {}",
                                         described(sample.span()), described(path));
  if (fitting.size() > 1)
    throw bad_input(ranges + fmt::format(": offsets of {:.3f} s ({}) and {:.3f} s ({}) both fit", fitting[0].offset_s,
                                         fitting[0].meaning, fitting[1].offset_s, fitting[1].meaning),
                    "clocks that go together in one way", "Set time_offset to one of them");
  if (fitting.size() == 1) {
    if (fitting[0].offset_s != 0)
      report.find(Severity::note, "time_offset",
                  fmt::format("{}: {:.3f} s were added to the times of the trajectory", fitting[0].meaning,
                              fitting[0].offset_s));
    return fitting[0].offset_s;
  }
  if (best)
    throw bad_input(
        ranges + fmt::format(": with an offset of {:.3f} s ({}) only {:.2g} % of the points have a pose",
                             best->offset_s, best->meaning, 100 * best_share),
        "the path of the whole cloud",
        fmt::format("Set time_offset={:.3f} where the path is that of a part of the cloud", best->offset_s));
  throw bad_input(
      ranges + ": no clocks are known by which they go together",
      "a trajectory of the same scan, in GPS time, GPS time less 1e9 s, seconds of the GPS week or Unix time",
      fmt::format("Set time_offset; it is {:.3f} where both begin at the same moment",
                  sample.span().begin - path.begin));
}

// A path that was moved as a whole stays near the points, so that the distances alone do not tell.
void judge_place(const PathSample& sample, const PathCurve& curve, double offset, const PathSample::Fit& fit,
                 const JoinOptions& options, Report& report) {
  if (options.max_distance > JoinOptions{}.max_distance) return;  // the sensor is known to be far from all points
  constexpr double near_m = 4, aside_m = 3, nearer = 0.75, lowest_m = 0, highest_m = 4;
  const auto lie = sample.lie(curve, offset);
  std::string why;
  const auto add = [&why](const std::string& text) { why += (why.empty() ? "" : ", ") + text; };
  if (fit.nearest_m > near_m) add(fmt::format("hardly a point is nearer to it than {:.1f} m", fit.nearest_m));
  if (lie.above_m < lowest_m || lie.above_m > highest_m)
    add(fmt::format("it is {:.1f} m above the lowest points beneath it", lie.above_m));
  if (lie.aside_m > aside_m && lie.centred_m < nearer * fit.median_m)
    add(fmt::format("the middle of the points is {:.1f} m aside of it", lie.aside_m));
  if (!why.empty())
    report.find(Severity::look, "path_place_suspect",
                "the path may be moved against the cloud, so that all rays are wrong: at the times of the points " +
                    why +
                    ". Check that both have the same origin and the same heights; raise max_distance where the "
                    "sensor was carried so");
}

// From a path that was moved by a few metres the sensor would have looked through stems.
void judge_sight(const PointCloud& points, const PathCurve& curve, double offset, Report& report) {
  const auto sight = path_sight(points, curve, offset);
  if (!sight) return;
  report.metrics["rays_through_points"] = {sight->crossing, Unit::none};
  if (sight->doubts_path())
    report.find(Severity::look, "path_looks_through_points",
                fmt::format("from this path {:.0f} % of the rays pass through other points, and {:.0f} % with the path "
                            "moved by about {:+.0f} m in x and {:+.0f} m in y: path and cloud may not have the same "
                            "origin, or their clocks differ, so that all rays are wrong. Nothing was changed",
                            100 * sight->crossing, 100 * sight->crossing_there, sight->better_shift_m.x(),
                            sight->better_shift_m.y()));
}

void check_geometry(const PointCloud& points, const PathSample& sample, const PathCurve& curve, double offset,
                    const JoinOptions& options, Report& report) {
  const auto fit = sample.fit(curve, offset);
  report.metrics["median_distance"] = {fit.median_m, Unit::metre};
  if (!(fit.nearest_m <= options.max_distance))
    throw bad_input(fmt::format("the path does not run through the cloud: all but the nearest hundredth of the points "
                                "are {:.1f} m or more from the sensor that measured them (median {:.1f} m)",
                                fit.nearest_m, fit.median_m),
                    fmt::format("{} m or less, in the coordinate system of the points", options.max_distance),
                    "Move the path into the coordinates of the cloud, or raise max_distance");
  if (fit.judged && fit.median_m > fit.shuffled_m)
    throw bad_input(
        fmt::format("the points do not follow the path: they are {:.1f} m from the sensor at their time, and "
                    "{:.1f} m from where it was at other times",
                    fit.median_m, fit.shuffled_m),
        "a path in the coordinate system and clock of the points",
        "Check axes and time_offset, or take the trajectory away");
  judge_place(sample, curve, offset, fit, options, report);
  judge_sight(points, curve, offset, report);
  const auto shift = sample.best_shift(curve, offset);
  constexpr double min_shift_s = 0.2;
  if (shift.certain && std::abs(shift.seconds) >= min_shift_s)
    report.find(Severity::look, "time_shift_suspect",
                fmt::format("the points lie nearer the path (median {:.2f} m, now {:.2f} m) with {:+.2f} s more: the "
                            "clocks may differ, for instance by leap seconds. Nothing was changed; set "
                            "time_offset={:.3f} where it is so",
                            shift.median_m, fit.median_m, shift.seconds, offset + shift.seconds));
}

}  // namespace

JoinedCloud join_trajectory(const PointCloud& points, const Trajectory& trajectory, const JoinOptions& options,
                            const Run& run) {
  check_inputs(points, trajectory);
  JoinedCloud out;
  out.trajectory = in_axes_of(points, trajectory, out.report);
  const PathCurve curve(out.trajectory, options.max_gap);
  const PathSample sample(points);
  const double offset = options.time_offset ? *options.time_offset : clock_offset(sample, curve, out.report);
  if (const double share = sample.share_with_pose(curve, offset); share < 0.01)
    throw bad_input(
        fmt::format("{:.2g} % of the points have a pose with time_offset={:.3f}: their times go {}, those of "
                    "the trajectory {}",
                    100 * share, offset, described(sample.span()), described({curve.begin_s(), curve.end_s()})),
        "times that overlap");
  check_geometry(points, sample, curve, offset, options, out.report);
  run.report(0.2, "joining points and path");

  constexpr double mark_spacing_m = 1;
  const auto marks = mark_places([&](double t) { return curve.nearest(t); }, curve.begin_s(), curve.end_s(),
                                 mark_spacing_m, options.pass_radius);
  const auto& time = points.values<double>(arrays::time);
  const std::size_t n = points.size();
  constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> x(n, unknown), y(n, unknown), z(n, unknown), range(n, unknown);
  std::vector<std::int32_t> pass(n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1 << 14), [&](const auto& block) {
    if (run.cancelled()) return;
    for (std::size_t i = block.begin(); i < block.end(); ++i) {
      const double t = time[i] - offset;
      pass[i] = mark_at(marks, t).pass;
      const auto place = curve.at(t);
      if (!place) continue;
      const Eigen::Vector3f sensor = (*place - points.origin).template cast<float>();
      x[i] = sensor.x();
      y[i] = sensor.y();
      z[i] = sensor.z();
      range[i] = (points.positions()[i] - sensor).norm();
    }
  });
  run.check_cancel();
  const auto without = static_cast<std::size_t>(std::ranges::count_if(x, [](float v) { return std::isnan(v); }));
  auto& report = out.report;
  report.counts["points"] = static_cast<std::int64_t>(n);
  report.counts["points_without_pose"] = static_cast<std::int64_t>(without);
  report.counts["passes"] = marks.back().pass + 1;
  report.metrics["time_offset"] = {offset, Unit::second};
  report.message = fmt::format("{} of {} points have their ray, {} passes", n - without, n, marks.back().pass + 1);
  constexpr double many = 0.01;
  if (static_cast<double>(without) > many * static_cast<double>(n))
    report.find(Severity::look, "points_without_pose",
                fmt::format("{:.1f} % of the points have no pose at their time and count without a ray: the trajectory "
                            "is shorter than the cloud, or has gaps of more than {} s",
                            100.0 * static_cast<double>(without) / static_cast<double>(n), options.max_gap));
  if (points.has(arrays::sensor_x))
    report.find(Severity::look, "sensor_positions_replaced",
                "the points had sensor positions: those of the trajectory took their place");
  if (points.has(arrays::pass))
    report.find(Severity::look, "passes_replaced", "the points had passes: those of the path took their place");
  out.points = points;
  out.points.set_column(arrays::sensor_x, std::move(x));
  out.points.set_column(arrays::sensor_y, std::move(y));
  out.points.set_column(arrays::sensor_z, std::move(z));
  out.points.set_column(arrays::range, std::move(range));
  out.points.set_column(arrays::pass, std::move(pass));
  set_fact(out.points.facts, PoseOrigin::given);
  out.trajectory.axes = points.axes;
  for (auto& pose : out.trajectory.poses) pose.time_s += offset;
  return out;
}

}  // namespace bole::survey
