// A tractor on uneven, sloping ground, and the receiver on its roof.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "steering/core/steering_options.h"

namespace bole::steering {

// A value that forgets its past over `time_s`, of scatter `sigma` (first-order Gauss-Markov).
class Coloured {
 public:
  Coloured(double sigma, double time_s, std::mt19937_64& random);
  double step(double dt_s, std::mt19937_64& random);
  double value() const { return value_; }

 private:
  double sigma_, time_s_, value_;
};

// Kinematic bicycle about the middle of the rear axle: yaw rate = V tan(wheel) / wheelbase. Dead time, a first-order
// lag, a rate and an angle limit and a dead band stand between the command and the wheel; on a slope the tractor slides
// downhill, and rough ground pushes it.
class Tractor {
 public:
  Tractor(const DriveOptions& options, std::uint64_t seed);

  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double yaw_rad = 0, wheel_rad = 0, speed_m_s = 0;
  double roll_rad() const, pitch_rad() const;

  void command(double wheel_rad, double time_s);
  void drive(double dt_s, double time_s);

 private:
  const DriveOptions& o_;
  std::mt19937_64 random_;
  Coloured roll_, pitch_, push_, turn_;
  std::deque<std::pair<double, double>> commands_;  // time of effect, angle
  double wanted_rad_ = 0;
};

struct Disturbance {
  double start_s = 0, duration_s = 0;
  Eigen::Vector2d jump_m = Eigen::Vector2d::Zero();  // zero: an outage
};

// Positions of the antenna by satellite-based precise point positioning.
class Receiver {
 public:
  Receiver(const DriveOptions& options, std::uint64_t seed);
  // Disturbances of a drive that takes so long, drawn; `given` replaces them.
  void disturb(double duration_s);
  void disturb(std::vector<Disturbance> given) { disturbances_ = std::move(given); }

  // Empty during an outage. Calls come with growing times.
  std::optional<Eigen::Vector2d> fix(const Eigen::Vector2d& antenna, double time_s);

 private:
  const DriveOptions& o_;
  std::mt19937_64 random_;
  Coloured drift_[2], wander_[2];
  Eigen::Vector2d start_drift_;  // the line is set with the receiver too: its error then does not count
  double last_s_ = 0;
  std::vector<Disturbance> disturbances_;
};

}  // namespace bole::steering
