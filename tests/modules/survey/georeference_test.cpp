#include "survey/core/georeference/georeference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/no_number.h"
#include "base/random.h"
#include "checks.h"
#include "survey/core/georeference/place_trees.h"

namespace bole::survey {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

const geo::ProjectedCrs& utm32() {
  static const geo::ProjectedCrs crs("EPSG:25832");
  return crs;
}

// A plot somewhere in zone 32, turned and shifted; no scale.
struct Truth {
  double turn_rad = radians(23.5);
  Eigen::Vector3d shift{563210.123, 5412345.678, 431.25};
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();  // the local axes are out of level by this
  double scale = 1;

  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d up = Eigen::Vector3d(rise.x(), rise.y(), 1).normalized();
    const Eigen::Vector3d level = Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()) * p;
    const Eigen::Vector3d turned = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()) * level;
    return shift + Eigen::Vector3d(scale * turned.x(), scale * turned.y(), turned.z());
  }
};

std::vector<Eigen::Vector3d> corners(double half = 15) {
  return {{-half, -half, 0.4}, {half, -half, -1.2}, {half, half, 2.1}, {-half, half, 0.9}, {0, 0, 1.5}, {3, half, 1.1}};
}

std::vector<ControlPoint> control_at(const std::vector<Eigen::Vector3d>& places, const Truth& truth) {
  std::vector<ControlPoint> points;
  for (const auto& p : places)
    points.push_back({"P" + std::to_string(points.size() + 1), p, truth(p), no_number, no_number});
  return points;
}

std::vector<Eigen::Vector3d> stems_of(int count, std::uint64_t seed, double half = 16) {
  Random random(seed, 77);
  std::vector<Eigen::Vector3d> stems;
  for (int i = 0; i < count; ++i)
    stems.emplace_back(random.uniform(-half, half), random.uniform(-half, half), random.uniform(-2, 2));
  return stems;
}

LocalPlot plot_with(std::vector<Eigen::Vector3d> stems) {
  LocalPlot plot;
  plot.axes = Axes::map;
  plot.bearing_target_rad = std::numbers::pi / 2;
  plot.stems = std::move(stems);
  return plot;
}

double worst_error(const Georeference& place, const Truth& truth, const std::vector<Eigen::Vector3d>& stems) {
  double worst = 0;
  for (const auto& s : stems) worst = std::max(worst, (place.frame.to_global(s) - truth(s)).norm());
  return worst;
}

bool found(const Report& report, const std::string& code) {
  return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.code == code; });
}

TEST(Georeference, ExactControlPointsGiveExactPlaces) {
  const auto stems = stems_of(50, 1);
  for (const double turn : {0.0, 23.5, 91.0, 179.9, -120.0}) {
    Truth truth;
    truth.turn_rad = radians(turn);
    for (const std::size_t n : {2U, 3U, 6U}) {
      auto places = corners();
      places.resize(n);
      const auto place = georeference(control_at(places, truth), utm32(), plot_with(stems), {});
      EXPECT_LT(worst_error(place, truth, stems), 1e-6) << turn << " deg, " << n << " points";
      EXPECT_TRUE(place.frame.heights_known);
    }
  }
}

TEST(Georeference, HeightsLevelThePlot) {
  Truth truth;
  truth.rise = {0.0015, -0.001};  // 0.1 deg
  const auto stems = stems_of(50, 2);
  GeoreferenceOptions options;
  options.height_sd = 0.001;
  options.map_sd = 0.0005;
  const auto place = georeference(control_at(corners(), truth), utm32(), plot_with(stems), options);
  EXPECT_LT(worst_error(place, truth, stems), 0.0005);
  EXPECT_FALSE(found(place.report, "level_changed"));
  options.level = false;
  EXPECT_GT(worst_error(georeference(control_at(corners(), truth), utm32(), plot_with(stems), options), truth, stems),
            0.01);
  truth.rise = {0.03, 0};
  options.level = true;
  const auto tilted = georeference(control_at(corners(), truth), utm32(), plot_with(stems), options);
  EXPECT_TRUE(found(tilted.report, "level_changed"));
  // The plane is linear in the tilt: 1.7 deg leave half a millimetre.
  EXPECT_LT(worst_error(tilted, truth, stems), 0.001);
}

