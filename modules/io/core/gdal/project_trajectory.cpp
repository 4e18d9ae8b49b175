#include "io/core/gdal/project_trajectory.h"

#include <ogr_spatialref.h>

#include <memory>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/gdal/gdal_support.h"
#include "io/core/tables/named_trajectory.h"

namespace bole::io {

void project_trajectory(Trajectory& trajectory, const std::string& crs) {
  const gdal::Errors errors;
  OGRSpatialReference from, to;
  if (from.SetFromUserInput(geographic_crs) != OGRERR_NONE)
    throw failure("the coordinate system " + std::string(geographic_crs) + " is not available: " + errors.last(),
                  "the database of PROJ");
  if (to.SetFromUserInput(crs.c_str()) != OGRERR_NONE || !to.IsProjected())
    throw bad_input("option crs is '" + crs.substr(0, 120) + "'",
                    "a projected coordinate system, for instance EPSG:25832");
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> change(OGRCreateCoordinateTransformation(&from, &to));
  if (!change) throw bad_input("the path cannot be projected to '" + crs.substr(0, 120) + "': " + errors.last());
  for (auto& pose : trajectory.poses) {
    Eigen::Vector3d p = pose.T_target_sensor.translation();
    if (!change->Transform(1, &p.x(), &p.y(), &p.z()) || !p.allFinite())
      throw bad_input("the path cannot be projected to '" + crs.substr(0, 120) + "': " + errors.last(),
                      "a coordinate system of the place where it was walked");
    pose.T_target_sensor.translation() = p;
  }
  trajectory.axes = Axes::global;
  set_fact(trajectory.facts, facts::crs, crs);
}

}  // namespace bole::io
