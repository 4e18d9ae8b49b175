// The options of a simulated walk.
#include "sim/core/plot/simulate.h"

namespace bole::sim {
namespace {

using Entries = std::vector<OptionEntry<SimulationOptions>>;

Entries plot_and_sensor_entries() {
  using S = SimulationOptions;
  return {
      Option<S, std::string>{"plot",
                             &S::plot,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Plot recipe: a name in resources/plots or the path of a recipe file."},
      Option<S, int>{"seed",
                     &S::seed,
                     Unit::none,
                     {0, 2147483647},
                     Tier::basic,
                     "Seed of all randomness. The same seed gives the same bytes."},
      Option<S, std::string>{"sensor",
                             &S::sensor,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Sensor: a name in resources/sensors or the path of a sensor file."},
      Option<S, double>{"rotation_rate",
                        &S::rotation_hz,
                        Unit::hertz,
                        {1, 20},
                        Tier::advanced,
                        "Revolutions of the sensor per second."},
  };
}

Entries walk_entries() {
  using S = SimulationOptions;
  return {
      Option<S, std::string>{"walk",
                             &S::walk,
                             TextKind::input_path,
                             {},
                             Tier::advanced,
                             "File of way-points, one x_m,y_m per line in plot axes. Without it the walk leads along "
                             "parallel lines, or through the alleys of a vineyard."},
      Option<S, Carrier>{
          "carrier", &S::carrier, Tier::advanced,
          "Carrier of the sensor: the hand of a walking person, a tracked robot that rolls and pitches with "
          "the ground under its tracks, or a frame on the back of a person."},
      Option<S, double>{"speed", &S::speed, Unit::metre_per_second, {0.2, 3}, Tier::basic, "Walking speed."},
      Option<S, double>{"line_spacing",
                        &S::line_spacing,
                        Unit::metre,
                        {1, 50},
                        Tier::basic,
                        "Distance between the parallel lines of the walk."},
      Option<S, double>{"sensor_height",
                        &S::sensor_height,
                        Unit::metre,
                        {0.3, 4},
                        Tier::advanced,
                        "Height of the sensor above the ground."},
      Option<S, double>{"mount_tilt",
                        &S::mount_tilt,
                        Unit::degree,
                        {-180, 180},
                        Tier::advanced,
                        "Tilt of the sensor in its mount, forward down. 180: upside down."},
      Option<S, double>{"gait",
                        &S::gait,
                        Unit::none,
                        {0, 3},
                        Tier::advanced,
                        "Strength of the operator's bob, sway and hand motion, or of a robot's vibration. 1: an "
                        "ordinary step; 0: a smooth glide."},
      Option<S, double>{"stand_still",
                        &S::stand_still,
                        Unit::second,
                        {0, 60},
                        Tier::advanced,
                        "Time at rest before the walk starts."},
      Option<S, std::optional<double>>{"max_time",
                                       &S::max_time,
                                       Unit::second,
                                       {0.2, 3600},
                                       "none",
                                       Tier::advanced,
                                       "Longest recording. none: the whole walk is recorded."},
      Option<S, double>{"turn_on_spot",
                        &S::turn_on_spot,
                        Unit::degree,
                        {-720, 720},
                        Tier::expert,
                        "Turn on the spot at 90 deg/s, between standing still and walking."},
  };
}

Entries beam_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"noise",
                        &S::noise,
                        Unit::none,
                        {0, 10},
                        Tier::advanced,
                        "Factor on the range noise and on the laser biases of the sensor. 0 gives exact ranges."},
      Option<S, double>{"divergence",
                        &S::divergence,
                        Unit::none,
                        {0, 5},
                        Tier::advanced,
                        "Factor on the size of the laser beam. 0 gives rays without mixed pixels."},
      Option<S, double>{
          "dropouts", &S::dropouts, Unit::none, {0, 0.9}, Tier::expert, "Share of pulses lost at random."},
      Option<S, double>{"laser_bias",
                        &S::laser_bias,
                        Unit::metre,
                        {0, 0.1},
                        Tier::expert,
                        "Standard deviation of the constant range error of each laser."},
      Option<S, double>{"pulse_length",
                        &S::pulse_length,
                        Unit::metre,
                        {0, 3},
                        Tier::expert,
                        "Surfaces in one beam closer together than this give one range between them."},
      Option<S, bool>{"bark", &S::bark, Tier::expert, "Bark with fissures. Otherwise stems are smooth."},
      Option<S, bool>{"bark_facets", &S::bark_facets, Tier::expert,
                      "Bark in plates that lie at different depths, in place of smooth fissures."},
      Option<S, double>{"noise_growth",
                        &S::noise_growth,
                        Unit::none,
                        {0, 5},
                        Tier::expert,
                        "Share by which the range noise grows at grazing incidence and for beams that mostly miss: 1 "
                        "doubles it."},
      Option<S, bool>{
          "dual_return", &S::dual_return, Tier::advanced,
          "Record two returns of each pulse: the strongest and the last, or the two strongest (Ouster). The packets of "
          "the sensor must have them."},
      Option<S, double>{"wet",
                        &S::wet,
                        Unit::none,
                        {0, 1},
                        Tier::advanced,
                        "Wetness of bark, leaves and ground. 1: soaked; surfaces are darker and more pulses are lost."},
      Option<S, double>{"angle_error",
                        &S::angle_error,
                        Unit::degree,
                        {0, 1},
                        Tier::expert,
                        "Standard deviation of the constant elevation and azimuth errors of each laser, which the "
                        "sensor file does not have."},
      OnlyIf{"bark", {"true"}, {"bark_facets"}},
  };
}

Entries disturbance_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"gap_at",
                        &S::gap_at,
                        Unit::second,
                        {0, 3600},
                        Tier::expert,
                        "Time after the start at which packets begin to be lost."},
      Option<S, double>{"gap", &S::gap, Unit::second, {0, 600}, Tier::expert, "Duration of the packet loss."},
      Option<S, double>{"blind_sector",
                        &S::blind_sector,
                        Unit::degree,
                        {0, 350},
                        Tier::expert,
                        "Sector around the back of the sensor from which nothing returns."},
      Option<S, double>{
          "rain", &S::rain, Unit::none, {0, 0.9}, Tier::expert, "Share of pulses that end at a rain drop."},
      Option<S, bool>{"companion", &S::companion, Tier::expert, "A person walks around the operator, 1.2 m away."},
      Option<S, double>{
          "wind",
          &S::wind,
          Unit::metre_per_second,
          {0, 20},
          Tier::advanced,
          "Wind speed. Stems sway at breast height by millimetres, crowns by decimetres at 5 m/s; 0: calm."},
      Option<S, double>{"wind_from",
                        &S::wind_from,
                        Unit::degree,
                        {-360, 360},
                        Tier::expert,
                        "Direction that the wind comes from, clockwise from north."},
      Option<S, bool>{"operator_body", &S::operator_body, Tier::advanced,
                      "The operator's body stands in the beams: behind a sensor in the hand, before one on the back."},
      Option<S, double>{"clock_jitter",
                        &S::clock_jitter,
                        Unit::second,
                        {0, 0.01},
                        Tier::expert,
                        "Standard deviation of the error of the time stamps, which wanders within seconds."},
      Unless{"gap", {"0"}, {"gap_at"}},
      Unless{"wind", {"0"}, {"wind_from"}},
      Unless{"carrier", {"robot"}, {"operator_body"}},
  };
}

