#include "stems/core/fit/beam_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bole::stems {
namespace {

using depth_grid::impact_step, depth_grid::impact_steps, depth_grid::width_step, depth_grid::width_steps;

// Mean depth by the substitution x = sin(t): the cosine of incidence is cos(t), and so is the depth. `lambert`: whether
// the light counts by the cosine of incidence.
double mean_depth(double impact, double width, bool lambert) {
  constexpr int steps = 200;
  constexpr double reach = 5;
  const double low = std::asin(std::clamp(impact - reach * width, -1.0, 1.0)),
               high = std::asin(std::clamp(impact + reach * width, -1.0, 1.0));
  if (high <= low) return 0;
  double sum = 0, moment = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = low + (high - low) * (i + 0.5) / steps, u = (std::sin(t) - impact) / width;
    const double light = std::exp(-0.5 * u * u) * std::cos(t) * (lambert ? std::cos(t) : 1.0);
    sum += light, moment += light * std::cos(t);
  }
  return sum > 0 ? moment / sum : 0;
}

// Depth by width, then by impact squared.
std::vector<double> make_table(bool lambert) {
  std::vector<double> table;
  table.reserve((width_steps + 1) * (impact_steps + 1));
  for (int w = 0; w <= width_steps; ++w)
    for (int q = 0; q <= impact_steps; ++q)
      table.push_back(w == 0 ? ray_depth(q * impact_step)
                             : mean_depth(std::sqrt(q * impact_step), w * width_step, lambert));
  return table;
}

}  // namespace

const std::vector<double>& depth_table() {
  static const std::vector<double> table = make_table(true);
  return table;
}

const std::vector<double>& scattered_depth_table() {
  static const std::vector<double> table = make_table(false);
  return table;
}

}  // namespace bole::stems