TEST(Georeference, HeightsOnALineKeepTheLevel) {
  std::vector<Eigen::Vector3d> line{{-10, 0, 0}, {0, 0, 0.5}, {10, 0, 1}};
  const Truth truth;
  const auto place = georeference(control_at(line, truth), utm32(), plot_with(stems_of(5, 3)), {});
  EXPECT_THAT(place.report.facts.at("level"), HasSubstr("on a line"));
  EXPECT_TRUE(found(place.report, "control_on_a_line"));
}

TEST(Georeference, ScaleOfTheGridIsToldAndTakenWhereTheResidualsSaySo) {
  const auto stems = stems_of(20, 4);
  const Truth flat;
  const double grid = utm32().ground_scale(flat.shift.x(), flat.shift.y(), 431);
  EXPECT_NEAR(grid, 0.9996 * (1 + 0.5 * std::pow(63210.0 / 6.38e6, 2)) * (1 - 431 / 6.38e6), 2e-6);
  const auto plain = georeference(control_at(corners(40), flat), utm32(), plot_with(stems), {});
  EXPECT_EQ(plain.report.facts.at("scale"), "one");
  EXPECT_NEAR(plain.report.metrics.at("grid_scale").value, grid, 1e-6);
  Truth scaled;
  scaled.scale = grid;
  const auto taken = georeference(control_at(corners(40), scaled), utm32(), plot_with(stems), {});
  EXPECT_EQ(taken.report.facts.at("scale"), "grid");
  EXPECT_LT(worst_error(taken, scaled, stems), 1e-5);
  scaled.scale = 1.02;
  GeoreferenceOptions wide;
  wide.max_residual = 5;
  EXPECT_TRUE(found(georeference(control_at(corners(40), scaled), utm32(), plot_with(stems), wide).report,
                    "scale_unexplained"));
  // Two points cannot decide: the uncertainty contains it.
  auto two = corners(40);
  two.resize(2);
  EXPECT_GT(georeference(control_at(two, flat), utm32(), plot_with(stems), {}).uncertainty.scale_doubt, 1e-4);
}

TEST(Georeference, BearingWithOnePoint) {
  const Truth truth;
  const auto stems = stems_of(20, 5);
  const auto at = utm32().inverse(truth.shift.x(), truth.shift.y());
  const double convergence = utm32().forward(at).convergence_deg;
  EXPECT_NEAR(convergence, (at.longitude_deg - 9) * std::sin(radians(at.latitude_deg)), 0.001);
  const std::vector<ControlPoint> one{{"centre", {0, 0, 0}, truth.shift, no_number, no_number}};
  GeoreferenceOptions options;
  // The y axis has the grid bearing -turn.
  const double grid_bearing = -degrees(truth.turn_rad);
  options.bearing_deg = grid_bearing;
  options.bearing_kind = BearingKind::grid;
  EXPECT_LT(worst_error(georeference(one, utm32(), plot_with(stems), options), truth, stems), 1e-6);
  options.bearing_deg = grid_bearing + convergence;
  options.bearing_kind = BearingKind::geographic;
  EXPECT_LT(worst_error(georeference(one, utm32(), plot_with(stems), options), truth, stems), 1e-6);
  options.declination_deg = 4.2;
  options.bearing_deg = grid_bearing + convergence - 4.2;
  options.bearing_kind = BearingKind::magnetic;
  const auto place = georeference(one, utm32(), plot_with(stems), options);
  EXPECT_LT(worst_error(place, truth, stems), 1e-6);
  // 1 deg at 10 m is 17 cm across; half of it per coordinate in the square.
  EXPECT_NEAR(place.uncertainty.at({10, 0, 0}), std::hypot(0.17453 / std::sqrt(2.0), 0.02236), 0.02);
  EXPECT_TRUE(found(place.report, "control_unchecked"));
}

TEST(Georeference, ABearingThatContradictsIsToldAndNotUsed) {
  const Truth truth;
  GeoreferenceOptions options;
  options.bearing_kind = BearingKind::grid;
  options.bearing_deg = -degrees(truth.turn_rad) + 9;
  const auto place = georeference(control_at(corners(), truth), utm32(), plot_with(stems_of(5, 6)), options);
  EXPECT_TRUE(found(place.report, "bearing_contradicts"));
  EXPECT_LT(worst_error(place, truth, stems_of(5, 6)), 1e-6);
}

