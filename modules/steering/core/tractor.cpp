#include "steering/core/tractor.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace bole::steering {
namespace {

constexpr std::uint64_t tractor_stream = 2;
constexpr double sub_step_s = 0.01;
constexpr double roughness_length_m = 1.5;
constexpr double acceleration_m_s2 = 0.7;

}  // namespace

Tractor::Tractor(const TractorOptions& options, double slope_yaw_rad, std::uint64_t seed)
    : o_(options), slope_yaw_rad_(slope_yaw_rad), random_(seed, tractor_stream) {
  commands_.assign(static_cast<std::size_t>(std::lround(o_.steering_delay / sub_step_s)), 0.0);
}

void Tractor::place(const Eigen::Vector2d& rear_axle_nav, double yaw_rad, double speed_m_s) {
  position_ = rear_axle_nav;
  yaw_ = yaw_rad;
  speed_ = speed_m_s;
  wheel_ = 0;
  std::fill(commands_.begin(), commands_.end(), 0.0);
}

geo::Attitude Tractor::attitude() const {
  const double across = yaw_ - slope_yaw_rad_, slope = o_.side_slope_deg * rad_per_deg;
  return {slope * std::cos(across) + rough_roll_ * rad_per_deg, -slope * std::sin(across) + rough_pitch_ * rad_per_deg,
          yaw_};
}

void Tractor::turn_wheels(double dt_s, double command_rad) {
  commands_.push_back(command_rad);
  const double largest = o_.max_steering_angle_deg * rad_per_deg, fastest = o_.steering_rate_deg_s * rad_per_deg;
  const double target = std::clamp(commands_.front(), -largest, largest);
  commands_.pop_front();
  const double share = o_.steering_lag > 0 ? 1 - std::exp(-dt_s / o_.steering_lag) : 1;
  const double missing = target - wheel_, deadband = o_.steering_deadband_deg * rad_per_deg;
  const double seen = std::copysign(std::max(0.0, std::abs(missing) - deadband), missing);
  wheel_ += std::clamp(share * seen, -fastest * dt_s, fastest * dt_s);
}

// First-order Gauss-Markov processes over the way.
void Tractor::shake(double way_m) {
  const double keep = std::exp(-way_m / roughness_length_m), fresh = std::sqrt(1 - keep * keep);
  rough_roll_ = keep * rough_roll_ + fresh * o_.roughness_deg * random_.normal();
  rough_pitch_ = keep * rough_pitch_ + fresh * o_.roughness_deg * random_.normal();
  rough_wheel_ = keep * rough_wheel_ + fresh * o_.wheel_disturbance_deg * random_.normal();
}

void Tractor::advance(double dt_s, double wheel_command_rad, double speed_m_s) {
  const int steps = std::max(1, static_cast<int>(std::lround(dt_s / sub_step_s)));
  const double h = dt_s / steps, slope = o_.side_slope_deg * rad_per_deg;
  const Eigen::Vector2d downhill(std::sin(slope_yaw_rad_), -std::cos(slope_yaw_rad_));
  for (int i = 0; i < steps; ++i) {
    turn_wheels(h, wheel_command_rad);
    speed_ += std::clamp(speed_m_s - speed_, -acceleration_m_s2 * h, acceleration_m_s2 * h);
    shake(speed_ * h);
    const double angle = wheel_ + (o_.steering_offset_deg + rough_wheel_) * rad_per_deg;
    const double turn = speed_ * std::tan(angle) / o_.wheelbase * h, yaw = yaw_ + turn / 2;
    const double across = std::abs(std::cos(yaw - slope_yaw_rad_));
    position_ += speed_ * h * Eigen::Vector2d(std::cos(yaw), std::sin(yaw)) +
                 speed_ * h * std::tan(o_.slip_per_slope * slope * across) * downhill;
    yaw_ += turn;
  }
}

}  // namespace bole::steering
