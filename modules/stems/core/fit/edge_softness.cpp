#include "stems/core/fit/edge_softness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bole::stems {
namespace {

constexpr double bin_m = 0.004, beyond_m = 0.08, inner_share = 0.4;
constexpr std::size_t min_rays = 150;
constexpr double min_edge_contrast = 3;  // of the plateau to what lies beyond the edge

// Distribution of the normal, from a table: it is asked for some 50 000 times per stem.
class NormalBelow {
 public:
  NormalBelow() {
    for (std::size_t i = 0; i < values_.size(); ++i)
      values_[i] = 0.5 * std::erfc(-(static_cast<double>(i) * step - reach) * std::numbers::sqrt2 / 2);
  }
  double operator()(double x) const {
    const double at = (std::clamp(x, -reach, reach - 1e-9) + reach) / step;
    const auto i = static_cast<std::size_t>(at);
    return values_[i] + (at - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
  }

 private:
  static constexpr double reach = 5, step = 0.02;
  std::array<double, 502> values_{};
};

double normal_below(double x) {
  static const NormalBelow distribution;
  return distribution(x);
}

// Share of the plateau at a distance from the axis, of an edge on either side.
double plateau(double impact, double edge, double softness) {
  return normal_below((edge - impact) / softness) + normal_below((edge + impact) / softness) - 1;
}

struct Line {
  double plateau = 0, background = 0, misfit = std::numeric_limits<double>::infinity();
};

// Least squares of counts by the shape and a constant, neither negative.
Line best_line(const std::vector<double>& counts, const std::vector<double>& shape) {
  double n = 0, s = 0, ss = 0, c = 0, sc = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    n += 1, s += shape[i], ss += shape[i] * shape[i], c += counts[i], sc += shape[i] * counts[i];
  const double det = n * ss - s * s;
  Line line;
  if (!(det > 1e-9 * n * ss)) return line;
  line.plateau = (n * sc - s * c) / det, line.background = (c - line.plateau * s) / n;
  if (line.background < 0) line.background = 0, line.plateau = sc / ss;
  line.misfit = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double off = counts[i] - line.plateau * shape[i] - line.background;
    line.misfit += off * off;
  }
  return line;
}

}  // namespace

double edge_softness_m(const std::vector<double>& impact_m, double radius_m) {
  const double from = inner_share * radius_m;
  std::vector<double> counts(static_cast<std::size_t>((radius_m + beyond_m - from) / bin_m), 0.0), shape(counts.size());
  std::size_t rays = 0;
  for (const double u : impact_m)
    if (const double at = (u - from) / bin_m; at >= 0 && at < static_cast<double>(counts.size()))
      counts[static_cast<std::size_t>(at)] += 1, ++rays;
  if (rays < min_rays) return 0;
  Line best;
  double softness_m = 0;
  for (double soft = 0.001; soft < 0.06; soft *= 1.12)
    for (double edge = 0.7 * radius_m; edge < radius_m + 0.03; edge += 0.002) {
      for (std::size_t i = 0; i < shape.size(); ++i)
        shape[i] = plateau(from + (static_cast<double>(i) + 0.5) * bin_m, edge, soft);
      const Line line = best_line(counts, shape);
      if (line.misfit < best.misfit) best = line, softness_m = soft;
    }
  return best.plateau > min_edge_contrast * best.background ? softness_m : 0;
}

}  // namespace bole::stems
