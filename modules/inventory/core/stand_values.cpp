#include "inventory/core/stand_values.h"

#include <cmath>

#include "base/no_number.h"
#include "base/statistics.h"
#include "inventory/core/measures.h"

namespace bole::inventory {
namespace {

// This part of the standard deviation of each diameter points the same way in all stems of a plot.
constexpr double shared_part = 0.25;

// Of a sum of values whose standard deviations are `sd`, partly shared.
class Spread {
 public:
  // `one_way` is how far the value can be off in the direction that all stems share.
  void add(double sd, double one_way) {
    own_ += (1 - shared_part * shared_part) * sd * sd;
    shared_ += shared_part * sd;
    one_way_ += one_way;
  }
  double half() const { return z_95 * std::sqrt(own_ + shared_ * shared_) + one_way_; }

 private:
  double own_ = 0, shared_ = 0, one_way_ = 0;
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

// Of a volume, without the form that all stems share.
double own_relative_sd(const StemValues& stem, double diameter_relative_sd, const std::optional<HeightCurve>& curve) {
  return std::hypot(2 * diameter_relative_sd, stem.by_curve ? curve->rmse_m / stem.height_m : 0);
}

StemValues values_of(const SizedStem& s, double diameter_relative_sd, const std::optional<HeightCurve>& curve,
                     const StandAssumptions& assumed) {
  StemValues v;
  v.curve_height_m = curve ? curve->height_m(s.dbh_cm) : no_number;
  v.by_curve = !std::isfinite(s.height_m) && std::isfinite(v.curve_height_m);
  v.height_m = v.by_curve ? v.curve_height_m : s.height_m;
  v.own_volume = std::isfinite(s.volume_m3);
  v.volume_m3 = v.own_volume ? s.volume_m3 : form_volume_m3(s.dbh_cm, v.height_m, assumed.breast_height_m);
  v.volume_half_m3 =
      z_95 * v.volume_m3 *
          std::hypot(own_relative_sd(v, diameter_relative_sd, curve), v.own_volume ? 0 : assumed.form_sd_pct / 100) +
      2 * v.volume_m3 * s.dbh_too_large_cm / s.dbh_cm;
  return v;
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
    const StemValues stem = values_of(s, relative, v.curve, assumed);
    v.by_curve += stem.by_curve;
    v.own_volume += stem.own_volume;
    by_form_m3 += stem.own_volume ? 0 : stem.volume_m3;
    const double height = stem.height_m, m3 = stem.volume_m3;
    basal_area += g;
    weighted += g * height;
    heights += height;
    v.volume_m3 += m3;
    sum_d2 += s.dbh_cm * s.dbh_cm;
    area_squares += g * g;
    volume_squares += m3 * m3;
    const double one_way = s.dbh_too_large_cm / s.dbh_cm;
    area.add(2 * g * relative, 2 * g * one_way);
    squares.add(s.dbh_cm * s.dbh_cm * relative, s.dbh_cm * s.dbh_cm * one_way);
    volume.add(m3 * own_relative_sd(stem, relative, v.curve), 2 * m3 * one_way);
    v.by_stem.push_back(stem);
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
