#include "steering/core/track/navigate_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/statistics.h"
#include "steering/core/navigation_log.h"
#include "steering/core/navigator.h"
#include "steering/core/track/accepted_fixes.h"
#include "steering/core/track/track_headings.h"

namespace bole::steering {
namespace {

constexpr double too_poor_m = 0.1;    // for errors of steering, which are centimetres
constexpr double start_look_s = 1.0;  // over which the first velocity is taken

struct Velocity {
  Eigen::Vector2d m_s = Eigen::Vector2d::Zero();
  double sigma_m_s = 1;
};

// By the fixes of the next second in the same segment.
Velocity first_velocity(const std::vector<AntennaFix>& fixes, std::size_t i) {
  std::size_t j = i;
  while (j + 1 < fixes.size() && fixes[j + 1].segment == fixes[i].segment &&
         fixes[j].time_s - fixes[i].time_s < start_look_s)
    ++j;
  if (j == i) return {};
  const double dt = fixes[j].time_s - fixes[i].time_s;
  return {(fixes[j].antenna_nav - fixes[i].antenna_nav) / dt,
          std::max(1.0, std::hypot(fixes[i].sigma_m, fixes[j].sigma_m) / dt)};
}

void check_columns(const Table& track) {
  for (const char* name : {"x_m", "y_m"})
    if (!track.has(name))
      throw bad_input(
          std::string("the track has no ") + name + (track.has("latitude_deg") ? ", but latitude and longitude" : ""),
          "positions in metres", "Put stage geo.project before");
  if (!track.has("time_s")) throw bad_input("the track has no times", "time_s");
}

void tell_left_out(const FixesLeftOut& left_out, std::size_t kept, Report& report) {
  report.counts["without_position"] = left_out.without_place;
  report.counts["poor_fixes"] = left_out.poor;
  report.counts["back_in_time"] = left_out.back_in_time;
  for (const auto& [quality, count] : left_out.by_quality)
    report.counts[quality == -1 ? std::string("quality_unknown") : fmt::format("quality_{}", quality)] = count;
  if (left_out.poor > 0)
    report.find(Severity::look, "poor_fixes",
                fmt::format("{} of {} fixes have a quality that is not accepted and are left out ({})", left_out.poor,
                            kept + static_cast<std::size_t>(left_out.poor), qualities_text(left_out)));
  if (left_out.back_in_time > 0)
    report.find(
        Severity::look, "times_run_back",
        fmt::format("{} fixes go back in time and are left out: look whether two logs were joined, or the clock "
                    "was set",
                    left_out.back_in_time));
}

void tell_heading(const TrackAttitudes& attitudes, const NavigateOptions& o, const Table& track, Report& report) {
  report.counts["heading_measured"] = static_cast<std::int64_t>(attitudes.measured);
  report.counts["heading_by_course"] = static_cast<std::int64_t>(attitudes.by_course);
  report.counts["heading_by_motion"] = static_cast<std::int64_t>(attitudes.by_motion);
  const bool arm = std::hypot(o.antenna_forward, o.antenna_left) > 0;
  if (!arm && o.antenna_up == 0) {
    report.find(Severity::note, "no_lever_arm",
                "no lever arm is given: positions and errors are those of the antenna, not of the rear axle");
    return;
  }
  if (arm && attitudes.measured + attitudes.by_course == 0)
    report.find(Severity::note, "heading_from_motion",
                "the lever arm is turned by the direction of motion, which lags in turns and is wrong in reverse");
  if (arm && attitudes.measured + attitudes.by_course > 0 && !track.has("convergence_deg"))
    report.find(Severity::note, "no_convergence",
                "headings count from true north and the track does not say by how much grid north differs");
  if (o.antenna_up != 0 && !attitudes.tilt_known)
    report.find(
        Severity::look, "no_tilt",
        fmt::format("roll and pitch are unknown: the antenna is {:g} m up and moves the control point by {:.1f} "
                    "cm per degree of side slope",
                    o.antenna_up, 100 * std::abs(o.antenna_up) * std::sin(rad_per_deg)));
}

// The fixes one after the other through lever arm and filter.
struct Filtered {
  NavigationLog log;
  std::int64_t without_heading = 0, gaps = 0, jumps = 0;
  std::vector<double> sigmas;
};

Filtered filter_fixes(const std::vector<AntennaFix>& fixes, const TrackAttitudes& attitudes, bool needs_heading,
                      const NavigateOptions& o, const Run& run) {
  FilterOptions filter_options;
  filter_options.acceleration_sigma = o.acceleration_sigma;
  filter_options.gate = o.gate;
  filter_options.patience = o.patience;
  Navigator navigator(filter_options, {o.antenna_forward, o.antenna_left, o.antenna_up});
  const auto start = [&](const Eigen::Vector2d& position, std::size_t i) {
    const auto velocity = first_velocity(fixes, i);
    navigator.start(position, velocity.m_s, velocity.sigma_m_s);
  };
  Filtered f;
  const AntennaFix* last = nullptr;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (i % 4096 == 0) {
      run.check_cancel();
      run.report(static_cast<double>(i) / static_cast<double>(fixes.size()), "filtering fixes");
    }
    const auto& fix = fixes[i];
    const bool turned = std::isfinite(attitudes.at[i].yaw_rad);
    if (!turned && needs_heading) {
      ++f.without_heading;
      continue;
    }
    const geo::Attitude attitude = turned ? attitudes.at[i] : geo::Attitude{};
    const Eigen::Vector3d antenna(fix.antenna_nav.x(), fix.antenna_nav.y(), 0);
    navigator.filter().set_position_sigma(fix.sigma_m);
    NavigatedPoint point;
    if (last == nullptr || last->segment != fix.segment) {
      f.gaps += last != nullptr && last->run == fix.run ? 1 : 0;
      point.received = point.position = navigator.reduced(antenna, attitude);
      start(point.position, i);
    } else {
      const int jumps = navigator.filter().jumps();
      point = navigator.step(fix.time_s - last->time_s, antenna, attitude);
      // The old velocity may be as wrong as the old position was.
      if (navigator.filter().jumps() > jumps) start(point.position, i);
    }
    last = &fix;
    f.sigmas.push_back(fix.sigma_m);
    f.log.add(fix, attitudes.at[i], point, navigator.filter());
  }
  f.jumps = navigator.filter().jumps();
  return f;
}

void tell_filtered(const Filtered& f, const NavigateOptions& o, Report& report) {
  const auto doubted = f.log.doubted();
  report.counts["fixes"] = static_cast<std::int64_t>(f.sigmas.size());
  report.counts["without_heading"] = f.without_heading;
  report.counts["gaps"] = f.gaps;
  report.counts["doubted"] = doubted;
  report.counts["jumps"] = f.jumps;
  const double typical = median(f.sigmas);
  report.metrics["fix_sigma"] = {typical, Unit::metre};
  if (f.without_heading > 0)
    report.find(Severity::look, "without_heading",
                fmt::format("{} fixes have no heading and are left out", f.without_heading));
  if (f.gaps > 0)
    report.find(Severity::look, "gaps",
                fmt::format("{} gaps of more than {:g} s: what was driven there is unknown", f.gaps, o.max_gap));
  if (doubted > 0)
    report.find(Severity::look, "doubted_fixes",
                fmt::format("{} fixes lie more than {:g} standard deviations from where they were expected; the "
                            "position jumped {} times",
                            doubted, o.gate, f.jumps));
  if (typical > too_poor_m)
    report.find(Severity::look, "fixes_too_poor",
                fmt::format("the fixes are good to about {:.1f} m: passes can be told by them, errors of steering of "
                            "centimetres cannot",
                            typical));
}

}  // namespace

