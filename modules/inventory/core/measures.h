// Small formulas that several plot values rest on.
#pragma once

#include <numbers>

namespace bole::inventory {

// Half the width of a 95 % interval in standard deviations of a normal distribution.
constexpr double z_95 = 1.959964;

// Of a stem at breast height: pi/4 d^2 in square metres, of a diameter in centimetres.
inline double basal_area_m2(double dbh_cm) { return std::numbers::pi / 4 * dbh_cm * dbh_cm / 10000; }

}  // namespace bole::inventory
