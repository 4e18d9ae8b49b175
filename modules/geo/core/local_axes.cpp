#include "geo/core/local_axes.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

namespace bole::geo {

class LocalAxes::Cartesian {
 public:
  GeographicLib::LocalCartesian axes;
};

LocalAxes::LocalAxes(const GeodeticPoint& origin, const Ellipsoid& ellipsoid) {
  check_geodetic(origin);
  const GeographicLib::Geocentric earth(ellipsoid.semi_major_m, ellipsoid.flattening());
  cartesian_ =
      std::make_unique<const Cartesian>(Cartesian{{origin.latitude_deg, origin.longitude_deg, origin.height_m, earth}});
}

LocalAxes::~LocalAxes() = default;
LocalAxes::LocalAxes(LocalAxes&&) noexcept = default;
LocalAxes& LocalAxes::operator=(LocalAxes&&) noexcept = default;

Eigen::Vector3d LocalAxes::to_enu(const GeodeticPoint& point) const {
  check_geodetic(point);
  Eigen::Vector3d enu;
  cartesian_->axes.Forward(point.latitude_deg, point.longitude_deg, point.height_m, enu.x(), enu.y(), enu.z());
  return enu;
}

GeodeticPoint LocalAxes::to_geodetic(const Eigen::Vector3d& enu) const {
  GeodeticPoint p;
  cartesian_->axes.Reverse(enu.x(), enu.y(), enu.z(), p.latitude_deg, p.longitude_deg, p.height_m);
  return p;
}

}  // namespace bole::geo
