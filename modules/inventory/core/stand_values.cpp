#include "inventory/core/stand_values.h"

#include <cmath>

#include "base/no_number.h"
#include "inventory/core/measures.h"

namespace bole::inventory {
namespace {

// This part of the standard deviation of each diameter points the same way in all stems of a plot.
constexpr double shared_part = 0.25;

// Of a sum of values whose standard deviations are `sd`, partly shared.
class Spread {
 public:
  void add(double sd) {
    own_ += (1 - shared_part * shared_part) * sd * sd;
    shared_ += shared_part * sd;
  }
  double half() const { return z_95 * std::sqrt(own_ + shared_ * shared_); }

 private:
  double own_ = 0, shared_ = 0;
};

// Root mean square of sd / DBH where an interval is known; NaN where none is.
double usual_relative_sd(const std::vector<SizedStem>& stems) {
  double squares = 0;
  std::size_t known = 0;
  for (const auto& s : stems)
    if (const double relative = s.dbh_sd_cm / s.dbh_cm; std::isfinite(relative)) {
      squares += relative * relative;
      ++known;
    }
  return known > 0 ? std::sqrt(squares / static_cast<double>(known)) : no_number;
}

}  // namespace

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
    if (by_curve && v.curve) {
      height = v.curve->height_m(s.dbh_cm);
      v.by_curve += std::isfinite(height);
    }
    const bool own = std::isfinite(s.volume_m3);
    const double m3 = own ? s.volume_m3 : form_volume_m3(s.dbh_cm, height, assumed.breast_height_m);
    v.own_volume += own;
    by_form_m3 += own ? 0 : m3;
    basal_area += g;
    weighted += g * height;
    heights += height;
    v.volume_m3 += m3;
    sum_d2 += s.dbh_cm * s.dbh_cm;
    area_squares += g * g;
    volume_squares += m3 * m3;
    area.add(2 * g * relative);
    squares.add(s.dbh_cm * s.dbh_cm * relative);
    volume.add(m3 * std::hypot(2 * relative, by_curve && v.curve ? v.curve->rmse_m / height : 0));
  }
  const auto n = static_cast<double>(stems.size());
  v.mean_height_m = heights / n;
  v.lorey_height_m = weighted / basal_area;
  v.stems = {no_number, z_95 * std::sqrt(n)};
  v.basal_area_m2 = {area.half(), z_95 * std::sqrt(area_squares)};
  v.volume_m3_half = {std::hypot(volume.half(), z_95 * assumed.form_sd_pct / 100 * by_form_m3),
                      z_95 * std::sqrt(volume_squares)};
  v.quadratic_mean_dbh_half_cm = squares.half() / std::sqrt(n * sum_d2);
  return v;
}

}  // namespace bole::inventory
