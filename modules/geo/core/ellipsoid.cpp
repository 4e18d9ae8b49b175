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

namespace {

// The last four carry the grids of former surveys; their axes as EPSG has them (7001, 7004, 7022, 7024).
const std::vector<Ellipsoid>& ellipsoids() {
  static const std::vector<Ellipsoid> list{grs80(),
                                           wgs84(),
                                           cgcs2000(),
                                           {"Airy1830", 6377563.396, 299.3249646},
                                           {"Bessel1841", 6377397.155, 299.1528128},
                                           {"International1924", 6378388.0, 297.0},
                                           {"Krassovsky1940", 6378245.0, 298.3}};
  return list;
}

}  // namespace

const std::vector<std::string>& ellipsoid_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& e : ellipsoids()) list.push_back(e.name);
    return list;
  }();
  return names;
}

const Ellipsoid& ellipsoid_named(std::string_view name) {
  for (const auto& e : ellipsoids())
    if (e.name == name) return e;
  std::string list;
  for (const auto& n : ellipsoid_names()) list += (list.empty() ? "" : ", ") + n;
  throw bad_input("there is no ellipsoid '" + std::string(name) + "'", "one of " + list);
}

}  // namespace bole::geo
