#include "report/core/stand_values.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bole::report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double z_95 = 1.959964, shared_part = 0.25;
constexpr std::size_t least_heights = 8;

double basal_area_m2(double dbh_cm) { return std::numbers::pi / 40000 * dbh_cm * dbh_cm; }

std::optional<HeightCurve> fit_once(const std::vector<SizedStem>& stems, double breast_height_m) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rhs = Eigen::Vector2d::Zero();
  HeightCurve c;
  c.breast_height_m = breast_height_m;
  c.least_dbh_cm = std::numeric_limits<double>::infinity();
  for (const auto& s : stems) {
    const Eigen::Vector2d j(1, s.dbh_cm);
    normal += j * j.transpose(), rhs += s.dbh_cm / std::sqrt(s.height_m - breast_height_m) * j;
    c.least_dbh_cm = std::min(c.least_dbh_cm, s.dbh_cm), c.most_dbh_cm = std::max(c.most_dbh_cm, s.dbh_cm);
  }
  c.trees = stems.size();
  if (c.trees < least_heights || c.most_dbh_cm - c.least_dbh_cm < 2) return std::nullopt;
  const Eigen::Vector2d x = normal.ldlt().solve(rhs);
  c.a = x[0], c.b = x[1];
  if (!(c.a > 0) || !(c.b > 0)) return std::nullopt;  // it would fall, or rise without end
  double squares = 0;
  for (const auto& s : stems) squares += std::pow(c.height_m(s.dbh_cm) - s.height_m, 2);
  c.rmse_m = std::sqrt(squares / static_cast<double>(c.trees - 2));
  return c;
}

// Of a sum of values whose standard deviations are `sd`, partly shared.
class Spread {
 public:
  void add(double sd) { own_ += (1 - shared_part * shared_part) * sd * sd, shared_ += shared_part * sd; }
  double half() const { return z_95 * std::sqrt(own_ + shared_ * shared_); }

 private:
  double own_ = 0, shared_ = 0;
};

// Root mean square of sd / DBH where an interval is known; NaN where none is.
double usual_relative_sd(const std::vector<SizedStem>& stems) {
  double squares = 0;
  std::size_t known = 0;
  for (const auto& s : stems)
    if (const double relative = s.dbh_sd_cm / s.dbh_cm; std::isfinite(relative))
      squares += relative * relative, ++known;
  return known > 0 ? std::sqrt(squares / static_cast<double>(known)) : nan;
}

}  // namespace

double HeightCurve::height_m(double d) const {
  if (!(d >= 0.8 * least_dbh_cm && d <= 1.25 * most_dbh_cm)) return nan;
  return breast_height_m + d * d / ((a + b * d) * (a + b * d));
}

std::optional<HeightCurve> fit_height_curve(const std::vector<SizedStem>& stems, double breast_height_m) {
  std::vector<SizedStem> seen;
  for (const auto& s : stems)
    if (s.height_m > breast_height_m + 0.5 && s.dbh_cm > 0) seen.push_back(s);
  auto curve = fit_once(seen, breast_height_m);
  if (!curve) return curve;
  std::erase_if(
      seen, [&](const SizedStem& s) { return std::abs(curve->height_m(s.dbh_cm) - s.height_m) > 3 * curve->rmse_m; });
  return seen.size() == curve->trees ? curve : fit_once(seen, breast_height_m);
}

double form_volume_m3(double dbh_cm, double height_m, double breast_height_m) {
  constexpr double power = 1.5;
  return height_m > breast_height_m
             ? basal_area_m2(dbh_cm) * height_m / (power + 1) * std::pow(height_m / (height_m - breast_height_m), power)
             : nan;
}

StandValues stand_values(const std::vector<SizedStem>& stems, const StandAssumptions& assumed) {
  StandValues v;
  v.curve = fit_height_curve(stems, assumed.breast_height_m);
  Spread area, volume, squares;
  double weighted = 0, heights = 0, basal_area = 0, area_squares = 0, volume_squares = 0, sum_d2 = 0, by_form_m3 = 0;
  const double usual = usual_relative_sd(stems);
  for (const auto& s : stems) {
    const bool has_interval = std::isfinite(s.dbh_sd_cm);
    const double g = basal_area_m2(s.dbh_cm), relative = has_interval ? s.dbh_sd_cm / s.dbh_cm : usual;
    v.no_interval += !has_interval;
    double height = s.height_m;
    const bool by_curve = !std::isfinite(height);
    if (by_curve && v.curve) height = v.curve->height_m(s.dbh_cm), v.by_curve += std::isfinite(height);
    const bool own = std::isfinite(s.volume_m3);
    const double m3 = own ? s.volume_m3 : form_volume_m3(s.dbh_cm, height, assumed.breast_height_m);
    v.own_volume += own, by_form_m3 += own ? 0 : m3;
    basal_area += g, weighted += g * height, heights += height, v.volume_m3 += m3, sum_d2 += s.dbh_cm * s.dbh_cm;
    area_squares += g * g, volume_squares += m3 * m3;
    area.add(2 * g * relative), squares.add(s.dbh_cm * s.dbh_cm * relative);
    volume.add(m3 * std::hypot(2 * relative, by_curve && v.curve ? v.curve->rmse_m / height : 0));
  }
  const auto n = static_cast<double>(stems.size());
  v.mean_height_m = heights / n, v.lorey_height_m = weighted / basal_area;
  v.stems = {nan, z_95 * std::sqrt(n)};
  v.basal_area_m2 = {area.half(), z_95 * std::sqrt(area_squares)};
  v.volume_m3_half = {std::hypot(volume.half(), z_95 * assumed.form_sd_pct / 100 * by_form_m3),
                      z_95 * std::sqrt(volume_squares)};
  v.quadratic_mean_dbh_half_cm = squares.half() / std::sqrt(n * sum_d2);
  return v;
}

}  // namespace bole::report
