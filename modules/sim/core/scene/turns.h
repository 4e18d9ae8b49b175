// Turns in the plane.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace bole::sim {

inline constexpr double two_pi = 2 * std::numbers::pi;

inline Eigen::Vector2d direction_of(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

}  // namespace bole::sim
