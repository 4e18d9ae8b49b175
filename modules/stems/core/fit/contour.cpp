#include "stems/core/fit/contour.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/statistics.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

constexpr int sectors = 36, min_sectors = 32, order = 4, terms = 1 + 2 * order;
constexpr std::size_t min_points = 3;
using Terms = Eigen::Matrix<double, terms, 1>;

Terms basis(double bearing) {
  Terms b;
  b[0] = 1;
  for (int k = 1; k <= order; ++k) b[2 * k - 1] = std::cos(k * bearing), b[2 * k] = std::sin(k * bearing);
  return b;
}

}  // namespace

std::optional<Contour> fit_contour(const std::vector<OutlinePoint>& points, double radius_m) {
  std::array<std::vector<double>, sectors> by_sector;
  for (const auto& p : points) {
    const auto k = static_cast<int>((p.bearing_rad / (2 * std::numbers::pi) + 1) * sectors) % sectors;
    by_sector[static_cast<std::size_t>(k)].push_back(p.deviation_m);
  }
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  Terms rhs = Terms::Zero();
  int seen = 0;
  for (int k = 0; k < sectors; ++k) {
    auto& values = by_sector[static_cast<std::size_t>(k)];
    if (values.size() < min_points) continue;
    ++seen;
    const Terms b = basis((k + 0.5) * 2 * std::numbers::pi / sectors);
    normal += b * b.transpose(), rhs += upper_median(values) * b;
  }
  if (seen < min_sectors) return std::nullopt;
  const Terms series = normal.ldlt().solve(rhs);

  constexpr int steps = 360;
  std::array<double, steps> radius;
  for (int i = 0; i < steps; ++i)
    radius[static_cast<std::size_t>(i)] = radius_m + series.dot(basis(2 * std::numbers::pi * i / steps));
  Contour out;
  double widest = 0, narrowest = 1e9, sum = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double a = radius[i], b = radius[(i + 1) % steps], turn = 2 * std::numbers::pi / steps;
    out.girth_m += std::sqrt(a * a + b * b - 2 * a * b * std::cos(turn));
    const double diameter = a + radius[(i + steps / 2) % steps];
    widest = std::max(widest, diameter), narrowest = std::min(narrowest, diameter), sum += diameter / steps;
  }
  if (!(narrowest > 0)) return std::nullopt;
  out.ovality = (widest - narrowest) / sum;
  return out;
}

}  // namespace bole::stems
