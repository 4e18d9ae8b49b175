// The state that an inertial unit needs beside the pose: velocity, biases and gravity, with their covariance.
//
// A frame is predicted by integrating the unit over it. Begin and end pose of the frame then have a joint normal
// distribution, which is the prior of its registration (elastic frames: twelve unknowns), and what registration finds
// corrects the rest of the state. This is the iterated Kalman filter of FAST-LIO2 (Xu et al. 2022) with the pose at the
// begin of the frame kept as a second one (stochastic cloning, Roumeliotis and Burdick 2002): it fits frames that have
// two poses, needs no window of past frames, and the points are still matched anew in each iteration.
#pragma once

#include <optional>

#include "slam/core/inertial/preintegration.h"
#include "slam/core/odometry/motion.h"

namespace bole::slam {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Matrix18d = Eigen::Matrix<double, 18, 18>;
using Matrix24d = Eigen::Matrix<double, 24, 24>;
using Vector18d = Eigen::Matrix<double, 18, 1>;

// The order in the covariance: turn of the unit (map axes, from the left), its place, velocity, bias of the gyroscope,
// bias of the accelerometer, gravity.
struct InertialState {
  double time_s = 0;
  Pose T_map_imu = Pose::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, map axes
  InertialBias bias;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // m/s2, map axes: points down
  Matrix18d covariance = Matrix18d::Zero();
};

// The state at the end of an integration. `transition`: d(error after) / d(error before).
InertialState propagated(const InertialState& from, const Preintegration& by, const InertialNoise& noise,
                         Matrix18d& transition);
// The state moved by a small error.
InertialState moved(InertialState state, const Vector18d& error);

// Gravity in the axes of the sensor at a time and whether the sensor was at rest then.
struct InertialStart {
  bool at_rest = false;
  Eigen::Vector3d gravity_in_sensor = Eigen::Vector3d::Zero();
};

class InertialFilter {
 public:
  // What is expected of a frame.
  struct Prediction {
    FrameMotion motion;    // of the sensor, with the shape of the motion within the frame
    Matrix12d covariance;  // of begin and end pose: turn (map axes) and shift of each
    InertialState state;   // of the end
    Matrix24d joint;       // covariance of `state` and of the pose of the unit at the begin
    Eigen::Matrix<double, 12, 24> to_sensor;
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

  const InertialState& state() const { return state_; }
  // Largest standard deviation of a place.
  static double shift_sigma(const InertialState& state);

 private:
  Eigen::Matrix<double, 6, 6> pose_to_sensor(const Pose& T_map_imu) const;

  const InertialUnit& unit_;
  InertialState state_;
  bool started_ = false;
};

}  // namespace bole::slam
