#include "steering/core/drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"

namespace bole::steering {
namespace {

constexpr std::uint64_t attitude_stream = 3;
constexpr double turning_speed_m_s = 4 / 3.6;

}  // namespace

Drive::Drive(const DriveOptions& options, double speed_km_h, const GuidanceLine& field_line, std::uint64_t seed)
    : o_(options),
      dt_s_(1 / options.rate),
      target_speed_m_s_(speed_km_h / 3.6),
      tractor_(options, field_line.yaw_rad, seed),
      receiver_(options, seed),
      navigator_(options, {options.antenna_forward, options.antenna_left, options.antenna_up}),
      pid_(options, gains_of(options, speed_km_h)),
      attitude_noise_(seed, attitude_stream),
      line_(field_line) {}

void Drive::place(const Eigen::Vector2d& rear_axle_nav, double yaw_rad) {
  tractor_.place(rear_axle_nav, yaw_rad, target_speed_m_s_);
  navigator_.start(rear_axle_nav, target_speed_m_s_ * Eigen::Vector2d(std::cos(yaw_rad), std::sin(yaw_rad)));
}

void Drive::follow(const GuidanceLine& line) {
  line_ = line;
  pid_.restart();
}

DriveSample Drive::observe() {
  time_s_ += dt_s_;
  DriveSample s;
  s.time_s = time_s_;
  s.truth = tractor_.rear_axle();
  const auto attitude = tractor_.attitude();
  const Eigen::Vector2d antenna = s.truth + (attitude.R_nav_body() * navigator_.lever_arm_body()).head<2>();
  const auto noise = [&](double sd_deg) { return sd_deg * rad_per_deg * attitude_noise_.normal(); };
  geo::Attitude measured = attitude;
  measured.roll_rad += noise(o_.tilt_noise_deg);
  measured.pitch_rad += noise(o_.tilt_noise_deg);
  measured.yaw_rad += noise(o_.heading_noise_deg);
  s.yaw_rad = measured.yaw_rad;
  std::optional<Eigen::Vector3d> fix;
  if (const auto seen = receiver_.fix(antenna)) fix = Eigen::Vector3d(seen->x(), seen->y(), 0);
  const auto navigated = navigator_.step(dt_s_, fix, measured, tractor_.speed_m_s());
  s.received = navigated.received;
  s.navigated = navigated.position;
  s.offset_m = line_.offset_m(s.navigated);
  s.stopped = navigator_.filter().seconds_without_fix() > o_.max_outage;
  return s;
}

DriveSample Drive::steer() {
  auto s = observe();
  const double alpha = std::remainder(s.yaw_rad - line_.yaw_rad, 2 * std::numbers::pi);
  s.command_rad = pid_.wheel_angle_rad(s.offset_m, alpha, tractor_.speed_m_s(), s.stopped ? 0 : dt_s_);
  tractor_.advance(dt_s_, s.command_rad, s.stopped ? 0 : target_speed_m_s_);
  s.wheel_rad = tractor_.wheel_rad();
  return s;
}

DriveSample Drive::turn(double curvature) {
  auto s = observe();
  s.stopped = false;  // the driver needs no fix
  s.command_rad = std::atan(o_.wheelbase * curvature);
  tractor_.advance(dt_s_, s.command_rad, std::min(target_speed_m_s_, turning_speed_m_s));
  s.wheel_rad = tractor_.wheel_rad();
  return s;
}

}  // namespace bole::steering