TEST(Georeference, ABlunderIsNamedAndLeftOut) {
  const Truth truth;
  const auto stems = stems_of(20, 7);
  for (const std::size_t wrong : {0U, 2U, 4U})
    for (const bool stated : {true, false}) {
      auto points = control_at(corners(), truth);
      Random random(wrong, 8);
      for (auto& p : points) p.global += Eigen::Vector3d(random.normal(0, 0.02), random.normal(0, 0.02), 0);
      points[wrong].global.y() += 0.5;
      GeoreferenceOptions options;
      if (stated) options.control_sd = 0.02;
      const auto place = georeference(points, utm32(), plot_with(stems), options);
      ASSERT_TRUE(found(place.report, "control_blunder")) << wrong << stated;
      const auto used = place.control.integers("used");
      for (std::size_t i = 0; i < used.size(); ++i) EXPECT_EQ(used[i], i == wrong ? 0 : 1);
      EXPECT_NEAR(place.control.numbers("residual_north_m")[wrong], 0.5, 0.12);
      EXPECT_LT(worst_error(place, truth, stems), 0.06);
    }
}

TEST(Georeference, ThreePointsWithStatedErrorsNameABlunderToo) {
  const Truth truth;
  auto places = corners();
  places.resize(3);
  auto points = control_at(places, truth);
  points[1].global.x() += 0.4;
  GeoreferenceOptions options;
  options.control_sd = 0.02;
  const auto place = georeference(points, utm32(), plot_with(stems_of(5, 9)), options);
  EXPECT_TRUE(found(place.report, "control_blunder") || found(place.report, "control_blunder_unclear"));
}

TEST(Georeference, AHeightBlunderIsNamed) {
  const Truth truth;
  auto points = control_at(corners(), truth);
  points[3].global.z() += 1.5;  // measured on the target instead of the ground
  const auto place = georeference(points, utm32(), plot_with(stems_of(5, 10)), {});
  EXPECT_TRUE(found(place.report, "control_height_blunder"));
  EXPECT_NEAR(place.control.numbers("residual_height_m")[3], 1.5, 0.01);
  EXPECT_LT(worst_error(place, truth, stems_of(5, 10)), 1e-6);
}

TEST(Georeference, FalseAlarmsAreRare) {
  const Truth truth;
  int alarms = 0;
  constexpr int seeds = 500;
  for (int seed = 0; seed < seeds; ++seed) {
    auto points = control_at(corners(), truth);
    Random random(static_cast<std::uint64_t>(seed), 11);
    for (auto& p : points)
      p.global += Eigen::Vector3d(random.normal(0, 0.03), random.normal(0, 0.03), random.normal(0, 0.05));
    const auto place = georeference(points, utm32(), plot_with(stems_of(2, 12)), {});
    alarms += found(place.report, "control_blunder") || found(place.report, "control_height_blunder") ? 1 : 0;
  }
  EXPECT_LE(alarms, seeds / 50);
}

// Share of the coordinates of all stems whose 95 % interval holds the truth.
double coverage(std::size_t points, double control_sd, const GeoreferenceOptions& options, int seeds) {
  std::int64_t inside = 0, all = 0;
  constexpr double map_sd = 0.01, own_sd = 0.012;
  for (int seed = 0; seed < seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(seed), 1000 + points);
    Truth truth;
    truth.turn_rad = random.angle();
    truth.rise = {random.normal(0, radians(0.1)), random.normal(0, radians(0.1))};
    auto places = corners();
    places.resize(points);
    auto control = control_at(places, truth);
    for (auto& p : control) {
      p.global +=
          Eigen::Vector3d(random.normal(0, control_sd), random.normal(0, control_sd), random.normal(0, control_sd));
      p.local += Eigen::Vector3d(random.normal(0, map_sd), random.normal(0, map_sd), random.normal(0, map_sd));
    }
    const auto stems = stems_of(30, static_cast<std::uint64_t>(seed));
    const auto place = georeference(control, utm32(), plot_with(stems), options);
    Table table;
    std::vector<double> x, y, z;
    for (const auto& s : stems) {
      x.push_back(s.x() + random.normal(0, own_sd));
      y.push_back(s.y() + random.normal(0, own_sd));
      z.push_back(s.z());
    }
    table.set("x_m", x);
    table.set("y_m", y);
    table.set("z_m", z);
    const std::vector<double> own(stems.size(), own_sd);
    const auto placed = with_places(table, place, &own);
    const auto e = placed.numbers("easting_m"), n = placed.numbers("northing_m"), se = placed.numbers("position_se_m");
    for (std::size_t i = 0; i < stems.size(); ++i) {
      const Eigen::Vector3d is = truth(stems[i]);
      inside += std::abs(e[i] - is.x()) <= 1.96 * se[i] ? 1 : 0;
      inside += std::abs(n[i] - is.y()) <= 1.96 * se[i] ? 1 : 0;
      all += 2;
    }
  }
  return static_cast<double>(inside) / static_cast<double>(all);
}

