#include "steering/core/tracking_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/option_text.h"
#include "base/statistics.h"
#include "steering/core/passes.h"
#include "steering/core/track/same_plane.h"
#include "steering/core/tracking_tables.h"

namespace bole::steering {

const OptionTable& option_table(const ErrorOptions*) {
  using S = ErrorOptions;
  using Number = Option<S, double>;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<double>>{"row_width",
                                       &S::row_width,
                                       Unit::metre,
                                       {0.01, 100},
                                       "log",
                                       Tier::basic,
                                       "Distance between neighbouring lines. log: as the log or the lines give it."},
      Number{"run_in",
             &S::run_in,
             Unit::metre,
             {0, 1000},
             Tier::basic,
             "Distance at the start of each pass that is not measured."},
      Number{"run_out",
             &S::run_out,
             Unit::metre,
             {0, 1000},
             Tier::advanced,
             "Distance at the end of each pass that is not measured, because the turn begins there."},
      Number{"min_length", &S::min_length, Unit::metre, {1, 1e5}, Tier::basic, "Shorter passes are ignored."},
      Number{"max_angle",
             &S::max_angle_deg,
             Unit::degree,
             {0.5, 45},
             Tier::advanced,
             "Largest angle between the direction of motion and the line on a pass."},
      Number{"speed_step_km_h",
             &S::speed_step_km_h,
             Unit::none,
             {0.1, 40},
             Tier::advanced,
             "Step, km/h, by which measured speeds are grouped when the log does not give them."},
      Number{"max_gap", &S::max_gap, Unit::second, {0.1, 3600}, Tier::advanced, "A longer step in time ends a pass."},
  });
  return table;
}

