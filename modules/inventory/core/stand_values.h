// What a plot says beyond sums of diameters: heights of all stems, stem volume, and how certain all of it is.
#pragma once

#include <optional>
#include <vector>

#include "inventory/core/height_curve.h"

namespace bole::inventory {

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

// What a stem contributes to heights and volume. NaN where not known.
struct StemValues {
  double height_m = 0;        // of its top, else by the curve
  bool by_curve = false;      // the height is that of the curve
  double curve_height_m = 0;  // by the curve, for residuals; NaN without a curve and outside its diameters
  double volume_m3 = 0;
  double volume_half_m3 = 0;  // half width of the 95 % interval: diameter, height of the curve, form
  bool own_volume = false;    // by its own stem curve
};

struct StandValues {
  std::vector<StemValues> by_stem;  // in the order of the stems given
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

}  // namespace bole::inventory
