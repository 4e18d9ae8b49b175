#include "geo/core/ellipsoid.h"

namespace bole::geo {
namespace {

constexpr std::array<Ellipsoid, 7> ellipsoids{{
    {"GRS80", "D_GRS_1980", 6378137.0, 298.257222101},
    {"WGS84", "WGS_1984", 6378137.0, 298.257223563},
    {"CGCS2000", "China_2000", 6378137.0, 298.257222101},
    {"Airy1830", "D_Airy1830", 6377563.396, 299.3249646},
    {"Bessel1841", "D_Bessel1841", 6377397.155, 299.1528128},
    {"International1924", "D_International1924", 6378388.0, 297.0},
    {"Krassovsky1940", "D_Krassovsky1940", 6378245.0, 298.3},
}};

}  // namespace

const Ellipsoid& ellipsoid_of(EllipsoidName name) { return ellipsoids[static_cast<std::size_t>(name)]; }

const Ellipsoid& grs80() { return ellipsoid_of(EllipsoidName::grs80); }
const Ellipsoid& wgs84() { return ellipsoid_of(EllipsoidName::wgs84); }
const Ellipsoid& cgcs2000() { return ellipsoid_of(EllipsoidName::cgcs2000); }

}  // namespace bole::geo
