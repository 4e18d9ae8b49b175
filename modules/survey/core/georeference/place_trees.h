// Global coordinates of the rows of a table, with their uncertainty.
#pragma once

#include "cloud/table.h"
#include "survey/core/georeference/georeference.h"

namespace bole::survey {

// Standard error of each coordinate of a stem in the map: of a place in the map (map_sd), of the fitted circle (half
// the interval of the diameter), and of the mean of its passes. A stem without these numbers has map_sd.
std::vector<double> own_standard_errors(const Table& stems, double map_sd_m);

// Adds easting_m, northing_m and, where heights are known, elevation_m; the frame becomes a fact. x_m, y_m and z_m stay
// as they are. With `own_se_m` also position_se_m: root mean square of the standard errors of easting and northing,
// from the place in the map and from the frame.
Table with_places(const Table& table, const Georeference& place, const std::vector<double>* own_se_m);

}  // namespace bole::survey
