#include "survey/core/georeference/place_trees.h"

#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "cloud/table_columns.h"

namespace bole::survey {

std::vector<double> own_standard_errors(const Table& stems, double map_sd_m) {
  const auto low = numbers_or_nan(stems, "dbh_lo_cm"), high = numbers_or_nan(stems, "dbh_hi_cm"),
             spread = numbers_or_nan(stems, "pass_spread_cm"), passes = numbers_or_nan(stems, "passes");
  std::vector<double> all;
  constexpr double halves_in_interval = 2 * 1.96, cm = 0.01;
  for (std::size_t i = 0; i < stems.rows(); ++i) {
    double variance = map_sd_m * map_sd_m;
    // The centre of a circle is known about as well as its radius.
    if (const double radius_se = cm * (high[i] - low[i]) / 2 / halves_in_interval; std::isfinite(radius_se))
      variance += radius_se * radius_se;
    if (std::isfinite(spread[i]) && passes[i] > 1) variance += cm * cm * spread[i] * spread[i] / passes[i];
    all.push_back(std::sqrt(variance));
  }
  return all;
}

Table with_places(const Table& table, const Georeference& place, const std::vector<double>* own_se_m) {
  const auto x = table.numbers("x_m"), y = table.numbers("y_m"), z = numbers_or_nan(table, "z_m");
  std::vector<double> easting(x.size(), no_number), northing = easting, elevation = easting, se = easting;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i] + y[i])) continue;
    const bool has_z = std::isfinite(z[i]);
    const Eigen::Vector3d local(x[i], y[i], has_z ? z[i] : place.frame.centre_local.z());
    const Eigen::Vector3d global = place.frame.to_global(local);
    easting[i] = global.x();
    northing[i] = global.y();
    if (has_z) elevation[i] = global.z();
    if (own_se_m != nullptr) se[i] = std::hypot((*own_se_m)[i], place.uncertainty.at(local));
  }
  Table out = table;
  out.set("easting_m", std::move(easting));
  out.set("northing_m", std::move(northing));
  if (own_se_m != nullptr) out.set("position_se_m", std::move(se));
  if (place.frame.heights_known) out.set("elevation_m", std::move(elevation));
  set_facts(out.facts, place.frame);
  return out;
}

}  // namespace bole::survey
