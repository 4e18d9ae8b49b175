// Positions of a table between degrees and metres.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "cloud/table.h"
#include "geo/core/transverse_mercator.h"

namespace bole::geo {

enum class ProjectDirection { to_plane, to_geodetic };
constexpr std::array<std::string_view, 2> choice_names(ProjectDirection) { return {"to_plane", "to_geodetic"}; }

enum class PlaneKind { gauss_krueger_3, gauss_krueger_6, utm, transverse_mercator };
constexpr std::array<std::string_view, 4> choice_names(PlaneKind) {
  return {"gauss_krueger_3", "gauss_krueger_6", "utm", "transverse_mercator"};
}

struct ProjectOptions {
  ProjectDirection direction = ProjectDirection::to_plane;
  PlaneKind plane = PlaneKind::gauss_krueger_3;
  EllipsoidName ellipsoid = EllipsoidName::grs80;
  std::optional<int> zone;  // left open: that of the mean longitude
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

// to_plane: adds x_m (easting), y_m (northing) and convergence_deg (bearing of grid north from true north) to a table
// with latitude_deg and longitude_deg. All rows get the plane of the mean longitude when no zone is given. A table
// without degrees that has x_m and y_m stays as it is. to_geodetic: the reverse. Facts `axes` = global and `crs` = WKT
// go with the table to the plane. Rows with missing numbers stay missing and are counted. Throws Error{bad_input}.
Projected project_table(const Table& table, const ProjectOptions& options);

}  // namespace bole::geo
