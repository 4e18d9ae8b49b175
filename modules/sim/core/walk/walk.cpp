#include "sim/core/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "sim/core/scene/random.h"

namespace bole::sim {
namespace {

using std::numbers::pi;
constexpr double rest_at_end_s = 1.0;

double footing(const Terrain& terrain, const Eigen::Vector2d& p) {
  double sum = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) sum += terrain.height(p.x() + 0.3 * i, p.y() + 0.3 * j);
  return sum / 9;
}

template <class Get>
void smooth_knots(std::vector<Eigen::Vector4d>& knots, int iterations, Get&& get) {
  for (int k = 0; k < iterations; ++k) {
    std::vector<double> before(knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) before[i] = get(knots[i]);
    for (std::size_t i = 1; i + 1 < knots.size(); ++i)
      get(knots[i]) = 0.5 * before[i] + 0.25 * (before[i - 1] + before[i + 1]);
  }
}

Eigen::Vector4d spline(const std::vector<Eigen::Vector4d>& knots, double u) {
  const auto last = static_cast<long>(knots.size()) - 1;
  const long i = std::clamp(static_cast<long>(std::floor(u)), 0L, last);
  const double t = u - static_cast<double>(i);
  const auto knot = [&](long k) -> const Eigen::Vector4d& {
    return knots[static_cast<std::size_t>(std::clamp(k, 0L, last))];
  };
  const double s = 1 - t;
  return (s * s * s * knot(i - 1) + (3 * t * t * t - 6 * t * t + 4) * knot(i) +
          (3 * s * s * s - 6 * s * s + 4) * knot(i + 1) + t * t * t * knot(i + 2)) /
         6;
}

}  // namespace

double Walk::Swing::at(double t) const {
  double sum = 0;
  for (std::size_t i = 0; i < amplitude.size(); ++i)
    sum += amplitude[i] * std::sin(2 * pi * frequency_hz[i] * t + phase[i]);
  return sum;
}

Walk::Swing Walk::make_swing(double size, Random& random) const {
  Swing swing;
  for (std::size_t i = 0; i < swing.amplitude.size(); ++i) {
    swing.amplitude[i] = size * random.uniform(0.3, 0.7);
    swing.frequency_hz[i] = random.uniform(0.05, 0.4);
    swing.phase[i] = random.angle();
  }
  return swing;
}

Walk::Walk(const std::vector<Eigen::Vector2d>& route, const Terrain& terrain, const WalkParameters& parameters,
           std::uint64_t seed)
    : parameters_(parameters), terrain_(terrain) {
  if (route.size() < 3)
    throw bad_input("a route of " + std::to_string(route.size()) + " points", "a walk of at least a metre");
  const auto last = static_cast<long>(route.size()) - 1;
  double heading = 0;
  for (long i = 0; i <= last; ++i) {
    const auto& p = route[static_cast<std::size_t>(i)];
    // Looking a metre ahead and behind.
    const Eigen::Vector2d way =
        route[static_cast<std::size_t>(std::min(i + 4, last))] - route[static_cast<std::size_t>(std::max(i - 4, 0L))];
    const double towards = std::atan2(way.y(), way.x());
    heading = i == 0 ? towards : heading + std::remainder(towards - heading, 2 * pi);
    knots_.emplace_back(p.x(), p.y(), footing(terrain, p), heading);
  }
  smooth_knots(
      knots_, 6, [](auto& k) -> auto& { return k[2]; });
  smooth_knots(
      knots_, 12, [](auto& k) -> auto& { return k[3]; });
  length_m_ = step_m * static_cast<double>(last);
  // Easing in and out covers half of its time at full speed.
  full_speed_s_ = std::max(0.0, length_m_ / parameters.speed_m_s - ease_s_);
  // The fastest moment of an eased turn is half as fast again as its mean.
  turn_s_ = 1.5 * std::abs(parameters.turn_rad) / (90 * rad_per_deg);
  duration_s_ = parameters.stand_still_s + turn_s_ + full_speed_s_ + 2 * ease_s_ + rest_at_end_s;
  if (parameters.max_s) duration_s_ = std::min(duration_s_, *parameters.max_s);

  Random random(seed, Stream::walk);
  mount_yaw_rad_ = random.angle();
  step_hz_ = 1.8 * std::sqrt(std::clamp(parameters.speed_m_s, 0.3, 2.5)) * random.uniform(0.95, 1.05);
  for (auto& p : phases_) p = random.angle();
  const double degree = rad_per_deg * parameters.gait;
  swings_ = {make_swing(1.5 * degree, random), make_swing(1.5 * degree, random), make_swing(3.0 * degree, random),
             make_swing(0.02 * parameters.gait, random)};
}

Walk::Progress Walk::progress(double t) const {
  const double v = parameters_.speed_m_s;
  // Pace rises as smoothstep x^2 (3 - 2 x), whose integral is x^3 - x^4 / 2.
  const auto pace = [](double x) { return x * x * (3 - 2 * x); };
  const auto run_up = [&](double x) { return v * ease_s_ * (x * x * x - 0.5 * x * x * x * x); };
  double s = t - parameters_.stand_still_s - turn_s_;
  if (s <= 0) return {0, 0};
  if (s < ease_s_) return {run_up(s / ease_s_), pace(s / ease_s_)};
  s -= ease_s_;
  if (s < full_speed_s_) return {0.5 * v * ease_s_ + v * s, 1};
  s -= full_speed_s_;
  const double x = std::max(0.0, 1 - s / ease_s_);
  return {v * ease_s_ + v * full_speed_s_ - run_up(x), pace(x)};
}

