#include "rows/core/rows/line_fit.h"

#include <cmath>
#include <numbers>

#include "base/no_number.h"

namespace bole::rows {
namespace {

struct Moments {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double xx = 0, xy = 0, yy = 0;
};

Moments moments_of(const Points2& points) {
  Moments m;
  for (const auto& p : points) m.mean += p / static_cast<double>(points.size());
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - m.mean;
    m.xx += d.x() * d.x();
    m.xy += d.x() * d.y();
    m.yy += d.y() * d.y();
  }
  return m;
}

}  // namespace

double row_angle(double angle_rad) {
  const double a = std::remainder(angle_rad, std::numbers::pi);
  return a <= -std::numbers::pi / 2 ? a + std::numbers::pi : a;
}

double row_angle_difference(double a_rad, double b_rad) {
  return std::abs(std::remainder(a_rad - b_rad, std::numbers::pi));
}

LineFit fit_orthogonal(const Points2& points) {
  const auto m = moments_of(points);
  LineFit fit{m.mean, no_number, no_number, 0};
  if (!(m.xx + m.yy > 0)) return fit;
  fit.angle_rad = row_angle(0.5 * std::atan2(2 * m.xy, m.xx - m.yy));
  const double half = (m.xx + m.yy) / 2, root = std::hypot((m.xx - m.yy) / 2, m.xy);
  const double along = half + root, across = std::max(0.0, half - root);
  const auto n = static_cast<double>(points.size());
  fit.rms_m = std::sqrt(across / n);
  if (points.size() > 2) fit.angle_se_rad = std::sqrt(across / (n - 2) / along);
  return fit;
}

LineFit fit_least_squares(const Points2& points) {
  const auto m = moments_of(points);
  LineFit fit{m.mean, no_number, no_number, 0};
  if (!(m.xx + m.yy > 0)) return fit;
  const bool eastward = m.xx >= m.yy;
  const double along = eastward ? m.xx : m.yy, across = eastward ? m.yy : m.xx;
  const double a = m.xy / along, square_sum = std::max(0.0, across - a * m.xy);
  const auto n = static_cast<double>(points.size());
  fit.angle_rad = row_angle(eastward ? std::atan(a) : std::numbers::pi / 2 - std::atan(a));
  fit.rms_m = std::sqrt(square_sum / n / (1 + a * a));
  if (points.size() > 2) fit.angle_se_rad = std::sqrt(square_sum / (n - 2) / along) / (1 + a * a);
  return fit;
}

}  // namespace bole::rows
