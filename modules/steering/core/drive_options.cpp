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
using OpenNumber = Option<S, std::optional<double>>;

template <class S>
Entries<S> tractor_entries() {
  return {
      Number<S>{
          "wheelbase", &S::wheelbase, Unit::metre, {0.3, 10}, Tier::advanced, "Distance between front and rear axle."},
      Number<S>{"max_steering_angle",
                &S::max_steering_angle_deg,
                Unit::degree,
                {5, 80},
                Tier::advanced,
                "Largest angle of the front wheels."},
      Number<S>{"steering_rate_deg_s",
                &S::steering_rate_deg_s,
                Unit::none,
                {1, 500},
                Tier::advanced,
                "Largest turning rate of the front wheels, deg/s."},
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
                "Dead time between the command and the movement of the wheels."},
      Number<S>{"steering_deadband",
                &S::steering_deadband_deg,
                Unit::degree,
                {0, 5},
                Tier::advanced,
                "Deviation from the commanded angle below which the valve stays closed (Qiu et al. 2001)."},
      Number<S>{"steering_offset",
                &S::steering_offset_deg,
                Unit::degree,
                {-10, 10},
                Tier::advanced,
                "Constant error of the wheel-angle sensor. The integral part must compensate for it."},
      Number<S>{"wheel_disturbance",
                &S::wheel_disturbance_deg,
                Unit::degree,
                {0, 10},
                Tier::advanced,
                "Standard deviation of the wheel angle caused by the ground, correlated over about 1.5 m."},
      Number<S>{"roughness",
                &S::roughness_deg,
                Unit::degree,
                {0, 20},
                Tier::advanced,
                "Standard deviation of roll and pitch on uneven ground."},
      Number<S>{"side_slope",
                &S::side_slope_deg,
                Unit::degree,
                {-40, 40},
                Tier::basic,
                "Side slope of the field. Positive: the ground falls to the right of the line from A to B."},
      Number<S>{"slip_per_slope",
                &S::slip_per_slope,
                Unit::none,
                {0, 1},
                Tier::advanced,
                "Crab angle downhill per angle of side slope."},
      Number<S>{"turn_radius",
                &S::turn_radius,
                Unit::metre,
                {1, 50},
                Tier::advanced,
                "Radius of the driver's turns on the headland."},
  };
}

template <class S>
Entries<S> receiver_entries() {
  return {
      Number<S>{
          "rate", &S::rate, Unit::hertz, {1, 100}, Tier::advanced, "Position fixes and steering commands per second."},
      Number<S>{"white_noise",
                &S::white_noise,
                Unit::metre,
                {0, 10},
                Tier::basic,
                "Standard deviation per axis of the noise from fix to fix."},
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
                "Position jumps per hour, as after a change of satellites."},
      Number<S>{
          "jump_size", &S::jump_size, Unit::metre, {0, 100}, Tier::basic, "Standard deviation per axis of a jump."},
      Number<S>{"jump_time",
                &S::jump_time,
                Unit::second,
                {0.1, 1e5},
                Tier::advanced,
                "Time constant with which a jump decays."},
      Number<S>{"outages_per_hour",
                &S::outages_per_hour,
                Unit::none,
                {0, 3600},
                Tier::basic,
                "Losses of all fixes per hour."},
      Number<S>{"outage_length", &S::outage_length, Unit::second, {0.1, 600}, Tier::basic, "Mean duration of a loss."},
      Number<S>{"heading_noise",
                &S::heading_noise_deg,
                Unit::degree,
                {0, 20},
                Tier::advanced,
                "Standard deviation of the heading from two antennas."},
      Number<S>{"tilt_noise",
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
                "Distance of the antenna ahead of the middle of the rear axle."},
      Number<S>{"antenna_left",
                &S::antenna_left,
                Unit::metre,
                {-10, 10},
                Tier::advanced,
                "Distance of the antenna to the left of the middle of the rear axle."},
      Number<S>{"antenna_up",
                &S::antenna_up,
                Unit::metre,
                {-10, 20},
                Tier::advanced,
                "Height of the antenna above the ground."},
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
                "Standard deviation per axis of a fix, as the filter assumes it."},
      Number<S>{"acceleration_sigma",
                &S::acceleration_sigma,
                Unit::none,
                {1e-4, 100},
                Tier::advanced,
                "Standard deviation of the acceleration, as the filter assumes it, m/s2. A larger value follows the "
                "fixes more closely."},
      Number<S>{"gate",
                &S::gate,
                Unit::none,
                {1, 1000},
                Tier::advanced,
                "Distance from the prediction, in standard deviations, beyond which a fix is rejected."},
      Number<S>{"patience",
                &S::patience,
                Unit::second,
                {0, 600},
                Tier::advanced,
                "Time for which rejected fixes are ignored. Then the filter starts again at the new position."},
      Number<S>{"max_outage",
                &S::max_outage,
                Unit::second,
                {0.1, 600},
                Tier::basic,
                "Time without a fix after which the tractor stops and waits."},
  };
}

