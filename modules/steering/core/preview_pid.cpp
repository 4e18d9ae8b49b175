#include "steering/core/preview_pid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/angles.h"

namespace bole::steering {
namespace {

struct Row {
  double speed_km_h;
  Gains gains;
};
constexpr std::array<Row, 3> table{{{3, {1.4, 170, 13, 39}}, {5, {2.4, 150, 10, 30}}, {7, {3.2, 130, 8, 22}}}};

}  // namespace

Gains published_gains(double speed_km_h) {
  const double v = std::clamp(speed_km_h, table.front().speed_km_h, table.back().speed_km_h);
  const auto& lower = v < table[1].speed_km_h ? table[0] : table[1];
  const auto& upper = v < table[1].speed_km_h ? table[1] : table[2];
  const double t = (v - lower.speed_km_h) / (upper.speed_km_h - lower.speed_km_h);
  const auto between = [&](double Gains::*g) { return std::lerp(lower.gains.*g, upper.gains.*g, t); };
  return {between(&Gains::preview_m), between(&Gains::p), between(&Gains::i), between(&Gains::d)};
}

Gains gains_of(const ControlOptions& o, double speed_km_h) {
  const Gains published = published_gains(speed_km_h);
  return {o.preview.value_or(published.preview_m), o.gain_p.value_or(published.p), o.gain_i.value_or(published.i),
          o.gain_d.value_or(published.d)};
}

double PreviewPid::wheel_angle_rad(double offset_m, double heading_error_rad, double speed_m_s, double dt_s) {
  if (std::abs(offset_m) < o_.integral_zone)
    integral_deg_ =
        std::clamp(integral_deg_ + gains_.i * offset_m * dt_s, -o_.integral_limit_deg, o_.integral_limit_deg);
  // The proportional part is zero where e = -d sin alpha, so a cap on e is a cap on that angle.
  const double reach_m = std::max(gains_.preview_m, 0.5) * std::sin(o_.approach_angle_deg * rad_per_deg);
  const double e = std::clamp(offset_m, -reach_m, reach_m);
  const double alpha = std::clamp(heading_error_rad, -std::numbers::pi / 3, std::numbers::pi / 3);
  const double degrees =
      gains_.p * (e + gains_.preview_m * std::sin(alpha)) + gains_.d * speed_m_s * std::tan(alpha) + integral_deg_;
  return -std::clamp(degrees, -o_.max_command_deg, o_.max_command_deg) * rad_per_deg;
}

}  // namespace bole::steering
