// Heights and volumes of stems whose top or stem curve was not measured: by their diameter, and by a stem form.
#pragma once

#include <optional>
#include <vector>

#include "cloud/breast_height.h"

namespace bole::inventory {

// Height by diameter (Näslund): h = b.h. + d² / (a + b d)², b.h. being breast height.
struct HeightCurve {
  double breast_height_m = usual_breast_height_m;
  double a = 0, b = 0;
  double rmse_m = 0;  // of the heights it was fitted to, with n - 2
  std::size_t trees = 0;
  std::size_t left_out = 0;               // heights too far off the curve
  double min_dbh_cm = 0, max_dbh_cm = 0;  // of those trees

  // NaN for diameters outside 0.8 of the least to 1.25 of the greatest: the curve is not carried further.
  double height_m(double dbh_cm) const;
};

struct SizedStem {
  double dbh_cm = 0;
  double dbh_sd_cm = 0;  // NaN where no interval is known, as for diameters taped by hand
  double height_m = 0;   // of a top that was seen, else NaN
  double volume_m3 = 0;  // by its own stem curve, else NaN
  // By so much the interval reaches further down than up: an error that points the same way in all stems.
  double dbh_too_large_cm = 0;
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

}  // namespace bole::inventory
