#include "io/core/las/crs_unit.h"

#include <cpl_error.h>
#include <ogr_spatialref.h>

namespace bole::io::las {

std::optional<double> metres_per_crs_unit(const std::string& wkt) {
  if (wkt.empty()) return 1;
  OGRSpatialReference crs;
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const bool known = crs.importFromWkt(wkt.c_str()) == OGRERR_NONE;
  const double metres = known ? crs.GetLinearUnits(nullptr) : 1;
  const bool in_degrees = known && crs.IsGeographic() != 0;
  CPLPopErrorHandler();
  if (in_degrees) return {};
  return metres;
}

}  // namespace bole::io::las
