#include "geo/core/projected_crs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace bole::geo {
namespace {

TEST(ProjectedCrs, KnowsCodesAndItsOwnWkt) {
  for (const char* code :
       {"EPSG:25832", "EPSG:32733", "EPSG:31467", "EPSG:2154", "EPSG:3035", "EPSG:2180", "EPSG:4547"}) {
    const ProjectedCrs crs(code);
    EXPECT_EQ(crs.code(), code);
    const ProjectedCrs again(crs.wkt());
    EXPECT_EQ(again.code(), code);
    EXPECT_TRUE(crs.area().has_value()) << code;
  }
  EXPECT_EQ(ProjectedCrs("25832").title(), "EPSG:25832 (ETRS89 / UTM zone 32N)");
}

TEST(ProjectedCrs, RefusesWhatIsNoPlaneInMetres) {
  for (const char* text : {"", "EPSG:4326", "EPSG:4979", "EPSG:4978", "EPSG:2263", "EPSG:1", "utm32", "/etc/passwd",
                           "PROJCS[", "https://epsg.io/25832"})
    EXPECT_THROW(ProjectedCrs crs(text), Error) << text;
}

TEST(ProjectedCrs, TransverseMercatorAgreesWithUtm) {
  const ProjectedCrs crs("EPSG:32632");
  EXPECT_TRUE(crs.is_transverse_mercator());
  const GeodeticPoint at{48.85, 9.87, 0};
  const auto p = crs.forward(at);
  const auto utm = TransverseMercator({wgs84(), 9, 0.9996, 500'000, 0, 0}).forward(at);
  EXPECT_NEAR(p.easting_m, utm.easting_m, 1e-6);
  EXPECT_NEAR(p.northing_m, utm.northing_m, 1e-6);
  const auto back = crs.inverse(p.easting_m, p.northing_m);
  EXPECT_NEAR(back.latitude_deg, at.latitude_deg, 1e-11);
  EXPECT_EQ(crs.datum_shift_m(at), 0);
}

TEST(ProjectedCrs, OtherPlanesAreThoseOfProj) {
  // Lambert-93 at its origin: 700 km, 6600 km; the convergence there is zero, and (lon - 3) n to the east, n =
  // 0.725607765.
  const ProjectedCrs lambert("EPSG:2154");
  EXPECT_FALSE(lambert.is_transverse_mercator());
  const auto origin = lambert.forward({46.5, 3, 0});
  EXPECT_NEAR(origin.easting_m, 700000, 1e-3);
  EXPECT_NEAR(origin.northing_m, 6600000, 1e-3);
  EXPECT_NEAR(origin.convergence_deg, 0, 1e-5);
  EXPECT_NEAR(lambert.forward({46.5, 5, 0}).convergence_deg, 2 * 0.7256077650, 1e-5);
  // One on the parallels of 44 and 49 degrees.
  EXPECT_NEAR(lambert.forward({44, 3, 0}).scale, 1, 1e-6);
  EXPECT_NEAR(lambert.forward({49, 3, 0}).scale, 1, 1e-6);
}

TEST(ProjectedCrs, TellsPlacesThatCannotBe) {
  const ProjectedCrs crs("EPSG:25832");
  EXPECT_TRUE(crs.plausible(563210, 5412345));
  EXPECT_FALSE(crs.plausible(5412345, 563210));
  EXPECT_FALSE(crs.plausible(32563210, 5412345));
  EXPECT_FALSE(crs.plausible(NAN, 5412345));
  EXPECT_TRUE(crs.plausible(GeodeticPoint{48, 9, 0}));
  EXPECT_FALSE(crs.plausible(GeodeticPoint{9, 48, 0}));
}

TEST(ProjectedCrs, OldDatumsAreFarFromThatOfReceivers) {
  EXPECT_GT(ProjectedCrs("EPSG:31467").datum_shift_m({48.85, 9.87, 0}), 50);
  EXPECT_LT(ProjectedCrs("EPSG:25832").datum_shift_m({48.85, 9.87, 0}), 0.01);
  EXPECT_LT(ProjectedCrs("EPSG:4547").datum_shift_m({30, 114, 0}), 1);
}

TEST(ProjectedCrs, GroundScaleIsThatOfPlaneAndHeight) {
  const ProjectedCrs crs("EPSG:25832");
  EXPECT_NEAR(crs.ground_scale(500000, 5412345, 0), 0.9996, 1e-9);
  EXPECT_NEAR(crs.ground_scale(500000, 5412345, 1000), 0.9996 * (1 - 1000 / 6.3835e6), 2e-7);
}

}  // namespace
}  // namespace bole::geo
