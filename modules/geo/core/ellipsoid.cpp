#include "geo/core/ellipsoid.h"

#include "base/error.h"

namespace bole::geo {

const Ellipsoid& grs80() {
  static const Ellipsoid e{"GRS80", 6378137.0, 298.257222101};
  return e;
}

const Ellipsoid& wgs84() {
  static const Ellipsoid e{"WGS84", 6378137.0, 298.257223563};
  return e;
}

const Ellipsoid& cgcs2000() {
  static const Ellipsoid e{"CGCS2000", 6378137.0, 298.257222101};
  return e;
}

const std::vector<std::string>& ellipsoid_names() {
  static const std::vector<std::string> names{grs80().name, wgs84().name, cgcs2000().name};
  return names;
}

const Ellipsoid& ellipsoid_named(std::string_view name) {
  for (const auto* e : {&grs80(), &wgs84(), &cgcs2000()})
    if (e->name == name) return *e;
  throw bad_input("there is no ellipsoid '" + std::string(name) + "'", "GRS80, WGS84 or CGCS2000");
}

}  // namespace bole::geo
