// Tractor, receiver, filter and controller in one loop.
#pragma once

#include <optional>

#include "steering/core/guidance_line.h"
#include "steering/core/navigator.h"
#include "steering/core/preview_pid.h"
#include "steering/core/receiver.h"
#include "steering/core/tractor.h"

namespace bole::steering {

// What is known after a fix interval. Positions are those of the control point, the middle of the rear axle on the
// ground, in navigation axes (metres).
struct DriveSample {
  double time_s = 0;
  Eigen::Vector2d truth = Eigen::Vector2d::Zero();
  Eigen::Vector2d navigated = Eigen::Vector2d::Zero();  // by the filter
  std::optional<Eigen::Vector2d> received;              // one fix, brought to the control point
  double yaw_rad = 0;                                   // as measured
  double offset_m = 0;                                  // of the navigated point, positive left of the line
  double command_rad = 0, wheel_rad = 0;
  bool stopped = false;  // for want of fixes
};

class Drive {
 public:
  // `field_line` is the line from A to B: the slope falls to its right.
  Drive(const DriveOptions& options, double speed_km_h, const GuidanceLine& field_line, std::uint64_t seed);

  // Puts the tractor at rest on the wheel, running at speed, and the filter where it is.
  void place(const Eigen::Vector2d& rear_axle_nav, double yaw_rad);
  void follow(const GuidanceLine& line);  // from now on; the integral part starts anew
  DriveSample steer();                    // one interval under control
  // One interval in the driver's hands, with a curvature (1/m, positive to the left); navigation goes on.
  DriveSample turn(double curvature);

  const Eigen::Vector2d& truth() const { return tractor_.rear_axle(); }
  double speed_m_s() const { return tractor_.speed_m_s(); }

 private:
  DriveSample observe();
  DriveOptions o_;
  double dt_s_, target_speed_m_s_;
  Tractor tractor_;
  Receiver receiver_;
  Navigator navigator_;
  PreviewPid pid_;
  Random attitude_noise_;
  GuidanceLine line_;
  double time_s_ = 0;
};

}  // namespace bole::steering
