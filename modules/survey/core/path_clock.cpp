#include "survey/core/path_clock.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace bole::survey {
namespace {

constexpr double week_s = 604800, day_s = 86400, gps_epoch_unix_s = 315964800, adjusted_s = 1e9;

struct Clock {
  std::string_view name;
  double (*to_gps)(double time_s);
};

// Absolute clocks.
constexpr std::array clocks{Clock{"GPS time", [](double t) { return t; }},
                            Clock{"GPS time less 1e9 s", [](double t) { return t + adjusted_s; }},
                            Clock{"Unix time (UTC)", [](double t) { return t - gps_epoch_unix_s + leap_seconds(t); }}};

bool may_be_week(const TimeSpan& s) { return s.begin >= 0 && s.end < week_s + day_s; }

bool overlap(const TimeSpan& points, const TimeSpan& path, double offset) {
  return path.begin + offset < points.end && path.end + offset > points.begin;
}

}  // namespace

int leap_seconds(double unix_s) {
  // Days when a leap second took effect, as Unix times since 1981 (IERS Bulletin C).
  constexpr std::array<double, 18> days{362793600, 394329600,  425865600,  489024000,  567993600,  631152000,
                                        662688000, 709948800,  741484800,  773020800,  820454400,  867715200,
                                        915148800, 1136073600, 1230768000, 1341100800, 1435708800, 1483228800};
  return static_cast<int>(std::ranges::upper_bound(days, unix_s) - days.begin());
}

std::vector<ClockOffset> possible_offsets(const TimeSpan& points, const TimeSpan& path) {
  std::vector<ClockOffset> out;
  const auto add = [&](double offset, std::string meaning) {
    if (!overlap(points, path, offset)) return;
    constexpr double same_s = 1e-3;
    if (std::ranges::none_of(out, [&](const ClockOffset& o) { return std::abs(o.offset_s - offset) < same_s; }))
      out.push_back({offset, std::move(meaning)});
  };
  add(0, "points and trajectory have the same clock");
  // Beyond these dates a number is no time of that clock (1980 to 2100).
  constexpr double latest_gps = 3.8e9, earliest_gps = 1e7;
  const auto absolute = [&](const Clock& clock, double t) {
    const double gps = clock.to_gps(t);
    return gps > earliest_gps && gps < latest_gps;
  };
  for (const auto& of_points : clocks)
    for (const auto& of_path : clocks) {
      if (&of_points == &of_path || !absolute(of_points, points.begin) || !absolute(of_path, path.begin)) continue;
      const double offset = of_path.to_gps(path.begin) - path.begin - (of_points.to_gps(points.begin) - points.begin);
      add(offset, fmt::format("the points have {}, the trajectory {}", of_points.name, of_path.name));
    }
  const auto weeks = [&](const TimeSpan& in_week, const TimeSpan& other, bool points_in_week) {
    if (!may_be_week(in_week)) return;
    for (const auto& clock : clocks) {
      if (!absolute(clock, other.begin)) continue;
      const double to_gps = clock.to_gps(other.begin) - other.begin;
      const double week = std::floor((other.begin + to_gps - in_week.begin) / week_s + 0.5);
      const double offset = week * week_s - to_gps;  // from seconds of the week to the other clock
      add(points_in_week ? -offset : offset,
          points_in_week ? fmt::format("the points have seconds of the GPS week, the trajectory {}", clock.name)
                         : fmt::format("the points have {}, the trajectory seconds of the GPS week", clock.name));
    }
  };
  weeks(path, points, false);
  weeks(points, path, true);
  return out;
}

std::string described(const TimeSpan& span) { return fmt::format("from {:.3f} to {:.3f} s", span.begin, span.end); }

}  // namespace bole::survey
