#include "stems/core/fit/beam_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace bole::stems {
namespace {

constexpr int impact_steps = 320, width_steps = 60;
constexpr double impact_step = max_lit_impact2 / impact_steps, width_step = max_lit_width / width_steps;

// Mean depth by the substitution x = sin(t): the cosine of incidence is cos(t), and so is the depth.
double mean_depth(double impact, double width) {
  constexpr int steps = 200;
  constexpr double reach = 5;
  const double low = std::asin(std::clamp(impact - reach * width, -1.0, 1.0)),
               high = std::asin(std::clamp(impact + reach * width, -1.0, 1.0));
  if (high <= low) return 0;
  double sum = 0, moment = 0;
  for (int i = 0; i < steps; ++i) {
    const double t = low + (high - low) * (i + 0.5) / steps, u = (std::sin(t) - impact) / width;
    const double light = std::exp(-0.5 * u * u) * std::cos(t) * std::cos(t);
    sum += light, moment += light * std::cos(t);
  }
  return sum > 0 ? moment / sum : 0;
}

double ray_depth(double impact2) { return std::sqrt(std::max(0.0, 1 - impact2)); }

// Depth by width, then by impact squared.
std::vector<double> make_table() {
  std::vector<double> table;
  table.reserve((width_steps + 1) * (impact_steps + 1));
  for (int w = 0; w <= width_steps; ++w)
    for (int q = 0; q <= impact_steps; ++q)
      table.push_back(w == 0 ? ray_depth(q * impact_step) : mean_depth(std::sqrt(q * impact_step), w * width_step));
  return table;
}

}  // namespace

LitDepth lit_depth(double impact2, double width) {
  if (width <= 0) {
    const double depth = ray_depth(impact2);
    return {depth, depth > 0 ? -0.5 / depth : 0, 0};
  }
  static const std::vector<double> table = make_table();
  constexpr double by_impact_step = 1 / impact_step, by_width_step = 1 / width_step;
  const double q = std::clamp(impact2 * by_impact_step, 0.0, impact_steps - 1e-9),
               w = std::min(width * by_width_step, width_steps - 1e-9);
  const auto iq = static_cast<std::size_t>(q), iw = static_cast<std::size_t>(w);
  const double fq = q - static_cast<double>(iq), fw = w - static_cast<double>(iw);
  const auto* low = table.data() + iw * (impact_steps + 1) + iq;
  const auto* high = low + impact_steps + 1;
  const double a = low[0] + fq * (low[1] - low[0]), b = high[0] + fq * (high[1] - high[0]);
  return {a + fw * (b - a), ((1 - fw) * (low[1] - low[0]) + fw * (high[1] - high[0])) * by_impact_step,
          (b - a) * by_width_step};
}

}  // namespace bole::stems
