// Preview-follow PID (SPEC E4).
#pragma once

#include "steering/core/drive_options.h"

namespace bole::steering {

struct Gains {
  double preview_m = 0;
  double p = 0;  // deg/m
  double i = 0;  // deg/(m s)
  double d = 0;  // deg s/m: the paper's K_t, which multiplies V tan alpha
};

// The paper's table 1 (3, 5 and 7 km/h), straight lines between and level beyond.
Gains published_gains(double speed_km_h);

// The options' gains; those left open come from the table.
Gains gains_of(const ControlOptions& options, double speed_km_h);

// Wheel angle = -(P (e + d sin alpha) + D V tan alpha + I integral of e), with e positive left of the line and alpha
// the heading relative to the line, positive to the left. Beyond the paper: e is capped, so that a far line is
// approached at `approach_angle_deg`, the integral is fed near the line only and capped, and so is the angle asked for.
// The paper gives the gains no unit; read as degrees of the wheel per metre they damp the loop (0.9 at 3 km/h, 1.7 at
// 7).
class PreviewPid {
 public:
  PreviewPid(const ControlOptions& options, const Gains& gains) : o_(options), gains_(gains) {}
  double wheel_angle_rad(double offset_m, double heading_error_rad, double speed_m_s, double dt_s);
  void restart() { integral_deg_ = 0; }

 private:
  ControlOptions o_;
  Gains gains_;
  double integral_deg_ = 0;
};

}  // namespace bole::steering
