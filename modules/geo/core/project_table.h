// Positions of a table between degrees and metres.
#pragma once

#include <string>

#include "base/option.h"
#include "base/report.h"
#include "cloud/table.h"
#include "geo/core/transverse_mercator.h"

namespace bole::geo {

struct ProjectOptions {
  std::string direction = "to_plane";
  std::string plane = "gauss_krueger_3";
  std::string ellipsoid = "GRS80";
  int zone = 0;
  bool south = false;
  bool zone_prefix = false;
  double central_meridian_deg = 114;
  double scale = 1;
  double false_easting_m = 500'000;
  double false_northing_m = 0;
  double latitude_of_origin_deg = 0;
};

const OptionTable& option_table(const ProjectOptions*);

struct Projected {
  Table table;
  Report report;
};

// "to_plane": adds x_m (easting) and y_m (northing) to a table with latitude_deg and longitude_deg; all rows get the
// plane of the mean longitude when no zone is named. "to_geodetic": the reverse. Facts `axes` = global and `crs` = WKT
// go with the table to the plane. Rows with missing numbers stay missing and are counted. Throws Error{bad_input}.
Projected project_table(const Table& table, const ProjectOptions& options);

}  // namespace bole::geo
