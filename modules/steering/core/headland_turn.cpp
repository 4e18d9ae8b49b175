#include "steering/core/headland_turn.h"

#include <cmath>
#include <numbers>

namespace bole::steering {

std::vector<Arc> headland_turn(double shift_m, double radius_m) {
  const double side = shift_m < 0 ? -1 : 1, width = std::abs(shift_m), bend = side / radius_m;
  using std::numbers::pi;
  if (width >= 2 * radius_m) return {{pi / 2 * radius_m, bend}, {width - 2 * radius_m, 0}, {pi / 2 * radius_m, bend}};
  // The middle circle touches both outer ones: 2 R (2 cos phi - 1) is the shift.
  const double phi = std::acos((width + 2 * radius_m) / (4 * radius_m));
  return {{phi * radius_m, -bend}, {(pi + 2 * phi) * radius_m, bend}, {phi * radius_m, -bend}};
}

}  // namespace bole::steering