template <class S>
Entries<S> control_entries() {
  return {
      OpenNumber<S>{"preview",
                    &S::preview,
                    Unit::metre,
                    {0, 50},
                    "published",
                    Tier::basic,
                    "Preview distance ahead of the tractor. published: from the paper's table at the speed."},
      OpenNumber<S>{"gain_p",
                    &S::gain_p,
                    Unit::none,
                    {0, 1e4},
                    "published",
                    Tier::basic,
                    "Wheel angle per preview error, deg/m. published: from the paper's table."},
      OpenNumber<S>{"gain_i",
                    &S::gain_i,
                    Unit::none,
                    {0, 1e4},
                    "published",
                    Tier::basic,
                    "Wheel angle per integral of the error, deg/(m s). published: from the paper's table."},
      OpenNumber<S>{"gain_d",
                    &S::gain_d,
                    Unit::none,
                    {0, 1e4},
                    "published",
                    Tier::basic,
                    "Wheel angle per speed across the line (V tan alpha), deg s/m. published: from the paper's table."},
      Number<S>{"approach_angle",
                &S::approach_angle_deg,
                Unit::degree,
                {1, 80},
                Tier::advanced,
                "Largest angle at which the tractor approaches a distant line."},
      Number<S>{
          "max_command",
          &S::max_command_deg,
          Unit::degree,
          {1, 80},
          Tier::advanced,
          "Largest commanded wheel angle on a line. More than the wheels can follow makes the tractor oscillate."},
      Number<S>{"integral_zone",
                &S::integral_zone,
                Unit::metre,
                {0, 10},
                Tier::advanced,
                "Distance from the line within which the error is integrated."},
      Number<S>{"integral_limit",
                &S::integral_limit_deg,
                Unit::degree,
                {0, 40},
                Tier::advanced,
                "Largest wheel angle of the integral part."},
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
                               "Seed of all randomness. The same seed gives the same drive."});
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
                  "speeds", &S::speeds, TextKind::plain, {}, Tier::basic, "Speeds of the drives in km/h, as a list."},
              Option<S, int>{"repeats", &S::repeats, Unit::none, {1, 1000}, Tier::basic, "Number of drives per speed."},
              Option<S, int>{
                  "rows", &S::rows, Unit::none, {1, 100}, Tier::basic, "Number of neighbouring lines per drive."},
              Number<S>{"row_width",
                        &S::row_width,
                        Unit::metre,
                        {0.1, 100},
                        Tier::basic,
                        "Distance between neighbouring lines."},
              Number<S>{"run_in",
                        &S::run_in,
                        Unit::metre,
                        {0, 1000},
                        Tier::basic,
                        "Distance at the start of each line that is not measured."},
              Number<S>{"measured_length",
                        &S::measured_length,
                        Unit::metre,
                        {1, 1e5},
                        Tier::basic,
                        "Measured length of each line. The paper asks for 80 m."},
              Number<S>{"direction",
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
                        "Distance to the left of the line at which the drive starts."},
          },
          drive_entries<S>()),
      [](const S& o) { speeds_km_h(o.speeds); });
  return table;
}

const OptionTable& option_table(const TuneOptions*) {
  using S = TuneOptions;
  static const OptionTable table = make_option_table<S>(joined<S>(
      {
          Number<S>{"speed_km_h", &S::speed_km_h, Unit::none, {0.1, 40}, Tier::basic, "Speed to tune for, km/h."},
          Number<S>{"first_p",
                    &S::first_p,
                    Unit::none,
                    {1, 1e4},
                    Tier::basic,
                    "Medium gain P, deg/m, with which the preview distance is tuned."},
          Number<S>{"first_preview",
                    &S::first_preview,
                    Unit::metre,
                    {2, 50},
                    Tier::advanced,
                    "Large preview distance from which tuning starts."},
          Number<S>{"start_offset",
                    &S::start_offset,
                    Unit::metre,
                    {0.001, 10},
                    Tier::advanced,
                    "Distance from the line at which each trial starts."},
          Number<S>{"oscillation",
                    &S::oscillation,
                    Unit::metre,
                    {1e-5, 1},
                    Tier::advanced,
                    "Smallest lasting swing that counts as oscillation."},
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