namespace {

struct RecordedDrive {
  std::int64_t run = 1;
  double speed_km_h = no_number;
  Track track;
};

// `reference` at the times of the log; NaN outside of it and in gaps of more than a second.
std::vector<Eigen::Vector2d> at_times(const Table& reference, const std::vector<double>& times) {
  const auto t = reference.numbers("time_s"), x = reference.numbers("x_m"), y = reference.numbers("y_m");
  if (!std::is_sorted(t.begin(), t.end())) throw bad_input("the times of the reference fall", "rising time_s");
  std::vector<Eigen::Vector2d> found;
  for (const double time : times) {
    const auto j = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
    const bool exact = j > 0 && t[j - 1] == time;
    if (!exact && (j == 0 || j == t.size() || t[j] - t[j - 1] > 1)) {
      found.emplace_back(no_number, no_number);
      continue;
    }
    const double s = exact ? 0 : (time - t[j - 1]) / (t[j] - t[j - 1]);
    const std::size_t k = exact ? j - 1 : j;
    found.emplace_back(std::lerp(x[j - 1], x[k], s), std::lerp(y[j - 1], y[k], s));
  }
  return found;
}

std::vector<RecordedDrive> drives_of(const Table& log, const Table* reference) {
  const auto time = log.numbers("time_s"), x = log.numbers("x_m"), y = log.numbers("y_m");
  std::vector<Eigen::Vector2d> truth;
  if (log.has("ref_x_m") && log.has("ref_y_m")) {
    const auto rx = log.numbers("ref_x_m"), ry = log.numbers("ref_y_m");
    for (std::size_t i = 0; i < rx.size(); ++i) truth.emplace_back(rx[i], ry[i]);
  } else if (reference != nullptr) {
    truth = at_times(*reference, time);
  }
  const auto runs = log.has("run") ? log.integers("run") : std::vector<std::int64_t>(log.rows(), 1);
  const auto speeds = log.has("speed_km_h") ? log.numbers("speed_km_h") : std::vector<double>(log.rows(), no_number);
  std::vector<RecordedDrive> drives;
  for (std::size_t i = 0; i < log.rows(); ++i) {
    const Eigen::Vector2d navigated(x[i], y[i]), real = truth.empty() ? navigated : truth[i];
    if (!navigated.allFinite() || !real.allFinite() || !std::isfinite(time[i])) continue;
    if (drives.empty() || drives.back().run != runs[i]) drives.push_back({runs[i], speeds[i], {}});
    auto& track = drives.back().track;
    if (!track.time_s.empty() && !(time[i] > track.time_s.back()))
      throw bad_input(fmt::format("time_s does not rise at row {} of the log", i + 1), "rising times within a run");
    track.time_s.push_back(time[i]);
    track.truth.push_back(real);
    if (!truth.empty()) track.navigated.push_back(navigated);
  }
  return drives;
}

GuidanceLine line_of(const Table* lines, const RecordedDrive& drive, const PassLimits& limits) {
  if (lines != nullptr && lines->rows() > 0) {
    const Eigen::Vector2d a(lines->numbers("a_x_m")[0], lines->numbers("a_y_m")[0]),
        b(lines->numbers("b_x_m")[0], lines->numbers("b_y_m")[0]), d = b - a;
    if (!(d.norm() > 0.1)) throw bad_input("A and B are the same place", "two points of the line");
    GuidanceLine line{a, std::atan2(d.y(), d.x())};
    if (lines->has("line")) line.a -= lines->numbers("line")[0] * limits.row_width_m * line.left();
    return line;
  }
  const auto line = longest_straight(drive.track, limits);
  if (!line)
    throw bad_input(fmt::format("run {} has no straight stretch of {} m", drive.run, limits.min_length_m),
                    "a line to measure against", "Give A and B (lines), or lower min_length");
  return *line;
}

double median_speed_km_h(const Track& track, const Pass& pass) {
  std::vector<double> v;
  for (std::size_t i = pass.first + 1; i <= pass.last; ++i)
    v.push_back(3.6 * (track.truth[i] - track.truth[i - 1]).norm() / (track.time_s[i] - track.time_s[i - 1]));
  return median(std::move(v));
}

// Offsets of an earlier pass by place along the line, for the distance to it.
class Neighbour {
 public:
  Neighbour(const Track& track, const Pass& pass, const GuidanceLine& line) {
    for (std::size_t i = pass.first; i <= pass.last; ++i)
      offset_at_[line.along_m(track.truth[i])] = line.offset_m(track.truth[i]);
  }
  double offset_m(double along_m) const {
    const auto after = offset_at_.lower_bound(along_m);
    if (after == offset_at_.end() || (after == offset_at_.begin() && after->first > along_m)) return no_number;
    if (after == offset_at_.begin()) return after->second;
    const auto before = std::prev(after);
    return std::lerp(before->second, after->second, (along_m - before->first) / (after->first - before->first));
  }

