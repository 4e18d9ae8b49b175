// Angles: degrees where people and files meet them, radians inside.
#pragma once

#include <cmath>
#include <numbers>

namespace bole {
inline namespace base {

inline constexpr double rad_per_deg = std::numbers::pi / 180;
inline constexpr double deg_per_rad = 180 / std::numbers::pi;

constexpr double radians(double angle_deg) { return angle_deg * std::numbers::pi / 180; }
constexpr double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }

// The same direction in [-pi, pi].
inline double wrapped(double angle_rad) { return std::remainder(angle_rad, 2 * std::numbers::pi); }

}  // namespace base
}  // namespace bole
