#include "inventory/core/height_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/no_number.h"
#include "inventory/core/measures.h"

namespace bole::inventory {
namespace {

constexpr std::size_t min_heights = 8;

std::optional<HeightCurve> fit_once(const std::vector<SizedStem>& stems, double breast_height_m) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rhs = Eigen::Vector2d::Zero();
  HeightCurve c;
  c.breast_height_m = breast_height_m;
  c.min_dbh_cm = std::numeric_limits<double>::infinity();
  for (const auto& s : stems) {
    const Eigen::Vector2d j(1, s.dbh_cm);
    normal += j * j.transpose();
    rhs += s.dbh_cm / std::sqrt(s.height_m - breast_height_m) * j;
    c.min_dbh_cm = std::min(c.min_dbh_cm, s.dbh_cm);
    c.max_dbh_cm = std::max(c.max_dbh_cm, s.dbh_cm);
  }
  c.trees = stems.size();
  if (c.trees < min_heights || c.max_dbh_cm - c.min_dbh_cm < 2) return std::nullopt;
  const Eigen::Vector2d x = normal.ldlt().solve(rhs);
  c.a = x[0];
  c.b = x[1];
  if (!(c.a > 0) || !(c.b > 0)) return std::nullopt;  // it would fall, or rise without end
  double squares = 0;
  for (const auto& s : stems) squares += std::pow(c.height_m(s.dbh_cm) - s.height_m, 2);
  c.rmse_m = std::sqrt(squares / static_cast<double>(c.trees - 2));
  return c;
}

}  // namespace

double HeightCurve::height_m(double d) const {
  if (!(d >= 0.8 * min_dbh_cm && d <= 1.25 * max_dbh_cm)) return no_number;
  return breast_height_m + d * d / ((a + b * d) * (a + b * d));
}

std::optional<HeightCurve> fit_height_curve(const std::vector<SizedStem>& stems, double breast_height_m) {
  std::vector<SizedStem> seen;
  for (const auto& s : stems)
    if (s.height_m > breast_height_m + 0.5 && s.dbh_cm > 0) seen.push_back(s);
  auto curve = fit_once(seen, breast_height_m);
  if (!curve) return curve;
  const std::size_t all = seen.size();
  std::erase_if(
      seen, [&](const SizedStem& s) { return std::abs(curve->height_m(s.dbh_cm) - s.height_m) > 3 * curve->rmse_m; });
  if (seen.size() == all) return curve;
  curve = fit_once(seen, breast_height_m);
  if (curve) curve->left_out = all - seen.size();
  return curve;
}

double form_volume_m3(double dbh_cm, double height_m, double breast_height_m) {
  constexpr double power = 1.5;
  return height_m > breast_height_m
             ? basal_area_m2(dbh_cm) * height_m / (power + 1) * std::pow(height_m / (height_m - breast_height_m), power)
             : no_number;
}

}  // namespace bole::inventory
