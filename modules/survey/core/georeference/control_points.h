// Control points: places of known coordinates, and where they are in the map.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/report.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "geo/core/projected_crs.h"
#include "survey/core/georeference/georeference_options.h"

namespace bole::survey {

struct ControlPoint {
  std::string name;
  Eigen::Vector3d local = Eigen::Vector3d::Zero();   // z NaN where the map does not give it
  Eigen::Vector3d global = Eigen::Vector3d::Zero();  // easting, northing, height; height NaN where it is not given
  double sd_m = 0, height_sd_m = 0;                  // of the control point alone; NaN: not stated in the file
};

// Where the points may lie in the map.
struct LocalPlaces {
  const Table* targets = nullptr;  // name, x_m, y_m, z_m; null: none
  const Raster* dem = nullptr;     // heights of the ground; null: none
};

// The system of the options; left open, that of the data (`data_crs_wkt`), or the UTM zone of latitudes and longitudes.
// Throws Error{bad_input} where none of the three is there, or the file names another one.
geo::ProjectedCrs control_crs(const Table& control, const GeoreferenceOptions& options,
                              const std::string& data_crs_wkt);

// Rows without a place in the map or without coordinates are left out with a finding. Throws Error{bad_input} where
// columns are missing, a name occurs twice, coordinates are exchanged (easting and northing, latitude and longitude),
// lie in another zone or have the zone before the easting, or belong to another datum.
std::vector<ControlPoint> control_points(const Table& control, const LocalPlaces& places, const geo::ProjectedCrs& crs,
                                         const GeoreferenceOptions& options, Report& report);

// Easting and northing of every row, projected where the table has degrees; NaN where the row has no coordinates.
// `names` are for messages. Throws as control_points().
std::vector<Eigen::Vector2d> plan_coordinates(const Table& table, const geo::ProjectedCrs& crs,
                                              const std::vector<std::string>& names);

// The centre of the options as a table with one row named centre.
Table centre_as_table(const GeoreferenceOptions& options);

// Distances between control points that no turn and shift brings to those in the map, by orders: other zones, other
// units. Throws Error{bad_input}.
void check_distances(const std::vector<ControlPoint>& points);

}  // namespace bole::survey
