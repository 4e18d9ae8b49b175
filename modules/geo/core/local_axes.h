// East-north-up about a point.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "geo/core/ellipsoid.h"
#include "geo/core/geodetic.h"

namespace bole::geo {

// Cartesian axes at `origin`: x east, y north, z up along the ellipsoid's normal. True lengths, no projection.
class LocalAxes {
 public:
  explicit LocalAxes(const GeodeticPoint& origin, const Ellipsoid& ellipsoid = wgs84());  // throws Error{bad_input}
  ~LocalAxes();
  LocalAxes(LocalAxes&&) noexcept;
  LocalAxes& operator=(LocalAxes&&) noexcept;

  Eigen::Vector3d to_enu(const GeodeticPoint& point) const;  // metres
  GeodeticPoint to_geodetic(const Eigen::Vector3d& enu) const;

 private:
  class Cartesian;
  std::unique_ptr<const Cartesian> cartesian_;
};

}  // namespace bole::geo
