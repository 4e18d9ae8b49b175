// Measurements of an inertial unit (IMU) that travels with a scanner.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/transform.h"

namespace bole {
inline namespace cloud {

// Many units give accelerations in multiples of it, m/s2.
inline constexpr double standard_gravity = 9.80665;

// In the axes of the unit, on the clock of the frames.
struct InertialSample {
  double time_s = 0;
  Eigen::Vector3d angular_rate_rad_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d specific_force_m_s2 = Eigen::Vector3d::Zero();  // at rest with z up: +9.81 along z
};

// Densities of white noise and of the random walk of the biases.
struct InertialNoise {
  double gyroscope_rad_s_sqrt_hz = 0;
  double accelerometer_m_s2_sqrt_hz = 0;
  double gyroscope_walk_rad_s2_sqrt_hz = 0;
  double accelerometer_walk_m_s3_sqrt_hz = 0;
};

struct InertialRecord {
  std::vector<InertialSample> samples;  // times strictly increase
  std::optional<Pose> T_sensor_imu;     // of the unit in the axes of the scanner; nothing where it is not known
  std::optional<InertialNoise> noise;   // nothing where it is not known
  std::string name;                     // "OS1-64", "/imu/data", "walk_imu.csv"
};

}  // namespace cloud
}  // namespace bole
