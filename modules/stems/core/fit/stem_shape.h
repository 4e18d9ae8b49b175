// What the part of a stem that was seen leaves unknown of the whole.
#pragma once

#include <algorithm>
#include <numbers>

namespace bole::stems {

// Stems are not round: what is seen of one tells the mean of all sides only so well. Standard deviation of the radius,
// metres.
inline double unseen_shape_sd(double radius_m, double arc_rad) {
  constexpr double out_of_round = 0.02;  // spread of the radius between sides, relative
  return out_of_round * radius_m * std::max(0.0, 1 - arc_rad / (2 * std::numbers::pi));
}

// Points of a wide beam that brushed the edges of a stem lie beside it. Where it was seen all round others tell
// against them; the less of it was seen, the more its circle follows them, and always outward. The numbers were read
// off three simulated scans of one sensor and tried on others (docs/dev/diameters.md, "Clouds without rays").
inline double unknown_edges_m(double sigma_m, double arc_rad) {
  constexpr double by_unseen_squared = 10, most = 2;  // of the scatter
  const double unseen = std::max(0.0, 1 - arc_rad / (2 * std::numbers::pi));
  return sigma_m * std::min(most, by_unseen_squared * unseen * unseen);
}

}  // namespace bole::stems
