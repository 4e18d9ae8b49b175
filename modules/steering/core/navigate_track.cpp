#include "steering/core/navigate_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/option_text.h"
#include "base/statistics.h"
#include "cloud/table_columns.h"
#include "steering/core/navigator.h"
#include "steering/core/track_headings.h"

namespace bole::steering {

const OptionTable& option_table(const NavigateOptions*) {
  using S = NavigateOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Number{"antenna_forward",
             &S::antenna_forward,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Distance of the antenna ahead of the control point (middle of the rear axle on the ground)."},
      Number{"antenna_left",
             &S::antenna_left,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Distance of the antenna to the left of the control point."},
      Number{"antenna_up",
             &S::antenna_up,
             Unit::metre,
             {-20, 20},
             Tier::basic,
             "Height of the antenna above the control point. It counts where roll and pitch are known."},
      Option<S, HeadingSource>{"heading", &S::heading, Tier::advanced,
                               "Heading that turns the lever arm: measured (two antennas or attitudes), course of the "
                               "receiver, or direction of motion. auto: the first of these that a fix has."},
      Number{"heading_offset",
             &S::heading_offset_deg,
             Unit::degree,
             {-360, 360},
             Tier::advanced,
             "Angle by which the measured heading is turned clockwise from the vehicle's, as antennas mounted across "
             "it give."},
      Option<S, std::string>{
          "accept",
          &S::accept,
          TextKind::plain,
          {},
          Tier::basic,
          "Fix qualities that are used, as numbers of GGA sentences: 1 single, 2 differential, 4 RTK "
          "fixed, 5 RTK float."},
      Option<S, std::optional<double>>{"position_sigma",
                                       &S::position_sigma,
                                       Unit::metre,
                                       {1e-4, 100},
                                       "auto",
                                       Tier::basic,
                                       "Standard deviation per axis of a fix. auto: as the receiver gives it, else by "
                                       "the fix quality, else 1 cm."},
      Number{"acceleration_sigma",
             &S::acceleration_sigma,
             Unit::none,
             {1e-4, 100},
             Tier::advanced,
             "Standard deviation of the acceleration of the vehicle, m/s2. A larger value smooths less."},
      Number{"gate",
             &S::gate,
             Unit::none,
             {1, 1000},
             Tier::advanced,
             "Distance from the prediction, in standard deviations, beyond which a fix is doubted."},
      Number{"patience",
             &S::patience,
             Unit::second,
             {0, 600},
             Tier::advanced,
             "Time for which doubted fixes are ignored. Then the filter starts again at the new position."},
      Number{"max_gap",
             &S::max_gap,
             Unit::second,
             {0.1, 3600},
             Tier::advanced,
             "The filter starts anew after a longer time without fixes."},
  });
  return table;
}

namespace {

constexpr double unknown_sigma_m = 0.01;  // of a track that says nothing: as the filter of the simulated drive
constexpr double too_poor_m = 0.1;        // for errors of steering, which are centimetres
constexpr double start_look_s = 1.0;      // over which the first velocity is taken

// Standard deviation per axis that receivers of each quality usually have in the open, by GGA number.
double usual_sigma_m(std::int64_t quality) {
  switch (quality) {
    case 4:
      return 0.02;
    case 5:
      return 0.3;
    case 2:
    case 3:
    case 9:
      return 0.7;
    case -1:
      return unknown_sigma_m;
    default:
      return 2.5;
  }
}

std::set<std::int64_t> accepted_qualities(const std::string& list) {
  std::set<std::int64_t> accepted;
  std::string words = list;
  std::ranges::replace(words, ',', ' ');
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (word.size() != 1 || word[0] < '0' || word[0] > '9')
      throw bad_input("accept is '" + list + "': '" + word + "' is no fix quality", "digits of GGA sentences, 0 to 9",
                      "Write for instance \"4 5\"");
    accepted.insert(word[0] - '0');
  }
  if (accepted.empty()) throw bad_input("accept is empty", "at least one fix quality", "Write for instance \"4 5\"");
  return accepted;
}

// What is left out, by reason.
struct LeftOut {
  std::int64_t without_place = 0, poor = 0, back_in_time = 0;
  std::map<std::int64_t, std::int64_t> by_quality;  // of all fixes
};

class Fixes {
 public:
  Fixes(const Table& track, const NavigateOptions& options)
      : o_(options),
        time_(track.numbers("time_s")),
        x_(track.numbers("x_m")),
        y_(track.numbers("y_m")),
        quality_(numbers_or_nan(track, "quality")),
        sd_east_(numbers_or_nan(track, "sd_east_m")),
        sd_north_(numbers_or_nan(track, "sd_north_m")),
        run_(track.has("run") ? track.integers("run") : std::vector<std::int64_t>(track.rows(), 1)),
        accepted_(accepted_qualities(options.accept)) {
    // Quality 0 means no fix where a log tells qualities, and nothing where it tells none: RMC sentences alone.
    if (std::ranges::none_of(quality_, [](double q) { return q > 0; })) accepted_.insert(0);
  }

