#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "geo/core/local_axes.h"
#include "geo/core/project_table.h"
#include "geo/core/utm.h"

namespace bole::geo {
namespace {

using ::testing::HasSubstr;

struct Reference {
  double latitude_deg, longitude_deg, easting_m, northing_m, convergence_deg, scale;
};

// C. F. F. Karney, Test data for the transverse Mercator projection (2009), doi 10.5281/zenodo.32470, the first lines
// of TMcoords.dat within 80 degrees: WGS84, central meridian 0, scale 0.9996, no false coordinates; computed with 80
// digits.
constexpr Reference tmcoords[] = {
    {70.579277094557, 45.599419731762, 1548706.7916191491794, 8451449.1987722350778, 43.922790121040067192,
     1.02906022837807180952},
    {10.018893710119, 23.313323816796, 2624150.74092867098, 1204434.0416046227631, 4.292619330037266837,
     1.08605124643084949596},
    {19.479895588178, 75.662049225092, 9855841.2329353332058, 6145496.1151551160577, 53.348315487088028046,
     2.44509802490834298722},
    {21.072464821428, 29.82868439326, 3206390.6919962592145, 2650745.4004060203847, 11.666949788578689434,
     1.12935868700276526857},
    {79.584190378868, 16.367006094695, 326141.9757557496954, 8881325.164542603823, 16.111414681359673051,
     1.00089993942341181312},
    {40.552052236608, 3.10605643618, 263004.7709889716198, 4493669.7624508701848, 2.020523080004668331,
     1.00045152537558245158},
    {20.166741997072, 3.143947731274, 328652.2771294843991, 2233043.9588736710395, 1.084863297347176706,
     1.00093521803437134364},
    {19.376879758731, .344604702538, 36187.3424147238117, 2142565.3248023055831, .114334366652574163,
     .99961618629427946552},
};

TEST(TransverseMercator, AgreesWithTheReferenceData) {
  const TransverseMercator projection({wgs84(), 0, 0.9996, 0, 0});
  double worst_m = 0;
  for (const auto& r : tmcoords) {
    const auto p = projection.forward({r.latitude_deg, r.longitude_deg, 0});
    worst_m = std::max({worst_m, std::abs(p.easting_m - r.easting_m), std::abs(p.northing_m - r.northing_m)});
    EXPECT_NEAR(p.convergence_deg, r.convergence_deg, 1e-12);
    EXPECT_NEAR(p.scale, r.scale, 1e-13);
    const auto g = projection.inverse(r.easting_m, r.northing_m);
    EXPECT_NEAR(g.latitude_deg, r.latitude_deg, 1e-12);
    EXPECT_NEAR(g.longitude_deg, r.longitude_deg, 1e-12);
  }
  printf("worst difference from TMcoords: %.2g m\n", worst_m);
  EXPECT_LT(worst_m, 2e-8);
}

TEST(TransverseMercator, RoundTripsInEveryZoneAndEllipsoid) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> latitude(-89, 89), longitude(-180, 180);
  double worst_deg = 0;
  for (int i = 0; i < 3000; ++i) {
    const GeodeticPoint g{latitude(random), longitude(random), 0};
    const int width = i % 2 == 0 ? 3 : 6;
    const auto zone = gauss_krueger_zone(g.longitude_deg, width);
    EXPECT_LE(std::abs(longitude_difference_deg(g.longitude_deg, zone.central_meridian_deg())), width / 2.0 + 1e-9);
    const TransverseMercator projection(
        gauss_krueger_plane(zone, ellipsoid_of(static_cast<EllipsoidName>(i % 3)), i % 5 == 0));
    const auto p = projection.forward(g);
    const auto back = projection.inverse(p.easting_m, p.northing_m);
    worst_deg = std::max({worst_deg, std::abs(back.latitude_deg - g.latitude_deg),
                          std::abs(longitude_difference_deg(back.longitude_deg, g.longitude_deg))});
  }
  printf("worst round trip: %.2g deg\n", worst_deg);
  EXPECT_LE(worst_deg, 1e-9);
}

TEST(TransverseMercator, ZonesAreThoseOfTheSheets) {
  // Guangzhou (113.3 E) lies in the 3-degree zone 38 about 114 E, the plane of SPEC E1, and in the 6-degree zone 19.
  EXPECT_EQ(gauss_krueger_zone(113.3, 3).number, 38);
  EXPECT_EQ(gauss_krueger_zone(113.3, 3).central_meridian_deg(), 114);
  EXPECT_EQ(gauss_krueger_zone(113.3, 6).number, 19);
  EXPECT_EQ(gauss_krueger_zone(113.3, 6).central_meridian_deg(), 111);
  EXPECT_EQ(gauss_krueger_zone(-0.5, 3).number, 120);
  EXPECT_EQ(gauss_krueger_zone(-0.5, 3).central_meridian_deg(), 0);
  EXPECT_EQ(gauss_krueger_zone(-179, 6).central_meridian_deg(), -177);
  const TransverseMercator plain(gauss_krueger_plane({3, 38})), prefixed(gauss_krueger_plane({3, 38}, grs80(), true));
  const GeodeticPoint guangzhou{23.16, 113.35, 0};
  EXPECT_NEAR(prefixed.forward(guangzhou).easting_m - plain.forward(guangzhou).easting_m, 38e6, 1e-7);
  EXPECT_LT(plain.forward(guangzhou).easting_m, 500'000);
}

// The series of the paper, in the 3-degree zone 114 E and at the edge of a 6-degree one.
TEST(TransverseMercator, TheSeriesOfThePaperIsCloseWithinTheZone) {
  const auto plane = gauss_krueger_plane({3, 38});
  const TransverseMercator exact(plane);
  const auto worst_at = [&](double difference_deg) {
    double worst = 0;
    for (double latitude = 0; latitude <= 60; latitude += 2.5) {
      const GeodeticPoint g{latitude, 114 + difference_deg, 0};
      const auto a = exact.forward(g), b = gauss_krueger_series(g, plane);
      worst = std::max(worst, std::hypot(a.easting_m - b.easting_m, a.northing_m - b.northing_m));
    }
    return worst;
  };
  printf("series against exact: %.3f mm at 0.5 deg, %.3f mm at 1.5 deg, %.2f mm at 3 deg\n", 1e3 * worst_at(0.5),
         1e3 * worst_at(1.5), 1e3 * worst_at(3));
  EXPECT_LT(worst_at(0.5), 1e-6);
  EXPECT_LT(worst_at(1.5), 2e-6);
  EXPECT_LT(worst_at(3), 2e-4);
  EXPECT_GT(worst_at(3), 1e-5);  // it is a series: were it equal, the test would compare a thing with itself
}

TEST(TransverseMercator, RefusesWhatNoPlaneHolds) {
  const TransverseMercator projection(gauss_krueger_plane({3, 38}));
  try {
    projection.forward({113, 23, 0});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("swapped"));
  }
  EXPECT_THROW(projection.forward({20, -60, 0}), Error);
  EXPECT_THROW(projection.forward({std::nan(""), 114, 0}), Error);
  EXPECT_THROW(projection.inverse(38'500'000, 2'500'000), Error);
  EXPECT_THROW(TransverseMercator({{"flat", "flat", 1, 0}, 0, 1, 0, 0}), Error);
  EXPECT_THROW(gauss_krueger_zone(10, 4), Error);
  EXPECT_THROW(gauss_krueger_plane({3, 121}), Error);
}

// Ordnance Survey, A guide to coordinate systems in Great Britain, annexe C: the worked example of the National Grid.
TEST(TransverseMercator, TheBritishGridHasAnOriginOfItsOwn) {
  const TransverseMercator grid({ellipsoid_of(EllipsoidName::airy1830), -2, 0.9996012717, 400'000, -100'000, 49});
  const double latitude_deg = 52 + 39 / 60.0 + 27.2531 / 3600, longitude_deg = 1 + 43 / 60.0 + 4.5177 / 3600;
  const auto p = grid.forward({latitude_deg, longitude_deg, 0});
  EXPECT_NEAR(p.easting_m, 651409.903, 0.002);
  EXPECT_NEAR(p.northing_m, 313177.270, 0.002);
  const auto back = grid.inverse(p.easting_m, p.northing_m);
  EXPECT_NEAR(back.latitude_deg, latitude_deg, 1e-10);
  EXPECT_NEAR(back.longitude_deg, longitude_deg, 1e-10);
  const auto origin = grid.forward({49, -2, 0});
  EXPECT_NEAR(origin.easting_m, 400'000, 1e-6);
  EXPECT_NEAR(origin.northing_m, -100'000, 1e-6);
  EXPECT_THAT(grid.wkt(), HasSubstr("\"latitude_of_origin\",49"));
  EXPECT_THAT(grid.wkt(), HasSubstr("\"false_northing\",-100000"));
  // By the options of the stage.
  Table table;
  table.set("latitude_deg", std::vector<double>{latitude_deg});

  table.set("longitude_deg", std::vector<double>{longitude_deg});
  ProjectOptions o;
  o.plane = PlaneKind::transverse_mercator;
  o.ellipsoid = EllipsoidName::airy1830;
  o.central_meridian_deg = -2;
  o.scale = 0.9996012717;
  o.false_easting_m = 400'000;
  o.false_northing_m = -100'000;
  o.latitude_of_origin_deg = 49;
  EXPECT_NEAR(project_table(table, o).table.numbers("y_m").at(0), 313177.270, 0.002);
}

TEST(Utm, KnowsItsZonesAndRoundTrips) {
  // From the tests of GeographicLib's GeoConvert: 33.3 N 44.4 E lies in 38SMB4484.
  const auto p = to_utm({33.3, 44.4, 0});
  EXPECT_EQ(p.zone, 38);
  EXPECT_TRUE(p.north);
  EXPECT_EQ(std::floor(p.easting_m / 1000), 444);
  EXPECT_EQ(std::floor(p.northing_m / 1000), 3684);
  EXPECT_EQ(to_utm({60.4, 5.3, 0}).zone, 32);  // Bergen: the widened zone of Norway
  for (const double latitude : {-79.0, -33.9, 0.0, 55.7, 83.0}) {
    const GeodeticPoint g{latitude, 151.2, 0};
    const auto back = from_utm(to_utm(g));
    EXPECT_NEAR(back.latitude_deg, g.latitude_deg, 1e-9);
    EXPECT_NEAR(back.longitude_deg, g.longitude_deg, 1e-9);
    const auto u = to_utm(g);
    const auto q = TransverseMercator(utm_plane(u.zone, u.north)).forward(g);
    EXPECT_NEAR(q.easting_m, u.easting_m, 1e-6);
    EXPECT_NEAR(q.northing_m, u.northing_m, 1e-6);
  }
  EXPECT_THROW(to_utm({85, 0, 0}), Error);
  EXPECT_THROW(from_utm({61, true, 500'000, 0}), Error);
}

TEST(LocalAxes, HasTrueLengthsAndRoundTrips) {
  const GeodeticPoint origin{23.16, 113.35, 12};
  const LocalAxes axes(origin, grs80());
  EXPECT_LT(axes.to_enu(origin).norm(), 1e-9);
  // One second of latitude is 30.76 m at 23 degrees (M = a (1 - e^2) / (1 - e^2 sin^2 B)^1.5).
  const double s = std::sin(23.16 * M_PI / 180), e2 = grs80().first_eccentricity_squared();
  const double meridian_radius_m = 6378137.0 * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
  const auto north = axes.to_enu({23.16 + 1 / 3600.0, 113.35, 12});
  EXPECT_NEAR(north.y(), (meridian_radius_m + 12) * M_PI / 180 / 3600, 1e-5);
  EXPECT_NEAR(north.x(), 0, 1e-9);
  const Eigen::Vector3d enu(812.5, -430.25, 3.75);
  EXPECT_LT((axes.to_enu(axes.to_geodetic(enu)) - enu).norm(), 1e-8);
}

TEST(ProjectTable, GoesThereAndBackAndCarriesThePlane) {
  Table t;
  t.set("latitude_deg", std::vector<double>{23.16, 23.17, std::nan("")});
  t.set("longitude_deg", std::vector<double>{113.35, 113.36, 113.37});
  ProjectOptions o;
  const auto plane = project_table(t, o);
  EXPECT_EQ(plane.report.counts.at("missing"), 1);
  EXPECT_EQ(plane.report.metrics.at("central_meridian").value, 114);
  EXPECT_EQ(plane.table.facts.at("axes"), "global");
  EXPECT_THAT(plane.table.facts.at("crs"), HasSubstr("PARAMETER[\"central_meridian\",114]"));
  EXPECT_TRUE(std::isnan(plane.table.numbers("x_m")[2]));
  Table metres;
  metres.set("x_m", plane.table.numbers("x_m"));
  metres.set("y_m", plane.table.numbers("y_m"));
  o.direction = ProjectDirection::to_geodetic;
  EXPECT_THROW(project_table(metres, o), Error);  // which zone?
  o.zone = 38;
  EXPECT_NEAR(project_table(metres, o).table.numbers("latitude_deg")[1], 23.17, 1e-9);
}

}  // namespace
}  // namespace bole::geo