TEST(Georeference, IntervalsHoldWithNoisyControlPoints) {
  constexpr int seeds = 1000;
  for (const double sd : {0.01, 0.03, 0.2})
    for (const std::size_t n : {2U, 3U, 4U, 6U}) {
      GeoreferenceOptions stated;
      stated.control_sd = sd;
      stated.height_sd = sd;
      const double told = coverage(n, sd, stated, seeds);
      const double open = coverage(n, sd, {}, seeds);
      printf("control sd %.2f m, %zu points: stated %.1f %%, auto %.1f %%\n", sd, n, 100 * told, 100 * open);
      EXPECT_GE(told, 0.92);
      EXPECT_LE(told, 0.98);
      EXPECT_GE(open, 0.92);
      // Two points have one redundancy: an interval that holds for points of 20 cm is wide for those of 1 cm.
      EXPECT_LE(open, n == 2 ? 0.995 : 0.98);
    }
}

// --- control points

Table targets() {
  Table t;
  t.set("name", std::vector<std::string>{"centre", "north"});
  t.set("x_m", std::vector<double>{0, 0.02});
  t.set("y_m", std::vector<double>{0, 16});
  t.set("z_m", std::vector<double>{1.5, 2.2});
  return t;
}

Table control_table(const std::vector<double>& easting, const std::vector<double>& northing,
                    const std::vector<std::string>& names = {"Centre", "NORTH"}) {
  Table t;
  t.set("name", names);
  t.set("easting_m", easting);
  t.set("northing_m", northing);
  return t;
}

const Table& some_targets() {
  static const Table t = targets();
  return t;
}

std::string control_refusal(const Table& control, const GeoreferenceOptions& options) {
  return refusal_of([&] {
    Report report;
    const auto crs = control_crs(control, options, "");
    const auto points = control_points(control, {&some_targets(), nullptr}, crs, options, report);
    georeference(points, crs, plot_with({}), options, report);
  });
}

TEST(ControlPoints, BelongToTargetsByNameOrToPlacesBesideThem) {
  auto control = control_table({563210, 563211, 563220}, {5412345, 5412361, 5412350}, {"Centre", "NORTH", "tree 7"});
  control.set("x_m", std::vector<double>{no_number, no_number, 10});
  control.set("y_m", std::vector<double>{no_number, no_number, 5});
  GeoreferenceOptions options;
  options.crs = "EPSG:25832";
  Report report;
  const auto points = control_points(control, {&some_targets(), nullptr}, utm32(), options, report);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].local, Eigen::Vector3d(0.02, 16, 2.2));
  EXPECT_EQ(points[2].local.x(), 10);
  EXPECT_TRUE(std::isnan(points[2].local.z()));
  EXPECT_TRUE(report.findings.empty());
  control.remove("x_m");
  const auto fewer = control_points(control, {&some_targets(), nullptr}, utm32(), options, report);
  EXPECT_EQ(fewer.size(), 2U);
  EXPECT_TRUE(found(report, "control_not_placed"));
}

