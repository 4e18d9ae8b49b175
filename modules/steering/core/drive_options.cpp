#include "steering/core/drive_options.h"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace bole::steering {
namespace {

template <class S>
using Entries = std::vector<OptionEntry<S>>;
template <class S>
using Number = Option<S, double>;

template <class S>
Entries<S> tractor_entries() {
  return {
      Number<S>{"wheelbase", &S::wheelbase, Unit::metre, {0.3, 10}, Tier::advanced, "Distance of front and rear axle."},
      Number<S>{"steering_max_deg",
                &S::steering_max_deg,
                Unit::degree,
                {5, 80},
                Tier::advanced,
                "Largest angle of the front wheels."},
      Number<S>{"steering_rate_deg_s",
                &S::steering_rate_deg_s,
                Unit::none,
                {1, 500},
                Tier::advanced,
                "Largest speed at which the front wheels turn, deg/s."},
      Number<S>{"steering_lag",
                &S::steering_lag,
                Unit::second,
                {0, 3},
                Tier::advanced,
                "Time constant of the hydraulic steering."},
      Number<S>{"steering_delay",
                &S::steering_delay,
                Unit::second,
                {0, 3},
                Tier::advanced,
                "Dead time between command and movement of the wheels."},
      Number<S>{
          "steering_deadband_deg",
          &S::steering_deadband_deg,
          Unit::degree,
          {0, 5},
          Tier::advanced,
          "The valve does not open while the wheels are nearer than this to the angle asked for (Qiu et al. 2001)."},
      Number<S>{"steering_offset_deg",
                &S::steering_offset_deg,
                Unit::degree,
                {-10, 10},
                Tier::advanced,
                "Error of the wheel-angle sensor: the integral part has to find it."},
      Number<S>{"wheel_disturbance_deg",
                &S::wheel_disturbance_deg,
                Unit::degree,
                {0, 10},
                Tier::advanced,
                "Standard deviation of what the ground does to the wheel angle, over about 1.5 m of way."},
      Number<S>{"roughness_deg",
                &S::roughness_deg,
                Unit::degree,
                {0, 20},
                Tier::advanced,
                "Standard deviation of roll and pitch from uneven ground."},
      Number<S>{"side_slope_deg",
                &S::side_slope_deg,
                Unit::degree,
                {-40, 40},
                Tier::basic,
                "Slope of the field; positive falls to the right of the line from A to B."},
      Number<S>{"slip_per_slope",
                &S::slip_per_slope,
                Unit::none,
                {0, 1},
                Tier::advanced,
                "Crab angle downhill per angle of slope across the way."},
      Number<S>{"turn_radius",
                &S::turn_radius,
                Unit::metre,
                {1, 50},
                Tier::advanced,
                "Radius of the turns that the driver makes on the headland."},
  };
}

template <class S>
Entries<S> receiver_entries() {
  return {
      Number<S>{"rate", &S::rate, Unit::hertz, {1, 100}, Tier::advanced, "Fixes and commands per second."},
      Number<S>{"white_noise",
                &S::white_noise,
                Unit::metre,
                {0, 10},
                Tier::basic,
                "Standard deviation per axis of what changes from fix to fix."},
      Number<S>{"drift",
                &S::drift,
                Unit::metre,
                {0, 10},
                Tier::basic,
                "Standard deviation per axis of the slow error of precise point positioning."},
      Number<S>{"drift_time",
                &S::drift_time,
                Unit::second,
                {1, 1e5},
                Tier::advanced,
                "Correlation time of the slow error (first-order Gauss-Markov process)."},
      Number<S>{"jumps_per_hour",
                &S::jumps_per_hour,
                Unit::none,
                {0, 3600},
                Tier::basic,
                "Sudden steps of the position, as after a change of satellites."},
      Number<S>{
          "jump_size", &S::jump_size, Unit::metre, {0, 100}, Tier::basic, "Standard deviation per axis of a step."},
      Number<S>{
          "jump_time", &S::jump_time, Unit::second, {0.1, 1e5}, Tier::advanced, "Time constant of a step's decay."},
      Number<S>{"outages_per_hour", &S::outages_per_hour, Unit::none, {0, 3600}, Tier::basic, "Losses of all fixes."},
      Number<S>{"outage_length", &S::outage_length, Unit::second, {0.1, 600}, Tier::basic, "Mean length of a loss."},
      Number<S>{"heading_noise_deg",
                &S::heading_noise_deg,
                Unit::degree,
                {0, 20},
                Tier::advanced,
                "Standard deviation of the heading of two antennas."},
      Number<S>{"tilt_noise_deg",
                &S::tilt_noise_deg,
                Unit::degree,
                {0, 20},
                Tier::advanced,
                "Standard deviation of the measured roll and pitch."},
      Number<S>{"antenna_forward",
                &S::antenna_forward,
                Unit::metre,
                {-10, 10},
                Tier::advanced,
                "Antenna ahead of the middle of the rear axle."},
      Number<S>{"antenna_left", &S::antenna_left, Unit::metre, {-10, 10}, Tier::advanced, "Antenna left of it."},
      Number<S>{"antenna_up", &S::antenna_up, Unit::metre, {-10, 20}, Tier::advanced, "Antenna above the ground."},
  };
}

template <class S>
Entries<S> filter_entries() {
  return {
      Number<S>{"position_sigma",
                &S::position_sigma,
                Unit::metre,
                {1e-4, 100},
                Tier::advanced,
                "Standard deviation per axis that the filter expects of a fix."},
      Number<S>{"acceleration_sigma",
                &S::acceleration_sigma,
                Unit::none,
                {1e-4, 100},
                Tier::advanced,
                "Standard deviation of the acceleration that the filter allows for, m/s2."},
      Number<S>{"gate",
                &S::gate,
                Unit::none,
                {1, 1000},
                Tier::advanced,
                "A fix further from the prediction than this many standard deviations is doubted."},
      Number<S>{"patience",
                &S::patience,
                Unit::second,
                {0, 600},
                Tier::advanced,
                "So long doubted fixes are left out; then they are believed."},
      Number<S>{"outage_max",
                &S::outage_max,
                Unit::second,
                {0.1, 600},
                Tier::basic,
                "After so long without a fix the tractor stops until one comes."},
  };
}

template <class S>
Entries<S> control_entries() {
  return {
      Number<S>{"preview",
                &S::preview,
                Unit::metre,
                {-1, 50},
                Tier::basic,
                "Preview distance; negative: from the paper's table at the speed."},
      Number<S>{"gain_p",
                &S::gain_p,
                Unit::none,
                {-1, 1e4},
                Tier::basic,
                "Wheel angle per preview error, deg/m; negative: from the table."},
      Number<S>{"gain_i",
                &S::gain_i,
                Unit::none,
                {-1, 1e4},
                Tier::basic,
                "Wheel angle per integral of the error, deg/(m s); negative: from the table."},
      Number<S>{"gain_d",
                &S::gain_d,
                Unit::none,
                {-1, 1e4},
                Tier::basic,
                "Wheel angle per speed across the line (V tan alpha), deg s/m; negative: from the table."},
      Number<S>{"approach_angle_deg",
                &S::approach_angle_deg,
                Unit::degree,
                {1, 80},
                Tier::advanced,
                "Steepest angle at which a far line is approached."},
      Number<S>{"command_max_deg",
                &S::command_max_deg,
                Unit::degree,
                {1, 80},
                Tier::advanced,
                "Largest wheel angle that is asked for on a line: more than the wheels can follow swings."},
      Number<S>{"integral_zone",
                &S::integral_zone,
                Unit::metre,
                {0, 10},
                Tier::advanced,
                "Errors beyond this are not summed up."},
      Number<S>{"integral_limit_deg",
                &S::integral_limit_deg,
                Unit::degree,
                {0, 40},
                Tier::advanced,
                "Most that the integral part may ask for."},
  };
}

template <class S>
Entries<S> drive_entries() {
  Entries<S> all;
  for (const auto& part : {control_entries<S>(), receiver_entries<S>(), filter_entries<S>(), tractor_entries<S>()})
    all.insert(all.end(), part.begin(), part.end());
  all.push_back(Option<S, int>{"seed",
                               &S::seed,
                               Unit::none,
                               {0, 1'000'000'000},
                               Tier::basic,
                               "Number that fixes all chance in the simulation."});
  return all;
}

template <class S>
Entries<S> joined(Entries<S> first, const Entries<S>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace

const OptionTable& option_table(const FieldTestOptions*) {
  using S = FieldTestOptions;
  static const OptionTable table = make_option_table<S>(
      joined<S>(
          {
              Option<S, std::string>{
                  "speeds", &S::speeds, TextKind::plain, {}, Tier::basic, "Speeds of the drives in km/h."},
              Option<S, int>{"repeats", &S::repeats, Unit::none, {1, 1000}, Tier::basic, "Drives per speed."},
              Option<S, int>{"rows", &S::rows, Unit::none, {1, 100}, Tier::basic, "Neighbouring lines per drive."},
              Number<S>{
                  "row_width", &S::row_width, Unit::metre, {0.1, 100}, Tier::basic, "Distance of neighbouring lines."},
              Number<S>{"run_in",
                        &S::run_in,
                        Unit::metre,
                        {0, 1000},
                        Tier::basic,
                        "Way on each line to find it, which is not measured."},
              Number<S>{"measured_length",
                        &S::measured_length,
                        Unit::metre,
                        {1, 1e5},
                        Tier::basic,
                        "Way on each line that is measured on both passes; the paper asks for 80 m."},
              Number<S>{"direction_deg",
                        &S::direction_deg,
                        Unit::degree,
                        {-360, 360},
                        Tier::advanced,
                        "Direction from A to B, from east to north."},
              Number<S>{"start_offset",
                        &S::start_offset,
                        Unit::metre,
                        {-50, 50},
                        Tier::advanced,
                        "Distance left of the line at which the drive begins."},
          },
          drive_entries<S>()),
      [](const S& o) { speeds_km_h(o.speeds); });
  return table;
}

const OptionTable& option_table(const TuneOptions*) {
  using S = TuneOptions;
  static const OptionTable table = make_option_table<S>(joined<S>(
      {
          Number<S>{"speed_km_h", &S::speed_km_h, Unit::none, {0.1, 40}, Tier::basic, "Speed to tune for."},
          Number<S>{"first_p",
                    &S::first_p,
                    Unit::none,
                    {1, 1e4},
                    Tier::basic,
                    "The middling gain P, deg/m, that the preview distance is tuned with."},
          Number<S>{"first_preview",
                    &S::first_preview,
                    Unit::metre,
                    {2, 50},
                    Tier::advanced,
                    "The large preview distance that tuning starts from."},
          Number<S>{"start_offset",
                    &S::start_offset,
                    Unit::metre,
                    {0.001, 10},
                    Tier::advanced,
                    "Distance from the line at which each try begins."},
          Number<S>{"oscillation",
                    &S::oscillation,
                    Unit::metre,
                    {1e-5, 1},
                    Tier::advanced,
                    "A swing so wide that does not die away counts as slight oscillation."},
      },
      drive_entries<S>()));
  return table;
}

std::vector<double> speeds_km_h(const std::string& list) {
  std::vector<double> speeds;
  std::string words = list;
  std::replace(words.begin(), words.end(), ',', ' ');
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    double speed = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), speed);
    if (error != std::errc() || end != word.data() + word.size() || !(speed >= 0.1 && speed <= 40))
      throw bad_input("speeds is '" + list + "': '" + word + "' is no speed", "numbers from 0.1 to 40 km/h",
                      "Write for instance \"3 5 7\"");
    speeds.push_back(speed);
  }
  if (speeds.empty()) throw bad_input("speeds is empty", "at least one speed in km/h", "Write for instance \"3 5 7\"");
  return speeds;
}

}  // namespace bole::steering
