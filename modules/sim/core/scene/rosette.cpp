#include "sim/core/scene/rosette.h"

#include <cmath>

#include "sim/core/scene/turns.h"

namespace bole::sim {
namespace {

constexpr double golden = 0.6180339887498949;
constexpr double wedge_1_hz = 97.31, wedge_2_hz = -wedge_1_hz * golden;
// The mirror of a full circle, and the swing of its beams.
constexpr double mirror_hz = 33.37, swing_hz = mirror_hz * golden * 11;

RosetteAngles wedges(const sensor::Rosette& r, double t, double turn) {
  const double a = two_pi * wedge_1_hz * t + turn, b = two_pi * wedge_2_hz * t - 0.37 * turn;
  const double half_height = 0.5 * (r.max_elevation_rad - r.min_elevation_rad),
               middle = 0.5 * (r.max_elevation_rad + r.min_elevation_rad);
  return {0.5 * r.horizontal_fov_rad * 0.5 * (std::cos(a) + std::cos(b)),
          middle + half_height * 0.5 * (std::sin(a) + std::sin(b))};
}

RosetteAngles mirror(const sensor::Rosette& r, double t, double share) {
  const double swing = swing_hz * t + share, phase = swing - std::floor(swing);
  // Up and down at even speed, so that all elevations get the same number of pulses.
  const double up = phase < 0.5 ? 2 * phase : 2 - 2 * phase;
  return {std::remainder(two_pi * mirror_hz * t, two_pi),
          r.min_elevation_rad + up * (r.max_elevation_rad - r.min_elevation_rad)};
}

}  // namespace

RosetteAngles rosette_angles(const sensor::Rosette& rosette, std::int64_t n) {
  const double t = static_cast<double>(n) / rosette.points_per_s;
  const auto beam = static_cast<double>(n % rosette.beams);
  if (rosette.horizontal_fov_rad >= two_pi - 1e-6) return mirror(rosette, t, beam / rosette.beams);
  return wedges(rosette, t, two_pi * beam / rosette.beams);
}

}  // namespace bole::sim
