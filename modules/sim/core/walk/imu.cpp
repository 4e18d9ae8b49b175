#include "sim/core/walk/imu.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "base/angles.h"
#include "base/error.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

constexpr double hour_s = 3600, milli_g = 1e-3 * gravity_m_s2, micro_g = 1e-6 * gravity_m_s2;
// A bias that wanders by its in-run instability within this time is taken as the random walk.
constexpr double instability_s = 100;

double walk_density(double instability) { return instability / std::sqrt(instability_s); }

// f'(t) and f''(t) from values at t - 2h, t - h, t, t + h, t + 2h.
template <class T>
T first_derivative(const std::array<T, 5>& f, double h) {
  return (f[0] - 8 * f[1] + 8 * f[3] - f[4]) / (12 * h);
}
template <class T>
T second_derivative(const std::array<T, 5>& f, double h) {
  return (-f[0] + 16 * f[1] - 30 * f[2] + 16 * f[3] - f[4]) / (12 * h * h);
}

Eigen::Vector3d normals(Random& random, double sigma) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return sigma * Eigen::Vector3d(x, y, z);
}

}  // namespace

ImuErrors errors_of(ImuGrade grade) {
  constexpr double deg = rad_per_deg;
  ImuErrors e;
  switch (grade) {
    case ImuGrade::none:
      return e;
    case ImuGrade::consumer:
      // TDK ICM-20948 (DS-000189): 0.015 dps/rtHz, 230 ug/rtHz. Bosch BMI088 (BST-BMI088-DS001): 0.014 dps/rtHz, 175
      // ug/rtHz, instability below 2 deg/h; zero-rate offset +-1 dps, zero-g offset +-20 mg, taken as two standard
      // deviations.
      e.noise = {0.015 * deg, 230 * micro_g, walk_density(6 * deg / hour_s), walk_density(40 * micro_g)};
      e.gyroscope_bias_rad_s = 0.5 * deg;
      e.accelerometer_bias_m_s2 = 10 * milli_g;
      e.gyroscope_scale = 0.004;
      e.accelerometer_scale = 0.003;
      return e;
    case ImuGrade::industrial:
      // Analog Devices ADIS16465-1: 0.15 deg/rth, 2 deg/h in run; 0.012 m/s/rth, 3.6 ug in run; bias repeatability
      // 1.4 mg; sensitivity 0.2 %.
      e.noise = {0.15 * deg / std::sqrt(hour_s), 0.012 / std::sqrt(hour_s), walk_density(2 * deg / hour_s),
                 walk_density(3.6 * micro_g)};
      e.gyroscope_bias_rad_s = 0.14 * deg;
      e.accelerometer_bias_m_s2 = 1.4 * milli_g;
      e.gyroscope_scale = 0.002;
      e.accelerometer_scale = 0.001;
      return e;
    case ImuGrade::tactical:
      // Honeywell HG1700 (N61-1619): 0.125 deg/rth, 1 deg/h; 0.065 ft/s/rth, 1 mg.
      e.noise = {0.125 * deg / std::sqrt(hour_s), 0.065 * 0.3048 / std::sqrt(hour_s), walk_density(1 * deg / hour_s),
                 walk_density(20 * micro_g)};
      e.gyroscope_bias_rad_s = 1 * deg / hour_s;
      e.accelerometer_bias_m_s2 = 1 * milli_g;
      e.gyroscope_scale = 150e-6;
      e.accelerometer_scale = 300e-6;
      return e;
  }
  return e;
}

Pose mounted_imu() {
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(radians(3), radians(-2), radians(91));
  T.translation() = Eigen::Vector3d(0.045, -0.03, -0.06);
  return T;
}

InertialSample exact_sample(const std::function<Pose(double)>& T_world_body, double time_s) {
  constexpr double h = 1e-3;
  std::array<Eigen::Vector3d, 5> turned, places;
  const Eigen::Matrix3d R = T_world_body(time_s).linear();
  for (std::size_t i = 0; i < 5; ++i) {
    const Pose T = T_world_body(time_s + (static_cast<double>(i) - 2) * h);
    turned[i] = so3_log(Eigen::Quaterniond(R.transpose() * T.linear()));
    places[i] = T.translation();
  }
  InertialSample s;
  s.time_s = time_s;
  s.angular_rate_rad_s = first_derivative(turned, h);
  s.specific_force_m_s2 = R.transpose() * (second_derivative(places, h) + gravity_m_s2 * Eigen::Vector3d::UnitZ());
  return s;
}

