// How an inertial unit is mounted in a scanner and how far its clock is ahead, from a trajectory that was estimated
// without it.
#pragma once

#include <optional>
#include <string>

#include "slam/core/inertial/preintegration.h"
#include "slam/core/odometry/motion.h"

namespace bole::slam {

struct TimedMotion {
  double begin_s = 0, end_s = 0;
  FrameMotion motion;
};

struct Mount {
  Pose T_sensor_imu = Pose::Identity();
  double time_offset_s = 0;  // the unit stamps t what happened at t - time_offset_s
  InertialBias bias;
  // Standard deviations, 1 sigma, of the weakest direction.
  double turn_sigma_rad = 0, lever_sigma = 0, time_sigma_s = 0;
  std::size_t frames = 0;
  std::string unknown;       // why the turn of the unit cannot be told; empty where it can
  bool lever_known = false;  // to 5 cm; else it is a guess with that standard deviation
};

// Turns: hand-eye calibration on mean angular rates over each frame (Wahba's problem, Kabsch 1976), with the bias of
// the gyroscope left out by centring. The offset of the clock is that with the least residual, to a fraction of a
// sample by a parabola; it is kept at `time_offset_s` where that is given. Lever arm: least squares on changes of
// velocity between frames, with gravity and the bias of the accelerometer as unknowns; it shows only in turns that
// speed up, so it is weak. Wants frames in order of time.
Mount estimate_mount(const InertialRecord& record, const std::vector<TimedMotion>& frames,
                     std::optional<double> time_offset_s);

// How far a mount that is given lies from the one that the rates show.
struct MountCheck {
  bool judged = false;  // enough frames turned, about more than one axis
  double off_rad = 0, sigma_rad = 0;
};

// Takes only frames whose turn has the size that the unit measured: the size does not depend on the mount, so that a
// frame which was registered badly speaks neither for nor against it.
MountCheck check_mount(const InertialRecord& record, const std::vector<TimedMotion>& frames, double time_offset_s);

}  // namespace bole::slam
