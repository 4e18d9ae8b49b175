// Measurements of an inertial unit between two times as one relative motion: Forster, Carlone, Dellaert and Scaramuzza
// 2017, "On-manifold preintegration for real-time visual-inertial odometry". The motion does not depend on the pose and
// the velocity at its begin, nor on gravity, and it is corrected for a changed bias without integrating again.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "base/transform.h"
#include "cloud/inertial.h"

namespace bole::slam {

using Matrix9d = Eigen::Matrix<double, 9, 9>;

struct InertialBias {
  Eigen::Vector3d gyroscope = Eigen::Vector3d::Zero();      // rad/s
  Eigen::Vector3d accelerometer = Eigen::Vector3d::Zero();  // m/s2
};

// With begin 0, end 1, T seconds and gravity g:
//   R1 = R0 turn,  v1 = v0 + g T + R0 velocity,  p1 = p0 + v0 T + g T^2 / 2 + R0 shift
struct Preintegration {
  double duration_s = 0;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), shift = Eigen::Vector3d::Zero();
  // With the bias greater by d: turn exp(turn_by_gyroscope d), velocity + velocity_by_gyroscope d, ...
  Eigen::Matrix3d turn_by_gyroscope = Eigen::Matrix3d::Zero(), velocity_by_gyroscope = Eigen::Matrix3d::Zero(),
                  velocity_by_accelerometer = Eigen::Matrix3d::Zero(), shift_by_gyroscope = Eigen::Matrix3d::Zero(),
                  shift_by_accelerometer = Eigen::Matrix3d::Zero();
  // Of a small turn in the axes of the end, of the velocity and of the shift.
  Matrix9d covariance = Matrix9d::Zero();

  // A step of constant rate and force, already free of the bias.
  void add(const Eigen::Vector3d& rate_rad_s, const Eigen::Vector3d& force_m_s2, double dt_s,
           const InertialNoise& noise);
};

// d exp(v) = exp(v) exp(J d).
Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& v);

// The samples of a record on the clock of the frames.
class InertialMeasurements {
 public:
  InertialMeasurements() = default;
  // A sample stamped t is taken as measured at t - time_offset_s.
  explicit InertialMeasurements(const InertialRecord& record, double time_offset_s = 0);

  const std::vector<InertialSample>& samples() const { return samples_; }
  // Whether there are measurements all through [begin_s, end_s].
  bool cover(double begin_s, double end_s) const;
  // Measurement at a time within the record, linear between samples.
  InertialSample at(double time_s) const;

  // Calls step(rate, force, dt) from begin to end with the means between samples. Wants cover(begin_s, end_s).
  template <class Step>
  void walk(double begin_s, double end_s, Step&& step) const {
    if (!(end_s > begin_s)) return;
    auto next = std::ranges::upper_bound(samples_, begin_s, {}, &InertialSample::time_s);
    InertialSample from = at(begin_s);
    while (true) {
      const bool last = next == samples_.end() || next->time_s >= end_s;
      const InertialSample to = last ? at(end_s) : *next;
      if (to.time_s > from.time_s)
        step(0.5 * (from.angular_rate_rad_s + to.angular_rate_rad_s),
             0.5 * (from.specific_force_m_s2 + to.specific_force_m_s2), to.time_s - from.time_s);
      if (last) return;
      from = to;
      ++next;
    }
  }
  Preintegration integrate(double begin_s, double end_s, const InertialBias& bias, const InertialNoise& noise) const;

 private:
  std::vector<InertialSample> samples_;
};

// What is not known of a mount that was estimated: standard deviations. The final adjustment estimates it anew.
struct MountSigmas {
  double turn_rad = 0, lever = 0, time_s = 0;
};

// An inertial unit as SLAM uses it: all of it is known, or was estimated.
struct InertialUnit {
  InertialMeasurements data;
  Pose T_sensor_imu = Pose::Identity();
  InertialNoise noise;
  std::optional<MountSigmas> mount_sigmas;  // nothing where the mount was given
  double time_offset_s = 0;                 // that `data` were brought to the clock of the frames with
};

}  // namespace bole::slam