InertialRecord simulate_imu(const std::function<Pose(double)>& T_world_sensor, double duration_s, double epoch_s,
                            const ImuParameters& parameters, std::uint64_t seed) {
  const ImuErrors& e = parameters.errors;
  Random constant(seed, Stream::imu, 0), noise(seed, Stream::imu, 1), walk(seed, Stream::imu, 2);
  Eigen::Vector3d gyroscope_bias = normals(constant, e.gyroscope_bias_rad_s),
                  accelerometer_bias = normals(constant, e.accelerometer_bias_m_s2);
  const Eigen::Vector3d gyroscope_scale = Eigen::Vector3d::Ones() + normals(constant, e.gyroscope_scale),
                        accelerometer_scale = Eigen::Vector3d::Ones() + normals(constant, e.accelerometer_scale);
  // A sample is a mean over its period: white noise of density N has the standard deviation N sqrt(rate).
  const double root_rate = std::sqrt(parameters.rate_hz), root_step = 1 / root_rate;
  const Pose T_sensor_imu = mounted_imu();
  const auto T_world_imu = [&](double t) -> Pose { return T_world_sensor(t) * T_sensor_imu; };
  InertialRecord record;
  record.T_sensor_imu = T_sensor_imu;
  record.noise = e.noise;
  const auto count = static_cast<std::int64_t>(std::floor(duration_s * parameters.rate_hz));
  for (std::int64_t i = 0; i <= count; ++i) {
    const double stamp_s = static_cast<double>(i) / parameters.rate_hz;
    auto sample = exact_sample(T_world_imu, stamp_s - parameters.time_offset_s);
    sample.time_s = epoch_s + stamp_s;
    sample.angular_rate_rad_s = gyroscope_scale.cwiseProduct(sample.angular_rate_rad_s) + gyroscope_bias +
                                normals(noise, e.noise.gyroscope_rad_s_sqrt_hz * root_rate);
    sample.specific_force_m_s2 = accelerometer_scale.cwiseProduct(sample.specific_force_m_s2) + accelerometer_bias +
                                 normals(noise, e.noise.accelerometer_m_s2_sqrt_hz * root_rate);
    record.samples.push_back(sample);
    gyroscope_bias += normals(walk, e.noise.gyroscope_walk_rad_s2_sqrt_hz * root_step);
    accelerometer_bias += normals(walk, e.noise.accelerometer_walk_m_s3_sqrt_hz * root_step);
  }
  return record;
}

void write_imu(const InertialRecord& record, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  out << "# unit: " << record.name << '\n';
  if (record.T_sensor_imu) {
    const Eigen::Quaterniond q(record.T_sensor_imu->linear());
    const Eigen::Vector3d t = record.T_sensor_imu->translation();
    out << fmt::format("# T_sensor_imu: {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n", t.x(), t.y(), t.z(), q.x(),
                       q.y(), q.z(), q.w());
  }
  if (const auto& n = record.noise)
    out << fmt::format(
        "# gyroscope_rad_s_sqrt_hz: {:.4g}\n# accelerometer_m_s2_sqrt_hz: {:.4g}\n"
        "# gyroscope_walk_rad_s2_sqrt_hz: {:.4g}\n# accelerometer_walk_m_s3_sqrt_hz: {:.4g}\n",
        n->gyroscope_rad_s_sqrt_hz, n->accelerometer_m_s2_sqrt_hz, n->gyroscope_walk_rad_s2_sqrt_hz,
        n->accelerometer_walk_m_s3_sqrt_hz);
  out << "time_s,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,accel_x_m_s2,accel_y_m_s2,accel_z_m_s2\n";
  for (const auto& s : record.samples) {
    const auto &w = s.angular_rate_rad_s, &f = s.specific_force_m_s2;
    out << fmt::format("{:.6f},{:.8f},{:.8f},{:.8f},{:.7f},{:.7f},{:.7f}\n", s.time_s, w.x(), w.y(), w.z(), f.x(),
                       f.y(), f.z());
  }
  out.close();
  if (!out) throw failure("cannot write " + file.string(), "a writable folder with free space");
}

}  // namespace bole::sim