double Walk::turned_rad(double t) const {
  if (turn_s_ <= 0) return 0;
  const double x = std::clamp((t - parameters_.stand_still_s) / turn_s_, 0.0, 1.0);
  return parameters_.turn_rad * x * x * (3 - 2 * x);
}

// The ground under the four ends of the tracks decides how the robot stands; engine and links shake it a little.
Pose Walk::robot_pose(const Eigen::Vector4d& k, double pace, double t) const {
  constexpr double half_length_m = 0.35, half_width_m = 0.25;
  const double yaw = k[3] + turned_rad(t);
  const Eigen::Vector2d at = k.head<2>(), ahead(std::cos(yaw), std::sin(yaw)), left(-ahead.y(), ahead.x());
  const auto ground = [&](double along, double across) {
    const Eigen::Vector2d p = at + along * ahead + across * left;
    return terrain_.height(p.x(), p.y());
  };
  const double front_left = ground(half_length_m, half_width_m), front_right = ground(half_length_m, -half_width_m),
               rear_left = ground(-half_length_m, half_width_m), rear_right = ground(-half_length_m, -half_width_m);
  const double shake = 0.08 * rad_per_deg * parameters_.gait * pace;
  const double pitch = -std::atan2(0.5 * (front_left + front_right - rear_left - rear_right), 2 * half_length_m) +
                       shake * (std::sin(2 * pi * 4.3 * t + phases_[0]) + std::sin(2 * pi * 7.9 * t + phases_[1])),
               roll = std::atan2(0.5 * (front_left + rear_left - front_right - rear_right), 2 * half_width_m) +
                      shake * (std::sin(2 * pi * 5.1 * t + phases_[2]) + std::sin(2 * pi * 6.7 * t + phases_[3]));
  Pose T = Pose::Identity();
  const Eigen::Matrix3d body = rotation_from_rpy(roll, pitch, yaw);
  T.linear() = parameters_.mount_tilt_rad == 0
                   ? body
                   : Eigen::Matrix3d(body * Eigen::AngleAxisd(parameters_.mount_tilt_rad, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d base(at.x(), at.y(), 0.25 * (front_left + front_right + rear_left + rear_right));
  T.translation() = base + parameters_.sensor_height_m * body.col(2);
  return T;
}

Eigen::Matrix3d Walk::mount() const {
  Eigen::Matrix3d turned = Eigen::AngleAxisd(mount_yaw_rad_, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  if (parameters_.mount_tilt_rad == 0) return turned;
  return Eigen::AngleAxisd(parameters_.mount_tilt_rad, Eigen::Vector3d::UnitY()) * turned;
}

double Walk::heading_rad(double t) const { return spline(knots_, progress(t).distance_m / step_m)[3] + turned_rad(t); }

double Walk::stride_rad(double t) const { return pi * step_hz_ * t + phases_[1]; }

Pose Walk::pose(double t) const {
  const auto [distance, pace] = progress(t);
  const Eigen::Vector4d k = spline(knots_, distance / step_m);
  if (parameters_.carrier == Carrier::robot) return robot_pose(k, pace, t);
  // Even a standing person trembles a little. On the back nothing wanders like a hand.
  const double step = parameters_.gait * pace,
               hand = (0.04 + 0.96 * pace) * (parameters_.carrier == Carrier::backpack ? 0.3 : 1);
  const double beat = 2 * pi * step_hz_ * t;
  const double bob = 0.022 * step * std::cos(beat + phases_[0]);
  const double sway = 0.025 * step * std::sin(0.5 * beat + phases_[1]);
  const double roll = 1.5 * rad_per_deg * step * std::sin(0.5 * beat + phases_[2]) + hand * swings_[0].at(t);
  const double pitch = 1.2 * rad_per_deg * step * std::sin(beat + phases_[3]) + hand * swings_[1].at(t);
  const double yaw =
      k[3] + turned_rad(t) + 2.0 * rad_per_deg * step * std::sin(0.5 * beat + phases_[3]) + hand * swings_[2].at(t);
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(roll, pitch, yaw) * mount();
  T.translation() = Eigen::Vector3d(k[0] - sway * std::sin(k[3]), k[1] + sway * std::cos(k[3]),
                                    k[2] + parameters_.sensor_height_m + bob + hand * swings_[3].at(t));
  return T;
}

Trajectory Walk::trajectory(double rate_hz, double epoch_s) const {
  Trajectory out;
  out.axes = Axes::plot;
  const auto count = static_cast<long>(std::floor(duration_s_ * rate_hz)) + 1;
  for (long i = 0; i <= count; ++i) {
    const double t = static_cast<double>(i) / rate_hz;
    out.poses.push_back({epoch_s + t, pose(t)});
  }
  return out;
}

}  // namespace bole::sim
