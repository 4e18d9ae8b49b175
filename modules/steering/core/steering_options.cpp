#include "steering/core/steering_options.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "base/error.h"

namespace bole::steering {
namespace {

template <class S>
Option<S, double> real(std::string_view name, double S::*member, Unit unit, double lo, double hi, std::string_view help,
                       Tier tier = Tier::advanced) {
  return {name, member, unit, {lo, hi}, tier, help};
}

template <class S>
std::vector<OptionEntry<S>> filter_entries() {
  return {
      real<S>("position_sigma", &S::position_sigma, Unit::metre, 0.001, 100,
              "Scatter of a position that the filter expects (R)."),
      real<S>("acceleration_sigma", &S::acceleration_sigma, Unit::none, 0.001, 100,
              "Scatter of the acceleration (m/s^2) that the filter expects (Q)."),
      real<S>(
          "gate", &S::gate, Unit::none, 0, 1000,
          "A position further from the predicted one than so many standard deviations is a jump and is not used; 0: "
          "every position is used, as in the paper."),
      real<S>("patience", &S::patience, Unit::second, 0, 600,
              "After so long without a position that is used the filter starts anew."),
  };
}

}  // namespace

Gains table_gains(double v) {
  static constexpr std::array<double, 3> speed{3, 5, 7};
  static constexpr std::array<Gains, 3> gains{{{1.4, 170, 13, 39}, {2.4, 150, 10, 30}, {3.2, 130, 8, 22}}};
  const double clamped = std::clamp(v, speed.front(), speed.back());
  const std::size_t i = clamped < speed[1] ? 0 : 1;
  const double s = (clamped - speed[i]) / (speed[i + 1] - speed[i]);
  const auto mixed = [&](double Gains::*m) { return (1 - s) * gains[i].*m + s * gains[i + 1].*m; };
  return {mixed(&Gains::preview_m), mixed(&Gains::p), mixed(&Gains::i), mixed(&Gains::d)};
}

std::vector<double> speeds_of(const std::string& text) {
  std::string spaced = text;
  std::ranges::replace(spaced, ',', ' ');
  std::istringstream in(spaced);
  std::vector<double> speeds;
  for (std::string word; in >> word;) {
    char* end = nullptr;
    const double v = std::strtod(word.c_str(), &end);
    if (*end != 0 || !(v >= 0.5 && v <= 30)) throw bad_input("speeds has '" + word + "'", "speeds from 0.5 to 30 km/h");
    speeds.push_back(v);
  }
  if (speeds.empty() || speeds.size() > 20) throw bad_input("speeds is '" + text + "'", "1 to 20 speeds in km/h");
  return speeds;
}

const OptionTable& option_table(const FilterOptions*) {
  static const OptionTable table = make_option_table<FilterOptions>(filter_entries<FilterOptions>());
  return table;
}

const OptionTable& option_table(const DriveOptions*) {
  using S = DriveOptions;
  static const OptionTable table = [] {
    std::vector<OptionEntry<S>> e{
        Option<S, std::string>{"speeds", &S::speeds, TextKind::plain, {}, Tier::basic, "Speeds to test, km/h."},
        Option<S, int>{"seed",
                       &S::seed,
                       Unit::none,
                       {0, 2'000'000'000},
                       Tier::basic,
                       "Number that everything random follows from."},
        Option<S, int>{"tests",
                       &S::tests,
                       Unit::none,
                       {1, 1000},
                       Tier::basic,
                       "Tests per speed; each is a line, a turn and the neighbouring line."},
        real<S>("length", &S::length, Unit::metre, 20, 5000, "Length of a line.", Tier::basic),
        real<S>("settle", &S::settle, Unit::metre, 0, 1000, "Way at the start of a line that does not count.",
                Tier::basic),
        real<S>("swath", &S::swath, Unit::metre, 0.3, 50, "Distance of neighbouring lines.", Tier::basic),
        real<S>("start_offset", &S::start_offset, Unit::metre, -5, 5, "Distance from the line when steering begins."),
        real<S>("preview", &S::preview, Unit::metre, 0, 30, "Preview distance; 0: from the table of the paper.",
                Tier::basic),
        real<S>("gain_p", &S::gain_p, Unit::none, 0, 2000, "P, degrees of wheel per metre; 0: from the table.",
                Tier::basic),
        real<S>("gain_i", &S::gain_i, Unit::none, 0, 500, "I, degrees per metre and second; 0: from the table.",
                Tier::basic),
        real<S>("gain_d", &S::gain_d, Unit::none, 0, 500, "D, degrees per metre per second across; 0: from the table.",
                Tier::basic),
        real<S>("wheelbase", &S::wheelbase, Unit::metre, 0.5, 10, "Wheelbase of the tractor."),
        real<S>("steering_lag", &S::steering_lag, Unit::second, 0.01, 3, "Time constant of the steering."),
        real<S>("steering_delay", &S::steering_delay, Unit::second, 0, 2, "Dead time from the position to the valve."),
        real<S>("steering_rate", &S::steering_rate, Unit::degree, 1, 200,
                "Fastest turn of the wheels, degrees per second."),
        real<S>("steering_limit", &S::steering_limit, Unit::degree, 5, 60, "Largest wheel angle."),
        real<S>("line_limit", &S::line_limit, Unit::degree, 1, 60,
                "Largest wheel angle asked for on a line: with more, the limited rate of the steering makes it swing."),
        real<S>("dead_band", &S::dead_band, Unit::degree, 0, 5,
                "Errors of the wheel angle so small are not corrected."),
        real<S>("cross_slope", &S::cross_slope, Unit::degree, -30, 30,
                "Slope of the ground across the lines, rising to the left of the first.", Tier::basic),
        real<S>("slip", &S::slip, Unit::none, 0, 2,
                "Share of the forward speed that the tractor slides downhill per unit of sin(slope)."),
        real<S>("roughness", &S::roughness, Unit::none, 0, 20,
                "Uneven ground: scatter (degrees) of roll and pitch, degrees per second of yaw, cm/s of sliding."),
        real<S>("noise", &S::noise, Unit::metre, 0, 5, "White noise of the receiver's positions, each axis."),
        real<S>("drift", &S::drift, Unit::metre, 0, 5, "Slow error of precise point positioning, each axis."),
        real<S>("drift_time", &S::drift_time, Unit::second, 1, 1e5, "Correlation time of the slow error."),
        real<S>("wander", &S::wander, Unit::metre, 0, 5, "Faster coloured error (multipath), each axis."),
        real<S>("wander_time", &S::wander_time, Unit::second, 0.1, 1e4, "Correlation time of the faster error."),
        real<S>("jumps_per_hour", &S::jumps_per_hour, Unit::none, 0, 1000, "Jumps of the receiver."),
        real<S>("jump_size", &S::jump_size, Unit::metre, 0, 20, "Scatter of a jump, each axis."),
        real<S>("jump_time", &S::jump_time, Unit::second, 0.1, 1000, "How long a jump lasts."),
        real<S>("outages_per_hour", &S::outages_per_hour, Unit::none, 0, 1000, "Outages of the receiver."),
        real<S>("outage_time", &S::outage_time, Unit::second, 0.1, 1000, "How long an outage lasts."),
        real<S>("outage_stop", &S::outage_stop, Unit::second, 0.5, 1000,
                "The tractor stops when it had no position for so long, and goes on with the next."),
        real<S>("heading_noise", &S::heading_noise, Unit::degree, 0, 10, "Scatter of the heading of the two antennas."),
        real<S>("attitude_noise", &S::attitude_noise, Unit::degree, 0, 10, "Scatter of roll and pitch as measured."),
        real<S>("antenna_ahead", &S::antenna_ahead, Unit::metre, -10, 10,
                "Lever arm: the antenna ahead of the rear axle."),
        real<S>("antenna_left", &S::antenna_left, Unit::metre, -10, 10, "Lever arm: to the left."),
        real<S>("antenna_up", &S::antenna_up, Unit::metre, 0, 10, "Lever arm: above the ground."),
        Option<S, bool>{"lever_arm", &S::lever_arm, Tier::advanced,
                        "Carry the antenna's position to the control point with roll and pitch (eq. 5); off: with the "
                        "heading alone."},
        real<S>("reference_noise", &S::reference_noise, Unit::metre, 0, 1,
                "White noise of the RTK receiver that judges."),
    };
    for (auto& entry : filter_entries<S>()) e.push_back(std::move(entry));
    return make_option_table<S>(std::move(e), [](const S& s) {
      speeds_of(s.speeds);
      if (s.settle > s.length - 5)
        throw bad_input("settle is " + number_text(s.settle) + " m of a line of " + number_text(s.length) + " m",
                        "at least 5 m left to count");
    });
  }();
  return table;
}

const OptionTable& option_table(const LogOptions*) {
  using S = LogOptions;
  static const OptionTable table = make_option_table<S>({
      real<S>("swath", &S::swath, Unit::metre, 0, 100,
              "Distance that neighbouring lines should have; 0: the median of those driven.", Tier::basic),
      real<S>("settle", &S::settle, Unit::metre, 0, 1000, "Way at both ends of a line that does not count.",
              Tier::basic),
      real<S>("line_min", &S::line_min, Unit::metre, 1, 10000, "Shorter straight stretches are no lines.", Tier::basic),
      real<S>("turn", &S::turn, Unit::degree, 1, 90, "A line ends where the course leaves its direction by more."),
      real<S>("bend", &S::bend, Unit::metre, 0.01, 100, "Stretches that scatter more about their line are no lines."),
  });
  return table;
}

}  // namespace bole::steering
