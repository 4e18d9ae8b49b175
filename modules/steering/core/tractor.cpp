#include "steering/core/tractor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::steering {
namespace {

constexpr double deg = std::numbers::pi / 180;

double normal(std::mt19937_64& random) { return std::normal_distribution<double>()(random); }

}  // namespace

Coloured::Coloured(double sigma, double time_s, std::mt19937_64& random)
    : sigma_(sigma), time_s_(time_s), value_(sigma * normal(random)) {}

double Coloured::step(double dt, std::mt19937_64& random) {
  const double keep = std::exp(-dt / time_s_);
  return value_ = keep * value_ + sigma_ * std::sqrt(1 - keep * keep) * normal(random);
}

Tractor::Tractor(const DriveOptions& o, std::uint64_t seed)
    : o_(o),
      random_(seed),
      roll_(o.roughness * deg, 0.8, random_),
      pitch_(o.roughness * deg, 0.8, random_),
      push_(0.01 * o.roughness, 0.7, random_),
      turn_(o.roughness * deg, 0.3, random_) {}

double Tractor::roll_rad() const {
  // Rising to the left of the x axis lowers the right side when driving along it.
  return roll_.value() + std::cos(yaw_rad) * o_.cross_slope * deg;
}

double Tractor::pitch_rad() const { return pitch_.value() - std::sin(yaw_rad) * o_.cross_slope * deg; }

void Tractor::command(double wheel, double t) { commands_.emplace_back(t + o_.steering_delay, wheel); }

void Tractor::drive(double dt, double t) {
  while (!commands_.empty() && commands_.front().first <= t)
    wanted_rad_ = commands_.front().second, commands_.pop_front();
  const double limit = o_.steering_limit * deg, error = std::clamp(wanted_rad_, -limit, limit) - wheel_rad;
  if (std::abs(error) > o_.dead_band * deg) {
    const double most = o_.steering_rate * deg * dt;
    wheel_rad += std::clamp(error * (1 - std::exp(-dt / o_.steering_lag)), -most, most);
  }
  roll_.step(dt, random_), pitch_.step(dt, random_);
  // Standing, nothing pushes.
  const double moving = std::min(1.0, speed_m_s / 0.5);
  const double push = moving * push_.step(dt, random_), turn = moving * turn_.step(dt, random_);
  const Eigen::Vector2d ahead(std::cos(yaw_rad), std::sin(yaw_rad)), left(-ahead.y(), ahead.x());
  const Eigen::Vector2d slide(0, -o_.slip * std::sin(o_.cross_slope * deg) * speed_m_s);
  at += dt * (speed_m_s * ahead + push * left + slide);
  yaw_rad += dt * (speed_m_s * std::tan(wheel_rad) / o_.wheelbase + turn);
}

Receiver::Receiver(const DriveOptions& o, std::uint64_t seed)
    : o_(o),
      random_(seed ^ 0x9e3779b97f4a7c15ULL),
      drift_{Coloured(o.drift, o.drift_time, random_), Coloured(o.drift, o.drift_time, random_)},
      wander_{Coloured(o.wander, o.wander_time, random_), Coloured(o.wander, o.wander_time, random_)},
      start_drift_(drift_[0].value(), drift_[1].value()) {}

void Receiver::disturb(double duration) {
  disturbances_.clear();
  const auto draw = [&](double per_hour, double lasts, double size) {
    if (per_hour <= 0) return;
    std::exponential_distribution<double> wait(per_hour / 3600);
    for (double t = wait(random_); t < duration; t += lasts + wait(random_)) {
      Disturbance d{t, lasts, Eigen::Vector2d::Zero()};
      if (size > 0) d.jump_m = size * Eigen::Vector2d(normal(random_), normal(random_));
      disturbances_.push_back(d);
    }
  };
  draw(o_.jumps_per_hour, o_.jump_time, o_.jump_size);
  draw(o_.outages_per_hour, o_.outage_time, 0);
}

std::optional<Eigen::Vector2d> Receiver::fix(const Eigen::Vector2d& antenna, double t) {
  const double dt = std::max(0.0, t - last_s_);
  last_s_ = t;
  Eigen::Vector2d z = antenna - start_drift_;
  for (int i = 0; i < 2; ++i)
    z[i] += drift_[i].step(dt, random_) + wander_[i].step(dt, random_) + o_.noise * normal(random_);
  for (const auto& d : disturbances_) {
    if (t < d.start_s || t >= d.start_s + d.duration_s) continue;
    if (d.jump_m.isZero()) return {};
    z += d.jump_m;
  }
  return z;
}

}  // namespace bole::steering