NavigatedTrack navigate_track(const Table& track, const Table* attitude, const NavigateOptions& o, const Run& run) {
  check_columns(track);
  FixesLeftOut left_out;
  const auto fixes = accepted_fixes(track, o, left_out);
  if (fixes.empty())
    throw bad_input(fmt::format("none of {} positions can be used (fix qualities {})", track.rows(),
                                left_out.by_quality.empty() ? "none" : qualities_text(left_out)),
                    "positions of the qualities " + o.accept, "Change accept, or record with a correction service");
  const auto attitudes = attitudes_of(fixes, track, attitude, o);
  const bool needs_heading =
      std::hypot(o.antenna_forward, o.antenna_left) > 0 || (o.antenna_up != 0 && attitudes.tilt_known);
  if (needs_heading && attitudes.without_heading == fixes.size())
    throw bad_input("the lever arm needs a heading, and neither the track nor its motion gives one",
                    "heading_deg, course_deg, attitudes, or a drive of some metres");
  auto filtered = filter_fixes(fixes, attitudes, needs_heading, o, run);
  NavigatedTrack result;
  auto& report = result.report;
  tell_left_out(left_out, fixes.size(), report);
  tell_heading(attitudes, o, track, report);
  tell_filtered(filtered, o, report);
  if (left_out.by_quality.contains(-1) && !o.position_sigma)
    report.find(Severity::note, "quality_unknown",
                fmt::format("the track gives no fix quality: its fixes are taken to be good to {:g} cm",
                            100 * unknown_sigma_m));
  report.message = fmt::format(
      "{} fixes, good to {:.1f} cm; {} left out", filtered.sigmas.size(), 100 * report.metrics["fix_sigma"].value,
      left_out.poor + left_out.back_in_time + left_out.without_place + filtered.without_heading);
  result.log = std::move(filtered.log).table(track.facts, track.has("run"));
  return result;
}

}  // namespace bole::steering