  std::vector<AntennaFix> good(LeftOut& left_out) const {
    std::vector<AntennaFix> fixes;
    for (std::size_t i = 0; i < time_.size(); ++i) {
      AntennaFix fix{i,       time_[i], {x_[i], y_[i]}, 0, std::isfinite(quality_[i]) ? std::llround(quality_[i]) : -1,
                     run_[i], 1};
      if (!fix.antenna_nav.allFinite() || !std::isfinite(fix.time_s)) {
        ++left_out.without_place;
        continue;
      }
      ++left_out.by_quality[fix.quality];
      if (fix.quality != -1 && !accepted_.contains(fix.quality)) {
        ++left_out.poor;
        continue;
      }
      fix.sigma_m = sigma_of(i, fix.quality);
      if (!fixes.empty()) {
        const auto& last = fixes.back();
        const bool same_run = fix.run == last.run;
        if (same_run && !(fix.time_s > last.time_s)) {
          ++left_out.back_in_time;
          continue;
        }
        fix.segment = last.segment + (same_run && fix.time_s - last.time_s <= o_.max_gap ? 0 : 1);
      }
      fixes.push_back(fix);
    }
    return fixes;
  }

 private:
  double sigma_of(std::size_t i, std::int64_t quality) const {
    if (o_.position_sigma) return *o_.position_sigma;
    const double sd = std::sqrt((sd_east_[i] * sd_east_[i] + sd_north_[i] * sd_north_[i]) / 2);
    return sd > 0 ? std::max(sd, 1e-4) : usual_sigma_m(quality);
  }
  const NavigateOptions& o_;
  std::vector<double> time_, x_, y_, quality_, sd_east_, sd_north_;
  std::vector<std::int64_t> run_;
  std::set<std::int64_t> accepted_;
};

// The log, a row per fix.
class NavigationLog {
 public:
  void add(const AntennaFix& fix, const geo::Attitude& attitude, const NavigatedPoint& point,
           const PositionVelocityFilter& filter) {
    const auto sigma = filter.position_sigma();
    const auto received = point.received.value_or(Eigen::Vector2d(no_number, no_number));
    const double values[] = {fix.time_s,
                             point.position.x(),
                             point.position.y(),
                             sigma.x(),
                             sigma.y(),
                             received.x(),
                             received.y(),
                             fix.antenna_nav.x(),
                             fix.antenna_nav.y(),
                             degrees(attitude.yaw_rad),
                             filter.velocity().norm(),
                             fix.sigma_m};
    for (std::size_t i = 0; i < std::size(values); ++i) columns_[i].push_back(values[i]);
    quality_.push_back(fix.quality);
    run_.push_back(fix.run);
    segment_.push_back(fix.segment);
    state_.emplace_back(filter.doubts() ? "doubted" : "used");
  }
  Table table(const Facts& facts, bool with_run) && {
    Table t;
    if (with_run) t.set("run", std::move(run_));
    for (std::size_t i = 0; i < std::size(names); ++i) t.set(names[i], std::move(columns_[i]));
    t.set("quality", std::move(quality_));
    t.set("segment", std::move(segment_));
    t.set("state", std::move(state_));
    t.facts = facts;
    return t;
  }
  std::int64_t doubted() const { return std::ranges::count(state_, "doubted"); }

 private:
  static constexpr const char* names[] = {"time_s",   "x_m",         "y_m",         "x_se_m",  "y_se_m",    "gnss_x_m",
                                          "gnss_y_m", "antenna_x_m", "antenna_y_m", "yaw_deg", "speed_m_s", "sigma_m"};
  std::vector<double> columns_[std::size(names)];
  std::vector<std::int64_t> quality_, run_, segment_;
  std::vector<std::string> state_;
};

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

std::string qualities_text(const LeftOut& left_out) {
  std::string text;
  for (const auto& [quality, count] : left_out.by_quality)
    text += (text.empty() ? "" : ", ") + (quality == -1 ? std::string("unknown") : fmt::format("{}", quality)) +
            fmt::format(": {}", count);
  return text;
}

void tell_left_out(const LeftOut& left_out, std::size_t kept, Report& report) {
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
  LeftOut left_out;
  const auto fixes = Fixes(track, o).good(left_out);
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
