// The state that an inertial unit needs beside the pose: velocity, biases and gravity, with their covariance.
//
// A frame is predicted by integrating the unit over it. Begin and end pose of the frame then have a joint normal
// distribution, which is the prior of its registration (elastic frames: twelve unknowns), and what registration finds
// corrects the rest of the state. This is the iterated Kalman filter of FAST-LIO2 (Xu et al. 2022) with the pose at the
// begin of the frame kept as a second one (stochastic cloning, Roumeliotis and Burdick 2002): it fits frames that have
// two poses, needs no window of past frames, and the points are still matched anew in each iteration. A mount that was
// estimated is part of the state as well, with its standard deviations: what is not known of it widens the predictions.
#pragma once

#include <optional>

#include "slam/core/inertial/preintegration.h"
#include "slam/core/odometry/motion.h"

namespace bole::slam {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Matrix18d = Eigen::Matrix<double, 18, 18>;
using Matrix31d = Eigen::Matrix<double, 31, 31>;
using Vector18d = Eigen::Matrix<double, 18, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;
using MatrixPoseMount = Eigen::Matrix<double, 6, 7>;

// The order in the covariance: turn of the unit (map axes, from the left), its place, velocity, bias of the gyroscope,
// bias of the accelerometer, gravity.
struct InertialState {
  double time_s = 0;
  Pose T_map_imu = Pose::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, map axes
  InertialBias bias;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // m/s2, map axes: points down
  Matrix18d covariance = Matrix18d::Zero();
  // The mount: its turn (axes of the unit), lever arm (axes of the sensor) and how much later the unit stamps than its
  // measurements are taken for. Zero covariance where it was given.
  Pose T_sensor_imu = Pose::Identity();
  double later_s = 0;
  Eigen::Vector3d rate_rad_s = Eigen::Vector3d::Zero();  // of the unit at this time, free of the bias
  Matrix7d mount_covariance = Matrix7d::Zero();
  Eigen::Matrix<double, 18, 7> with_mount = Eigen::Matrix<double, 18, 7>::Zero();  // covariance of both
};

// The state at the end of an integration. `transition`: d(error after) / d(error before).
InertialState propagated(const InertialState& from, const Preintegration& by, const InertialNoise& noise,
                         Matrix18d& transition);
// The state moved by a small error.
InertialState moved(InertialState state, const Vector18d& error);

// Gravity in the axes of the sensor at a time. A unit measures the same at rest and in steady motion: only the scanner
// can tell them apart, and whoever starts a filter without having asked it must clear `at_rest`.
struct InertialStart {
  bool steady = false, at_rest = false;
  Eigen::Vector3d gravity_in_sensor = Eigen::Vector3d::Zero();
};

class InertialFilter {
 public:
  // What is expected of a frame.
  struct Prediction {
    FrameMotion motion;    // of the sensor, with the shape of the motion within the frame
    Matrix12d covariance;  // of begin and end pose: turn (map axes) and shift of each
    InertialState state;   // of the end
    Matrix31d joint;       // covariance of `state`, of the pose of the unit at the begin, and of the mount
    Eigen::Matrix<double, 12, 31> to_sensor;
  };

  explicit InertialFilter(const InertialUnit& unit) : unit_(unit) {}

  // Whether there are measurements about that time.
  std::optional<InertialStart> look(double time_s) const;
  // The sensor is at T_map_sensor, exactly, since the map hangs on it.
  void start(double time_s, const Pose& T_map_sensor, const InertialStart& from);
  bool started() const { return started_; }

  // Nothing where the unit did not measure all through, or the filter has not started.
  std::optional<Prediction> predict(double begin_s, double end_s) const;
  // The state after registration found `motion` with that information of its points about begin and end.
  InertialState corrected(const Prediction& prediction, const FrameMotion& motion, const Matrix12d& information) const;
  // How far registration moved the frame from what was expected, in squared standard deviations per unknown: below 1
  // where the unit and the points agree.
  static double tension(const Prediction& prediction, const FrameMotion& motion);
  void set(const InertialState& state) { state_ = state; }
  // The pose is known anew, as after a gap; the velocity is not.
  void restart(double time_s, const Pose& T_map_sensor);
  // The pose is exact: that of the first frame.
  void anchor();
  // The scanner saw that the sensor was at rest from that time on until now: its speed is nil, and the mean rate is the
  // bias of the gyroscope.
  void hold_still(double since_s);

  const InertialState& state() const { return state_; }
  // Of the pose of the sensor: turn and shift, map axes.
  static Matrix6d sensor_covariance(const InertialState& state);
  // Largest standard deviation of the place of the sensor.
  static double shift_sigma(const InertialState& state);

 private:
  void place_sensor(double sigma_rad, double sigma);
  template <int Rows>
  void observe(const Eigen::Matrix<double, Rows, 18>& H, const Eigen::Matrix<double, Rows, 1>& residual,
               const Eigen::Matrix<double, Rows, 1>& sigmas);

  const InertialUnit& unit_;
  InertialState state_;
  bool started_ = false;
};

}  // namespace bole::slam
