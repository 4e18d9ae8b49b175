#include "steering/core/field_test.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/no_number.h"
#include "steering/core/drive.h"
#include "steering/core/headland_turn.h"

namespace bole::steering {
namespace {

// Grows a row per fix.
class Log {
 public:
  void add(std::int64_t drive, double speed_km_h, std::int64_t line, const char* state, const DriveSample& s) {
    drive_.push_back(drive);
    line_.push_back(line);
    stopped_.push_back(s.stopped ? 1 : 0);
    state_.emplace_back(state);
    const auto gnss = s.received.value_or(Eigen::Vector2d(no_number, no_number));
    const double values[] = {speed_km_h,
                             s.time_s,
                             s.navigated.x(),
                             s.navigated.y(),
                             s.truth.x(),
                             s.truth.y(),
                             gnss.x(),
                             gnss.y(),
                             s.yaw_rad * deg_per_rad,
                             s.offset_m,
                             s.command_rad * deg_per_rad,
                             s.wheel_rad * deg_per_rad};
    for (std::size_t i = 0; i < std::size(values); ++i) columns_[i].push_back(values[i]);
  }
  Table table() && {
    Table t;
    t.set("run", std::move(drive_));
    t.set("line", std::move(line_));
    t.set("state", std::move(state_));
    t.set("stopped", std::move(stopped_));
    for (std::size_t i = 0; i < std::size(names); ++i) t.set(names[i], std::move(columns_[i]));
    return t;
  }

 private:
  static constexpr const char* names[] = {"speed_km_h", "time_s",   "x_m",     "y_m",      "ref_x_m",     "ref_y_m",
                                          "gnss_x_m",   "gnss_y_m", "yaw_deg", "offset_m", "command_deg", "wheel_deg"};
  std::vector<std::int64_t> drive_, line_, stopped_;
  std::vector<std::string> state_;
  std::vector<double> columns_[std::size(names)];
};

class Protocol {
 public:
  Protocol(const FieldTestOptions& options, const Run& run, Log& log) : o_(options), run_(run), log_(log) {}

  void drive(std::int64_t number, double speed_km_h, std::uint64_t seed) {
    number_ = number;
    speed_km_h_ = speed_km_h;
    const GuidanceLine first{Eigen::Vector2d::Zero(), o_.direction_deg / deg_per_rad};
    Drive drive(o_, speed_km_h, first, seed);
    drive.place(first.a + o_.start_offset * first.left(), first.yaw_rad);
    for (int k = 0; k < o_.rows; ++k) {
      const bool forth = k % 2 == 0;
      GuidanceLine line = first;
      line.a += k * o_.row_width * first.left();
      if (!forth) {
        line.a += length_m() * first.along();
        line.yaw_rad += std::numbers::pi;
      }
      follow(drive, line, k + 1);
      if (k + 1 < o_.rows) turn(drive, forth ? o_.row_width : -o_.row_width);
    }
  }

  double length_m() const { return 2 * o_.run_in + o_.measured_length; }

 private:
  void follow(Drive& drive, const GuidanceLine& line, std::int64_t number) {
    drive.follow(line);
    const double expected_s = length_m() / (speed_km_h_ / 3.6);
    const auto max_fixes = static_cast<std::int64_t>((10 * expected_s + 600) * o_.rate);
    for (std::int64_t i = 0; line.along_m(drive.truth()) < length_m(); ++i) {
      if (i % 256 == 0) run_.check_cancel();
      if (i > max_fixes || std::abs(line.offset_m(drive.truth())) > 100)
        throw failure(fmt::format("the tractor left line {} at {} km/h: {:.1f} m beside it after {:.0f} s", number,
                                  speed_km_h_, line.offset_m(drive.truth()), static_cast<double>(i) / o_.rate),
                      "gains that keep it on the line",
                      "Lower gain_p or raise preview (stage steering.tune finds both)");
      log_.add(number_, speed_km_h_, number, "line", drive.steer());
    }
  }
  void turn(Drive& drive, double shift_m) {
    for (const auto& arc : headland_turn(shift_m, o_.turn_radius))
      for (double way = 0; way < arc.length_m; way += drive.speed_m_s() / o_.rate)
        log_.add(number_, speed_km_h_, 0, "turn", drive.turn(arc.curvature));
  }
  const FieldTestOptions& o_;
  const Run& run_;
  Log& log_;
  std::int64_t number_ = 0;
  double speed_km_h_ = 0;
};

}  // namespace

FieldTest simulate_field_test(const FieldTestOptions& options, const Run& run) {
  const auto speeds = speeds_km_h(options.speeds);
  Log log;
  Protocol protocol(options, run, log);
  const auto drives = speeds.size() * static_cast<std::size_t>(options.repeats);
  std::int64_t number = 0;
  for (const double speed : speeds)
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
      run.report(static_cast<double>(number) / static_cast<double>(drives), fmt::format("driving at {} km/h", speed));
      ++number;
      protocol.drive(number, speed,
                     mix64(static_cast<std::uint64_t>(options.seed)) + static_cast<std::uint64_t>(number));
    }
  FieldTest test;
  test.log = std::move(log).table();
  test.log.facts["row_width_m"] = fmt::format("{}", options.row_width);
  const double yaw = options.direction_deg / deg_per_rad, length = protocol.length_m();
  test.lines.set("a_x_m", std::vector<double>{0.0});
  test.lines.set("a_y_m", std::vector<double>{0.0});
  test.lines.set("b_x_m", std::vector<double>{length * std::cos(yaw)});
  test.lines.set("b_y_m", std::vector<double>{length * std::sin(yaw)});
  auto& report = test.report;
  report.counts["drives"] = number;
  report.counts["fixes"] = static_cast<std::int64_t>(test.log.rows());
  std::int64_t stopped = 0;
  for (const auto s : test.log.integers("stopped")) stopped += s;
  report.metrics["stopped"] = {static_cast<double>(stopped) / options.rate, Unit::second};
  report.message = fmt::format("{} drives over {} lines of {} m", number, options.rows, length);
  return test;
}

}  // namespace bole::steering
