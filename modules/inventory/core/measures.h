// Small formulas that several plot values rest on.
#pragma once

#include <numbers>

namespace bole::inventory {

inline constexpr double m2_per_ha = 10'000;

// Of a stem at breast height: pi/4 d^2 in square metres, of a diameter in centimetres.
inline double basal_area_m2(double dbh_cm) { return std::numbers::pi / 4 * dbh_cm * dbh_cm / m2_per_ha; }

}  // namespace bole::inventory