Entries imu_entries() {
  using S = SimulationOptions;
  return {
      Option<S, ImuGrade>{"imu", &S::imu, Tier::basic,
                          "Inertial unit carried with the sensor and written to imu.csv: none, or with the noise and "
                          "the biases of a consumer, industrial or tactical unit."},
      Option<S, double>{"imu_rate",
                        &S::imu_rate,
                        Unit::hertz,
                        {20, 2000},
                        Tier::advanced,
                        "Samples of the inertial unit per second."},
      Option<S, double>{"imu_time_offset",
                        &S::imu_time_offset,
                        Unit::second,
                        {-0.5, 0.5},
                        Tier::expert,
                        "Time by which the clock of the inertial unit is ahead of that of the scanner."},
      Option<S, bool>{"imu_mount_known", &S::imu_mount_known, Tier::expert,
                      "Write into imu.csv how the unit is mounted in the sensor."},
      Unless{"imu", {"none"}, {"imu_rate", "imu_time_offset", "imu_mount_known"}},
  };
}

Entries truth_entries() {
  using S = SimulationOptions;
  return {
      Option<S, double>{"trajectory_rate",
                        &S::trajectory_rate,
                        Unit::hertz,
                        {1, 1000},
                        Tier::expert,
                        "Poses per second in trajectory.tum."},
      Option<S, double>{"dem_cell", &S::dem_cell, Unit::metre, {0.05, 5}, Tier::expert, "Cell size of dem.tif."},
  };
}

}  // namespace

const OptionTable& option_table(const SimulationOptions*) {
  static const OptionTable table = [] {
    Entries all;
    for (const auto& part : {plot_and_sensor_entries(), walk_entries(), beam_entries(), disturbance_entries(),
                             imu_entries(), truth_entries()})
      all.insert(all.end(), part.begin(), part.end());
    return make_option_table<SimulationOptions>(std::move(all));
  }();
  return table;
}

}  // namespace bole::sim
