#include "steering/core/drive.h"

#include <cmath>
#include <numbers>

#include "base/transform.h"
#include "steering/core/position_filter.h"

namespace bole::steering {
namespace {

constexpr double deg = std::numbers::pi / 180, pi = std::numbers::pi;
constexpr double control_s = 0.1;  // GNSS and controller at 10 Hz
constexpr int steps_per_control = 10;
constexpr double turn_radius_m = 6, turn_speed_m_s = 1.0, turn_lookahead_m = 1.8;
constexpr double integral_limit_deg = 4, integral_from_m = 0.25;

double wrapped(double a) { return std::remainder(a, 2 * pi); }

// From the end of the first line to the start of the second, `swath` to the left, heading back: out to the right, round
// to the left, in to the right, so that the lines may be nearer than twice the turning radius.
std::vector<Eigen::Vector2d> turn_path(const Eigen::Vector2d& end, double swath) {
  const double R = std::max(turn_radius_m, 0.51 * swath / 1.0), run_out = 3;
  const Eigen::Vector2d c1(0, -R), c3(0, swath + R),
      c2(std::sqrt(4 * R * R - (R + swath / 2) * (R + swath / 2)), swath / 2);
  std::vector<Eigen::Vector2d> path;
  const Eigen::Vector2d from = end + Eigen::Vector2d(run_out, 0);
  const auto arc = [&](const Eigen::Vector2d& c, double a0, double a1) {
    const int n = std::max(2, static_cast<int>(std::abs(a1 - a0) * R / 0.2));
    for (int i = 0; i <= n; ++i) {
      const double a = a0 + (a1 - a0) * i / n;
      path.push_back(from + c + R * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
  };
  path.push_back(end);
  const double a12 = std::atan2(c2.y() - c1.y(), c2.x() - c1.x()), a32 = std::atan2(c2.y() - c3.y(), c2.x() - c3.x());
  arc(c1, pi / 2, a12), arc(c2, a12 - pi, a32 + pi), arc(c3, a32, -pi / 2);
  for (double x = 0; x < 12; x += 0.3) path.push_back(from + Eigen::Vector2d(-x, swath));
  return path;
}

class Test {
 public:
  Test(const DriveOptions& o, const Gains& gains, double speed_km_h, std::uint64_t seed, const Run& run)
      : o_(o),
        gains_(gains),
        run_(run),
        speed_m_s_(speed_km_h / 3.6),
        tractor_(o, seed * 4 + 1),
        receiver_(o, seed * 4 + 2),
        filter_(o),
        random_(seed * 4 + 3) {}

  DriveTest drive(const std::vector<Disturbance>* disturbances) {
    if (disturbances != nullptr)
      receiver_.disturb(*disturbances);
    else
      receiver_.disturb(3 * o_.length / speed_m_s_ + 120);
    tractor_.at = {0, o_.start_offset};
    follow(1);
    turn();
    follow(2);
    return std::move(test_);
  }

 private:
  double noise(double sigma) { return sigma * std::normal_distribution<double>()(random_); }

  // The control point from the antenna's fix (eq. 5), with attitude as measured.
  bool sense() {
    const Eigen::Vector3d arm(o_.antenna_ahead, o_.antenna_left, o_.antenna_up);
    const Eigen::Matrix3d R = rotation_from_rpy(tractor_.roll_rad(), tractor_.pitch_rad(), tractor_.yaw_rad);
    const Eigen::Vector2d antenna = tractor_.at + (R * arm).head<2>();
    heading_rad_ = tractor_.yaw_rad + noise(o_.heading_noise * deg);
    const double roll = o_.lever_arm ? tractor_.roll_rad() + noise(o_.attitude_noise * deg) : 0;
    const double pitch = o_.lever_arm ? tractor_.pitch_rad() + noise(o_.attitude_noise * deg) : 0;
    const auto fix = receiver_.fix(antenna, time_s_);
    if (filter_.started()) filter_.predict(control_s);
    if (!fix) return false;
    const Eigen::Vector2d point = *fix - (rotation_from_rpy(roll, pitch, heading_rad_) * arm).head<2>();
    return filter_.update(point, tractor_.speed_m_s * Eigen::Vector2d(std::cos(heading_rad_), std::sin(heading_rad_)));
  }

  void record(int line, bool fixed) {
    DriveSample s;
    const double y = line == 2 ? o_.swath : 0;
    s.time_s = time_s_, s.line = line, s.station_m = tractor_.at.x(), s.at = tractor_.at, s.seen = filter_.position();
    s.error_m = tractor_.at.y() - y, s.seen_error_m = filter_.position().y() - y;
    s.reference_error_m = s.error_m + noise(o_.reference_noise);
    s.heading_error_rad = wrapped(tractor_.yaw_rad - (line == 2 ? pi : 0)), s.wheel_rad = tractor_.wheel_rad;
    s.fixed = fixed;
    test_.samples.push_back(s);
  }

  void advance() {
    for (int i = 0; i < steps_per_control; ++i) {
      tractor_.drive(control_s / steps_per_control, time_s_);
      time_s_ += control_s / steps_per_control;
    }
  }

  // Wheel angle by eqs. 17 and 18; left is positive, so errors to the left steer right.
  double preview_pid(int line) {
    const double sign = line == 2 ? -1 : 1;
    const double pe = sign * (filter_.position().y() - (line == 2 ? o_.swath : 0));
    const double alpha = std::clamp(wrapped(heading_rad_ - (line == 2 ? pi : 0)), -1.2, 1.2);
    const double preview = pe + gains_.preview_m * std::sin(alpha);
    // Only what is left near the line is summed up: not the way to it.
    if (std::abs(pe) < integral_from_m) integral_ += pe * control_s;
    if (gains_.i > 0) integral_ = std::clamp(integral_, -integral_limit_deg / gains_.i, integral_limit_deg / gains_.i);
    const double asked = -(gains_.p * preview + gains_.d * tractor_.speed_m_s * std::tan(alpha) + gains_.i * integral_);
    return deg * std::clamp(asked, -o_.line_limit, o_.line_limit);
  }

  void follow(int line) {
    integral_ = 0;
    const double most_s = 4 * o_.length / speed_m_s_ + 120;  // however it steers, a test ends
    const double begin_s = time_s_;
    while (time_s_ - begin_s < most_s && (line == 1 ? tractor_.at.x() < o_.length : tractor_.at.x() > 0)) {
      run_.check_cancel();
      const bool fixed = sense();
      const bool lost = !filter_.started() || filter_.age_s() > o_.outage_stop;
      tractor_.speed_m_s = lost ? 0 : speed_m_s_;
      if (lost) test_.stopped_s += control_s;
      if (filter_.started()) tractor_.command(preview_pid(line), time_s_);
      if (filter_.started()) record(line, fixed);
      advance();
    }
  }

  // The driver sees the ground: pure pursuit of the turn with the true pose.
  void turn() {
    const auto path = turn_path({o_.length, 0}, o_.swath);
    tractor_.speed_m_s = std::min(speed_m_s_, turn_speed_m_s);
    std::size_t next = 0;
    for (int k = 0; k < 3000 && next + 1 < path.size(); ++k) {
      run_.check_cancel();
      const bool fixed = sense();
      while (next + 1 < path.size() && (path[next] - tractor_.at).norm() < turn_lookahead_m) ++next;
      if (tractor_.at.x() < o_.length - 2 && tractor_.at.y() > o_.swath / 2) break;
      const Eigen::Vector2d d = path[next] - tractor_.at;
      const double aim = wrapped(std::atan2(d.y(), d.x()) - tractor_.yaw_rad);
      tractor_.command(std::atan(2 * o_.wheelbase * std::sin(aim) / std::max(d.norm(), 0.5)), time_s_);
      record(0, fixed);
      advance();
    }
  }

  const DriveOptions& o_;
  Gains gains_;
  const Run& run_;
  double speed_m_s_, time_s_ = 0, heading_rad_ = 0, integral_ = 0;
  Tractor tractor_;
  Receiver receiver_;
  PositionFilter filter_;
  std::mt19937_64 random_;
  DriveTest test_;
};

}  // namespace

Gains gains_of(const DriveOptions& o, double speed_km_h) {
  Gains g = table_gains(speed_km_h);
  if (o.preview > 0) g.preview_m = o.preview;
  if (o.gain_p > 0) g.p = o.gain_p;
  if (o.gain_i > 0) g.i = o.gain_i;
  if (o.gain_d > 0) g.d = o.gain_d;
  return g;
}

DriveTest drive_test(const DriveOptions& options, const Gains& gains, double speed_km_h, std::uint64_t seed,
                     const Run& run, const std::vector<Disturbance>* disturbances) {
  return Test(options, gains, speed_km_h, seed, run).drive(disturbances);
}

}  // namespace bole::steering
