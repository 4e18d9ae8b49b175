// An inertial unit in the hand of a synthetic walker: exact measurements, with noise and biases where asked for.
#pragma once

#include <array>
#include <functional>
#include <random>

#include "cloud/inertial.h"
#include "synthetic/scan_world.h"

namespace bole::synthetic {

struct InertialErrors {
  Eigen::Vector3d gyroscope_bias = Eigen::Vector3d::Zero(), accelerometer_bias = Eigen::Vector3d::Zero();
  InertialNoise noise;  // without walks
  unsigned seed = 7;
};

inline Pose some_mount() {
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(0.4, -0.2, 1.9);
  T.translation() = Eigen::Vector3d(0.05, -0.08, -0.1);
  return T;
}

inline InertialErrors small_unit() {
  return {{0.004, -0.006, 0.003}, {0.06, -0.04, 0.08}, {2.6e-4, 2.3e-3, 3e-6, 4e-5}};
}

// Differences of fourth order; z of the world is up.
inline InertialRecord inertial_record(const std::function<Pose(double)>& T_world_sensor, double begin_s, double end_s,
                                      const InertialErrors& errors = {}, double rate_hz = 200, double time_offset_s = 0,
                                      const Pose& T_sensor_imu = some_mount()) {
  InertialRecord record;
  record.name = "synthetic";
  record.T_sensor_imu = T_sensor_imu;
  if (errors.noise.gyroscope_rad_s_sqrt_hz > 0) record.noise = errors.noise;
  std::mt19937 random(errors.seed);
  std::normal_distribution<double> normal;
  const auto three = [&](double sigma) -> Eigen::Vector3d {
    const double x = normal(random), y = normal(random), z = normal(random);
    return sigma * Eigen::Vector3d(x, y, z);
  };
  constexpr double h = 1e-3;
  const auto count = static_cast<int>(std::floor((end_s - begin_s) * rate_hz));
  for (int i = 0; i <= count; ++i) {
    const double stamp_s = begin_s + i / rate_hz, t = stamp_s - time_offset_s;
    std::array<Eigen::Vector3d, 5> turn, place;
    const Eigen::Matrix3d R = (T_world_sensor(t) * T_sensor_imu).linear();
    for (std::size_t k = 0; k < 5; ++k) {
      const Pose T = T_world_sensor(t + (static_cast<double>(k) - 2) * h) * T_sensor_imu;
      turn[k] = so3_log(Eigen::Quaterniond(R.transpose() * T.linear()));
      place[k] = T.translation();
    }
    const Eigen::Vector3d rate = (turn[0] - 8 * turn[1] + 8 * turn[3] - turn[4]) / (12 * h),
                          acceleration =
                              (-place[0] + 16 * place[1] - 30 * place[2] + 16 * place[3] - place[4]) / (12 * h * h);
    record.samples.push_back(
        {stamp_s, rate + errors.gyroscope_bias + three(errors.noise.gyroscope_rad_s_sqrt_hz * std::sqrt(rate_hz)),
         R.transpose() * (acceleration + 9.81 * Eigen::Vector3d::UnitZ()) + errors.accelerometer_bias +
             three(errors.noise.accelerometer_m_s2_sqrt_hz * std::sqrt(rate_hz))});
  }
  return record;
}

// Another source with an inertial unit.
class WithUnit : public FrameSource {
 public:
  WithUnit(const FrameSource& scan, InertialRecord record) : scan_(scan), record_(std::move(record)) {}
  std::size_t size() const override { return scan_.size(); }
  void read(std::size_t index, ScanFrame& frame) const override { scan_.read(index, frame); }
  double frame_time_s(std::size_t index) const override { return scan_.frame_time_s(index); }
  int rings() const override { return scan_.rings(); }
  ScanPattern pattern() const override { return scan_.pattern(); }
  const InertialRecord* inertial() const override { return &record_; }
  std::vector<double> ring_elevations_rad() const override { return scan_.ring_elevations_rad(); }
  std::string sensor_model() const override { return scan_.sensor_model(); }
  Facts facts() const override { return scan_.facts(); }
  std::string description() const override { return scan_.description(); }
  std::string locator() const override { return scan_.locator(); }

 private:
  const FrameSource& scan_;
  InertialRecord record_;
};

}  // namespace bole::synthetic