TEST(ControlPoints, DegreesAreProjected) {
  const Truth truth;
  const auto a = utm32().inverse(563210, 5412345), b = utm32().inverse(563210, 5412361);
  Table control;
  control.set("name", std::vector<std::string>{"centre", "north"});
  control.set("latitude_deg", std::vector<double>{a.latitude_deg, b.latitude_deg});
  control.set("longitude_deg", std::vector<double>{a.longitude_deg, b.longitude_deg});
  Report report;
  const auto points = control_points(control, {&some_targets(), nullptr}, utm32(), {}, report);
  EXPECT_NEAR(points[1].global.y(), 5412361, 1e-6);
  EXPECT_EQ(control_crs(control, {}, "").code(), "EPSG:32632");
  GeoreferenceOptions old;
  old.crs = "EPSG:31467";  // DHDN: another datum than that of receivers
  EXPECT_THAT(control_refusal(control, old), HasSubstr("datum"));
  GeoreferenceOptions utm;
  utm.crs = "EPSG:25832";
  auto swapped = control;
  swapped.set("latitude_deg", control.numbers("longitude_deg"));
  swapped.set("longitude_deg", control.numbers("latitude_deg"));
  EXPECT_THAT(control_refusal(swapped, utm), HasSubstr("exchanged"));
}

TEST(ControlPoints, RefusedWithTheReason) {
  GeoreferenceOptions o;
  EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412361}), o), HasSubstr("coordinate system"));
  o.crs = "EPSG:25832";
  EXPECT_EQ(control_refusal(control_table({563210, 563210}, {5412345, 5412361}), o), "not refused");
  EXPECT_THAT(control_refusal(control_table({5412345, 5412361}, {563210, 563210}), o), HasSubstr("exchanged"));
  EXPECT_THAT(control_refusal(control_table({32563210, 32563210}, {5412345, 5412361}), o), HasSubstr("zone number 32"));
  EXPECT_THAT(control_refusal(control_table({563210, 32563210}, {5412345, 5412361}), o), HasSubstr("one zone"));
  EXPECT_THAT(control_refusal(control_table({563210, 122210}, {5412345, 5412361}), o), HasSubstr("zones"));
  EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412364}), o),
              HasSubstr("do not fit the plot"));
  EXPECT_THAT(control_refusal(control_table({563210}, {5412345}, {"centre"}), o), HasSubstr("no direction"));
  EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412361}, {"a", "b"}), o),
              HasSubstr("no control point"));
  EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412361}, {"north", "north"}), o),
              HasSubstr("rows 1 and 2"));
  EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412345 + 16 / 0.3048}), o), HasSubstr("feet"));
  Table nothing;
  nothing.set("name", std::vector<std::string>{"centre"});
  EXPECT_THAT(control_refusal(nothing, o), HasSubstr("easting_m and northing_m"));
  auto zones = control_table({563210, 563210}, {5412345, 5412361});
  zones.set("zone", std::vector<std::int64_t>{32, 33});
  EXPECT_THAT(control_refusal(zones, o), HasSubstr("different zones"));
  for (const char* crs : {"EPSG:4326", "EPSG:2263", "EPSG:99999", "nonsense", "/etc/passwd"}) {
    o.crs = crs;
    EXPECT_THAT(control_refusal(control_table({563210, 563210}, {5412345, 5412361}), o),
                HasSubstr("coordinate reference system"))
        << crs;
  }
}

TEST(ControlPoints, ExchangedAxesOfALocalPlaneAreSeenByTheMirror) {
  const Truth truth;
  auto points = control_at(corners(), truth);
  for (auto& p : points) std::swap(p.global.x(), p.global.y());
  for (auto& p : points) p.global.head<2>() += Eigen::Vector2d(560000 - 5412345, 5412345 - 560000);
  EXPECT_THAT(refusal_of([&] { georeference(points, utm32(), plot_with({}), {}); }), HasSubstr("mirrored"));
}

TEST(ControlPoints, PointsAtOnePlaceGiveNoDirection) {
  const Truth truth;
  const auto points = control_at({{0, 0, 0}, {0.2, 0, 0}}, truth);
  EXPECT_THAT(refusal_of([&] { georeference(points, utm32(), plot_with({}), {}); }), HasSubstr("no direction"));
}

TEST(Georeference, OptionsThatContradictAreRefused) {
  const auto check = [](const GeoreferenceOptions& o) { return refusal_of([&] { option_table(&o).check_all(&o); }); };
  GeoreferenceOptions o;
  o.easting = 1;
  EXPECT_THAT(check(o), HasSubstr("northing"));
  o = {};
  o.bearing_deg = 10;
  EXPECT_THAT(check(o), HasSubstr("declination"));
}

}  // namespace
}  // namespace bole::survey
