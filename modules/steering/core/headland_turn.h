// How a driver turns from one line to the next.
#pragma once

#include <vector>

namespace bole::steering {

struct Arc {
  double length_m = 0;
  double curvature = 0;  // 1/m, positive to the left
};

// Turns round to a line `shift_m` to the left (negative: right) and back the other way: three arcs with a bulb where
// the lines are nearer than two radii, else two quarter circles with a straight between.
std::vector<Arc> headland_turn(double shift_m, double radius_m);

}  // namespace bole::steering
