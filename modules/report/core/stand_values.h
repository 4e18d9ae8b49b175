// What a plot says beyond sums of diameters: heights by diameter, stem volume, and how sure all of it is.
#pragma once

#include <optional>
#include <vector>

#include "cloud/breast_height.h"

namespace bole::report {

// Height by diameter (Näslund): h = b.h. + d² / (a + b d)², b.h. being breast height.
struct HeightCurve {
  double breast_height_m = usual_breast_height_m;
  double a = 0, b = 0;
  double rmse_m = 0;  // of the heights it was fitted to
  std::size_t trees = 0;
  double least_dbh_cm = 0, most_dbh_cm = 0;  // of those trees

  // NaN for diameters outside 0.8 of the least to 1.25 of the greatest: the curve is not carried further.
  double height_m(double dbh_cm) const;
};

struct SizedStem {
  double dbh_cm = 0;
  double dbh_sd_cm = 0;  // NaN where no interval is known, as for diameters taped by hand
  double height_m = 0;   // of a top that was seen, else NaN
  double volume_m3 = 0;  // by its own stem curve, else NaN
};

// Least squares of d / sqrt(h - b.h.) over d, once more without heights off by over 3 standard deviations. Nothing with
// fewer than 8 heights, diameters all alike, or a curve that falls.
std::optional<HeightCurve> fit_height_curve(const std::vector<SizedStem>& stems,
                                            double breast_height_m = usual_breast_height_m);

// Volume over bark, ground to tip, of a stem through breast height and top whose cross section shrinks with the power
// 1.5 of the distance from the top, half way between a paraboloid (1) and a cone (2): g h^2.5 / (2.5 (h - b.h.)^1.5), g
// the basal area. Form factor of Scots pine of 31 cm and 15 m: 0.458; by the tables of the Spanish inventory 0.436, a
// paraboloid has 0.547.
double form_volume_m3(double dbh_cm, double height_m, double breast_height_m = usual_breast_height_m);

// Half widths of 95 % intervals. `measured`: how well this plot was measured. Errors of diameters are partly shared by
// the stems of a plot: a quarter of the standard deviation of each is taken to point the same way in all (on simulated
// plots the mean error of a plot scatters by a quarter of the error of a stem). Stems without an interval are taken to
// be as unsure as the others are on average (root mean square of sd / DBH): a tape does better, so this is careful.
// Volumes by form_volume_m3 add its form: no table of the species here was asked, and the stems of a plot share the
// error (StandAssumptions). `sampled`: how well the plot stands for
// a stand whose trees stand at random (Poisson): +-1.96 sqrt(sum of squared values). NaN where not known.
struct HalfWidths {
  double measured = 0, sampled = 0;
};

struct StandValues {
  std::optional<HeightCurve> curve;
  std::size_t by_curve = 0;     // stems whose height is that of the curve
  double mean_height_m = 0;     // of all stems, seen tops and curve; NaN where a height is missing
  double lorey_height_m = 0;    // of all stems, as above
  double volume_m3 = 0;         // of all stems; NaN where a height is missing
  std::size_t own_volume = 0;   // stems with a volume by their own stem curve
  std::size_t no_interval = 0;  // stems whose diameter has no interval; all of them: no `measured` either
  HalfWidths stems, basal_area_m2, volume_m3_half;
  double quadratic_mean_dbh_half_cm = 0;
};

// What no stem of the plot tells. The form lies 4 to 5 % above the volumes by species table on the 16 plots of the
// Rioja field lists.
constexpr double usual_form_sd_pct = 5;
struct StandAssumptions {
  double breast_height_m = usual_breast_height_m;
  double form_sd_pct = usual_form_sd_pct;  // standard deviation of form_volume_m3, shared by all stems
};

StandValues stand_values(const std::vector<SizedStem>& stems, const StandAssumptions& assumed = {});

}  // namespace bole::report
