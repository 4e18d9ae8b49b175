// An inertial unit (IMU) that is carried along with the sensor: what it measures, by the grade of the unit.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string_view>

#include "cloud/inertial.h"

namespace bole::sim {

enum class ImuGrade { none, consumer, industrial, tactical };
constexpr std::array<std::string_view, 4> choice_names(ImuGrade) {
  return {"none", "consumer", "industrial", "tactical"};
}

// Errors of a unit. Axes have independent errors of the same size.
struct ImuErrors {
  InertialNoise noise;
  double gyroscope_bias_rad_s = 0, accelerometer_bias_m_s2 = 0;  // standard deviations at the start
  double gyroscope_scale = 0, accelerometer_scale = 0;           // standard deviations of the factors, less 1
};
ImuErrors errors_of(ImuGrade grade);

struct ImuParameters {
  ImuErrors errors;
  double rate_hz = 200;
  double time_offset_s = 0;  // of the unit's clock: what it stamps t happened at t - time_offset_s
};

// How the simulated unit is mounted in the scanner: not along its axes, and beside its centre.
Pose mounted_imu();

inline constexpr double gravity_m_s2 = 9.80665;

// Angular rate and specific force in the axes of a body that moves as T_world_body(t), z of the world up. Differences
// of fourth order over 1 ms: exact to about 1e-7 of what a hand or a robot does.
InertialSample exact_sample(const std::function<Pose(double)>& T_world_body, double time_s);

// The measurements from time 0 to `duration_s` of a sensor that moves as T_world_sensor(t). Times count from `epoch_s`.
// Own random streams: the unit does not change what the scanner sees. `name` and noise are filled in.
InertialRecord simulate_imu(const std::function<Pose(double)>& T_world_sensor, double duration_s, double epoch_s,
                            const ImuParameters& parameters, std::uint64_t seed);

// CSV: lines "# name: value" with T_sensor_imu and the noise, where the record has them, then time_s, gyro_x_rad_s ..
// and accel_x_m_s2 .. Throws Error{failed}.
void write_imu(const InertialRecord& record, const std::filesystem::path& file);

}  // namespace bole::sim