 private:
  std::map<double, double> offset_at_;
};

void measure_drive(const RecordedDrive& drive, const GuidanceLine& line, const PassLimits& limits,
                   double speed_step_km_h, std::vector<MeasuredPass>& found) {
  const auto passes = find_passes(drive.track, line, limits);
  std::map<std::int64_t, Neighbour> driven;  // the last pass on each row
  for (const auto& pass : passes) {
    MeasuredPass m;
    m.run = drive.run;
    m.row = pass.row;
    m.direction = pass.direction;
    m.speed_km_h = drive.speed_km_h;
    if (!std::isfinite(m.speed_km_h))
      m.speed_km_h = speed_step_km_h * std::round(median_speed_km_h(drive.track, pass) / speed_step_km_h);
    const double middle = static_cast<double>(pass.row) * limits.row_width_m;
    const Neighbour* neighbour = nullptr;
    for (const std::int64_t row : {pass.row - 1, pass.row + 1})
      if (const auto it = driven.find(row); it != driven.end() && limits.row_width_m > 0) neighbour = &it->second;
    for (std::size_t i = pass.first; i <= pass.last; ++i) {
      const auto& truth = drive.track.truth[i];
      const double along = line.along_m(truth), offset = line.offset_m(truth);
      ErrorSample s{drive.track.time_s[i], along, pass.direction * (offset - middle), no_number, no_number};
      if (!drive.track.navigated.empty())
        s.controller_m = pass.direction * (line.offset_m(drive.track.navigated[i]) - middle);
      if (neighbour != nullptr) s.adjacent_m = std::abs(offset - neighbour->offset_m(along)) - limits.row_width_m;
      m.samples.push_back(s);
    }
    driven.insert_or_assign(pass.row, Neighbour(drive.track, pass, line));
    found.push_back(std::move(m));
  }
}

// Of the log, else of the lines; 0 where neither says it.
double row_width_of(const Table& log, const Table* lines) {
  for (const Table* table : {&log, lines})
    if (table != nullptr)
      if (const auto it = table->facts.find("row_width_m"); it != table->facts.end())
        return number_from_text(it->second).value_or(0);
  return 0;
}

// Without a row width all passes count as driven on one line.
void tell_unknown_rows(const std::vector<MeasuredPass>& passes, double row_width_m, Report& report) {
  constexpr double same_line_m = 1;
  if (row_width_m > 0) return;
  double farthest = 0;
  for (const auto& p : passes) {
    double mean = 0;
    for (const auto& s : p.samples) mean += s.error_m / static_cast<double>(p.samples.size());
    farthest = std::max(farthest, std::abs(mean));
  }
  if (farthest > same_line_m)
    report.find(
        Severity::look, "row_width_unknown",
        fmt::format("passes lie up to {:.1f} m beside the line, and no row width says which line they followed: "
                    "their errors count from that one line. Set row_width",
                    farthest));
}

}  // namespace

TrackingErrors tracking_errors(const Table& log, const Table* lines, const Table* reference,
                               const ErrorOptions& options, const Run& run) {
  PassLimits limits{options.row_width.value_or(0), options.run_in, options.run_out, options.min_length,
                    radians(options.max_angle_deg)};
  limits.max_gap_s = options.max_gap;
  if (!options.row_width) limits.row_width_m = row_width_of(log, lines);
  if (lines != nullptr) check_same_plane(log, *lines, "log and lines");
  const auto drives = drives_of(log, reference);
  std::vector<MeasuredPass> passes;
  for (std::size_t i = 0; i < drives.size(); ++i) {
    run.check_cancel();
    run.report(static_cast<double>(i) / static_cast<double>(drives.size()), "measuring passes");
    measure_drive(drives[i], line_of(lines, drives[i], limits), limits, options.speed_step_km_h, passes);
  }
  if (passes.empty())
    throw bad_input(fmt::format("none of {} fixes is on a pass of {} m along the line", log.rows(), options.min_length),
                    "a drive along the line from A to B", "Check A and B, or lower run_in and min_length");
  TrackingErrors result;
  result.passes = pass_table(passes);
  result.summary = summary_table(passes);
  result.errors = error_table(passes);
  result.report.counts["passes"] = static_cast<std::int64_t>(passes.size());
  if (std::ranges::all_of(drives, [](const RecordedDrive& d) { return d.track.navigated.empty(); }))
    result.report.warn(
        "no reference: errors are measured with the receiver itself, so its own error is unknown (connect 'reference', "
        "or a log with "
        "ref_x_m and ref_y_m)");
  tell_unknown_rows(passes, limits.row_width_m, result.report);
  const auto all = overall(passes);
  result.report.metrics["line_sd"] = {all.line.sd, Unit::metre};
  result.report.metrics["line_max"] = {all.line.max, Unit::metre};
  if (all.adjacent.count > 0) {
    result.report.metrics["adjacent_sd"] = {all.adjacent.sd, Unit::metre};
    result.report.metrics["adjacent_max"] = {all.adjacent.max, Unit::metre};
  } else {
    result.report.warn("no neighbouring passes: no adjacent-row error (set row_width, or drive the next line)");
  }
  result.report.message = fmt::format("{} passes, standard deviation {:.1f} cm", passes.size(), 100 * all.line.sd);
  return result;
}

}  // namespace bole::steering
