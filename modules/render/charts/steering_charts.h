// How far a machine was from its line.
#pragma once

#include <string>
#include <vector>

#include "render/draw/figure.h"

namespace bole {

// Errors along a way; a NaN breaks the curve.
struct ErrorCurve {
  std::string label;
  std::vector<double> station_m, error_m, second_m;  // second: another error, drawn thinner; may be empty
};

// One panel per curve, one below the other, with a common scale. `second_label` names the thinner curve in the legend.
Figure error_curves(const std::string& name, const std::string& title, const std::vector<ErrorCurve>& curves,
                    const std::string& error_label, const std::string& second_label, double width_mm);

}  // namespace bole
