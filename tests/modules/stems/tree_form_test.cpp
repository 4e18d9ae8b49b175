// What is told of a tree beside its diameter: outline, stem curve, volume, crown, forks, and how blur is judged.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <random>

#include "measured.h"
#include "stems/core/fit/contour.h"
#include "stems/core/fit/each_stem.h"
#include "stems/core/fit/stem_quality.h"
#include "stems/core/measure_stems.h"
#include "stems/core/tree/crown_form.h"
#include "stems/core/tree/stem_curve.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

using synthetic::make_stem_cloud;
using synthetic::StemCloud;
using synthetic::StemCloudOptions;
using synthetic::TrueStem;

// Adds points with a height to a synthetic cloud; the other columns repeat those of the first point.
void add_points(StemCloud& cloud, const std::vector<Eigen::Vector3f>& more) {
  auto positions = cloud.points.positions();
  const auto n = positions.size();
  positions.insert(positions.end(), more.begin(), more.end());
  PointCloud grown(positions, cloud.points.origin);
  grown.axes = cloud.points.axes;
  for (const auto& [name, column] : cloud.points.columns())
    std::visit(
        [&, &key = name](auto values) {
          for (std::size_t i = n; i < positions.size(); ++i)
            values.push_back(key == arrays::height_above_ground.name
                                 ? static_cast<typename decltype(values)::value_type>(positions[i].z())
                                 : values[0]);
          grown.set_column(key, std::move(values));
        },
        *column);
  cloud.points = std::move(grown);
}

// Leaves in a ball of a crown.
std::vector<Eigen::Vector3f> crown(double radius, double bottom, double top, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Eigen::Vector3f> points;
  while (points.size() < 30000) {
    const Eigen::Vector3d q(u(random), u(random), u(random));
    if (q.head<2>().norm() > 1) continue;
    points.push_back(
        Eigen::Vector3d(radius * q.x(), radius * q.y(), (bottom + top) / 2 + (top - bottom) / 2 * q.z()).cast<float>());
  }
  return points;
}

std::vector<OutlinePoint> outline(double ovality, double radius, double from_deg, double to_deg) {
  std::vector<OutlinePoint> points;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.004);
  for (double d = from_deg; d < to_deg; d += 0.5) {
    const double bearing = d * std::numbers::pi / 180;
    points.push_back({bearing, radius * ovality / 2 * std::cos(2 * bearing - 0.7) + noise(random)});
  }
  return points;
}

TEST(Contour, AnOvalStemIsSeenSo) {
  const auto contour = fit_contour(outline(0.12, 0.15, -180, 180), 0.15);
  ASSERT_TRUE(contour);
  EXPECT_NEAR(contour->ovality, 0.12, 0.015);
  // Girth of r (1 + e cos 2t): 2 pi r (1 + e^2) to second order, e = 0.06.
  EXPECT_NEAR(contour->girth_m, 2 * std::numbers::pi * 0.15 * 1.0036, 0.004);
}

TEST(Contour, ARoundStemIsNearlyRound) {
  const auto contour = fit_contour(outline(0, 0.15, -180, 180), 0.15);
  ASSERT_TRUE(contour);
  EXPECT_LT(contour->ovality, 0.02);
  EXPECT_NEAR(contour->girth_m / std::numbers::pi, 0.30, 0.001);
}

TEST(Contour, HalfAnOutlineIsNotGuessed) { EXPECT_FALSE(fit_contour(outline(0.1, 0.15, 0, 180), 0.15)); }

TEST(TreeForm, TheGirthOfAnOvalStemStandsBesideItsFittedDiameter) {
  TrueStem s;
  s.dbh = 0.30, s.ellipse = 0.05;
  const auto table = stem_table(measure(make_stem_cloud({s}, coarse())));
  ASSERT_EQ(table.rows(), 1U);
  EXPECT_NEAR(table.numbers("ovality_pct")[0], 10, 2.5);
  EXPECT_NEAR(table.numbers("girth_dbh_cm")[0], 30 * 1.0025, 0.4);
  EXPECT_GT(table.numbers("wall_cm")[0], 1.0);  // range noise of 1.5 cm
  EXPECT_LT(table.numbers("wall_cm")[0], 2.0);
}

TEST(TreeForm, TheBaseOfALeaningStemIsWhereItLeavesTheGround) {
  TrueStem s;
  s.dbh = 0.25, s.slope = {std::tan(15 * std::numbers::pi / 180), 0}, s.base = {1, 2};
  const auto table = stem_table(measure(make_stem_cloud({s}, coarse())));
  ASSERT_EQ(table.rows(), 1U);
  EXPECT_NEAR(table.numbers("base_x_m")[0], 1, 0.03);
  EXPECT_NEAR(table.numbers("base_y_m")[0], 2, 0.01);
  EXPECT_NEAR(table.numbers("x_m")[0], 1 + 1.3 * std::sin(15 * std::numbers::pi / 180), 0.03);
}

TEST(TreeForm, AForkAboveBreastHeightIsOneStemAndMarked) {
  TrueStem trunk, left, right;
  trunk.dbh = 0.30, trunk.length = 2.0;
  left.dbh = right.dbh = 0.18, left.start = right.start = 1.95, left.length = right.length = 7;
  left.slope = {-0.22, 0}, right.slope = {0.22, 0.02};
  left.base = -1.9 * left.slope, right.base = -1.9 * right.slope;  // all axes meet 1.9 m above the ground
  auto o = coarse();
  o.highest_elevation = 30;
  const auto survey = measure(make_stem_cloud({trunk, left, right}, o));
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(200 * survey.stems[0].radius, 30, 0.8);
  EXPECT_GT(survey.stems[0].fork_m, 1.9);  // where the limbs are seen apart
  EXPECT_LT(survey.stems[0].fork_m, 2.8);
  EXPECT_THAT(stem_table(survey).texts("reasons")[0], testing::HasSubstr("forks at about"));
}

TEST(TreeForm, StemsFromFourCentimetresAreFound) {
  std::vector<TrueStem> stems(3);
  for (int i = 0; i < 3; ++i)
    stems[static_cast<std::size_t>(i)].base = {1.5 * i - 1.5, 0.4 * i},
    stems[static_cast<std::size_t>(i)].dbh = 0.04 + 0.01 * i, stems[static_cast<std::size_t>(i)].taper = 0.004;
  MeasureOptions options;
  options.min_dbh_cm = 3.5;
  const auto survey = measure(make_stem_cloud(stems), options);
  ASSERT_EQ(survey.stems.size(), 3U);
  for (const auto& t : stems) {
    const auto s = std::ranges::find_if(
        survey.stems, [&](const Stem& o) { return (o.breast_height.head<2>() - t.base).norm() < 0.03; });
    ASSERT_NE(s, survey.stems.end());
    EXPECT_NEAR(200 * s->radius, 100 * t.dbh, 1.2);  // ranges of 1.5 cm noise on 2 cm of radius
    EXPECT_LE(2 * s->radius_low, t.dbh);
    EXPECT_GE(2 * s->radius_high, t.dbh);
  }
}

TEST(TreeForm, ACrownHasABaseAndAnAreaAndADeadStemHasNone) {
  TrueStem living, dead;
  dead.base = {7, 0};
  auto cloud = make_stem_cloud({living, dead}, coarse());
  add_points(cloud, crown(2.0, 6, 11, 1));
  const auto table = stem_table(measure(cloud));
  ASSERT_EQ(table.rows(), 2U);
  const std::size_t alive = std::abs(table.numbers("x_m")[0]) < 1 ? 0 : 1;
  EXPECT_NEAR(table.numbers("crown_base_m")[alive], 6, 0.3);
  EXPECT_NEAR(table.numbers("crown_area_m2")[alive], 4 * std::numbers::pi, 0.8);
  EXPECT_NEAR(table.numbers("height_lower_bound_m")[alive], 11, 0.2);
  EXPECT_TRUE(std::isnan(table.numbers("crown_base_m")[1 - alive]));
}

// Three trees with the crown of a ball each: their points with labels, as measure_crowns takes them.
struct Crowns {
  std::vector<Stem> stems;
  PointCloud points;
  PointLabels labels;
};

Crowns three_crowns() {
  Crowns c;
  std::vector<Eigen::Vector3f> all;
  for (int id = 1; id <= 3; ++id) {
    Stem s;
    s.id = id, s.radius = 0.15, s.breast_height = {10.0 * id, 0, 1.3};
    c.stems.push_back(s);
    for (const auto& p : crown(2.0, 6, 11, static_cast<unsigned>(id)))
      all.push_back(p + s.breast_height.cast<float>() - Eigen::Vector3f(0, 0, 1.3F));
    c.labels.tree_id.resize(all.size(), id);
  }
  c.labels.stem.assign(all.size(), 0);
  c.points = PointCloud(all, Eigen::Vector3d::Zero());
  return c;
}

TEST(TreeForm, ATreeWhoseCrownCannotBeMeasuredHarmsNoOther) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  auto good = three_crowns();
  Report none;
  measure_crowns(good.stems, good.points, good.labels, {}, none);
  EXPECT_TRUE(none.warnings.empty());
  for (const auto& s : good.stems) EXPECT_NEAR(s.crown_area_m2, 4 * std::numbers::pi, 0.8);
  for (const Eigen::Vector3f& astray : {Eigen::Vector3f(nan, 0, 8), {inf, 0, 8}, {5e5F, -5e5F, 8}, {20, 0, inf}}) {
    auto bad = three_crowns();
    auto positions = bad.points.positions();
    positions[40000] = astray;  // of tree 2
    bad.points.set_positions(positions);
    Report report;
    measure_crowns(bad.stems, bad.points, bad.labels, {}, report);
    ASSERT_EQ(report.warnings.size(), 1U);
    EXPECT_THAT(report.warnings[0], testing::StartsWith("tree 2: the crown is not measured: a point of the tree lies"));
    EXPECT_TRUE(std::isnan(bad.stems[1].crown_base_m));
    EXPECT_TRUE(std::isnan(bad.stems[1].crown_area_m2));
    for (const std::size_t k : {0U, 2U}) {
      EXPECT_EQ(bad.stems[k].crown_base_m, good.stems[k].crown_base_m);
      EXPECT_EQ(bad.stems[k].crown_area_m2, good.stems[k].crown_area_m2);
    }
  }
}

TEST(TreeForm, ACrownWithoutExtentHasNoArea) {
  auto c = three_crowns();
  auto positions = c.points.positions();
  for (std::size_t i = 30000; i < 60000; ++i) positions[i] = {20, 0, 8};  // one place
  for (std::size_t i = 60000; i < 90000; ++i)                             // one line in the plan
    positions[i].x() = 30, positions[i].y() = 2 * std::sin(static_cast<float>(i));
  c.points.set_positions(positions);
  Report report;
  measure_crowns(c.stems, c.points, c.labels, {}, report);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_NEAR(c.stems[0].crown_area_m2, 4 * std::numbers::pi, 0.8);
  for (const std::size_t k : {1U, 2U}) EXPECT_FALSE(c.stems[k].crown_area_m2 > 0);
}

TEST(EachStem, WhatFailsIsToldInTheOrderOfTheStemsAndTakenBack) {
  std::vector<Stem> stems(40);
  for (std::size_t k = 0; k < stems.size(); ++k) stems[k].id = static_cast<int>(k) + 1;
  Report report;
  for_each_stem(
      stems, "the bark", {}, report,
      [&](std::size_t k) {
        stems[k].volume_m3 = 1;
        if (k == 30) throw failure("no bark");
        if (k == 3) throw std::bad_alloc();
      },
      [](Stem& s) { s.volume_m3 = 0; });
  ASSERT_EQ(report.warnings.size(), 2U);
  EXPECT_THAT(report.warnings[0], testing::StartsWith("tree 4: the bark is not measured"));
  EXPECT_EQ(report.warnings[1], "tree 31: the bark is not measured: no bark");
  for (const auto& s : stems) EXPECT_EQ(s.volume_m3, s.id == 4 || s.id == 31 ? 0 : 1);
}

TEST(CoveredArea, OfPointsThatSpanNone) {
  std::vector<Eigen::Vector2d> line, place(50, {1, 2});
  for (int i = 0; i < 50; ++i) line.emplace_back(0.1 * i, 0.05 * i);
  EXPECT_EQ(covered_area_m2(line, 0.3), 0);
  EXPECT_EQ(covered_area_m2(place, 0.3), 0);
  line[7].x() = std::nan("");
  EXPECT_THROW(covered_area_m2(line, 0.3), Error);
}

TEST(CoveredArea, OfASquareWithAHole) {
  std::vector<Eigen::Vector2d> points;
  for (double x = -2; x <= 2; x += 0.1)
    for (double y = -2; y <= 2; y += 0.1)
      if (std::max(std::abs(x), std::abs(y)) > 1) points.emplace_back(x, y);
  EXPECT_NEAR(covered_area_m2(points, 0.3), 16 - 2.2 * 2.2, 0.4);
  EXPECT_EQ(covered_area_m2({{0, 0}, {1, 1}}, 0.3), 0);
}

TEST(StemVolume, OfAConeBelowAndAFullerFormAbove) {
  std::vector<CurvePoint> curve;
  for (double h = 0.5; h <= 5.01; h += 0.5) curve.push_back({h, 0.20 - 0.01 * h});
  const auto v = volume_of(curve, 15);
  const double cone = std::numbers::pi / 3 * 5 * (0.04 + 0.20 * 0.15 + 0.15 * 0.15),
               top = std::numbers::pi / 2.5 * 0.15 * 0.15 * 10;
  EXPECT_NEAR(v.m3, cone + top, 1e-6);
  EXPECT_EQ(v.method, "frustums to 5.0 m, between paraboloid and cone above");
}

TEST(StemCurve, FollowsTheStemAboveTheLayerItWasFoundIn) {
  TrueStem s;
  s.dbh = 0.30, s.taper = 0.012, s.length = 8, s.slope = {0.05, 0};
  auto o = coarse();
  o.highest_elevation = 50;
  const auto survey = measure(make_stem_cloud({s}, o));
  ASSERT_EQ(survey.stems.size(), 1U);
  const auto curve = stem_curve(survey.stems[0], 1.3);
  ASSERT_GE(curve.size(), 8U);
  EXPECT_GT(curve.back().height_m, 5);
  for (const auto& c : curve) EXPECT_NEAR(200 * c.radius_m, 30 - 1.2 * (c.height_m - 1.3), 1.6) << c.height_m;
}

// Seen nearly all round in twelve sections, with nothing against it.
Stem clear_stem() {
  Stem s;
  s.radius = 0.15, s.radius_low = 0.148, s.radius_high = 0.152, s.arc_rad = s.unbroken_arc_rad = 6.2;
  s.sections_used = 12, s.inliers = 1200, s.lowest = 0.6, s.highest = 2.0, s.rays_known = true, s.ray_through = 0.02;
  for (int i = 0; i < 12; ++i) {
    Section section;
    section.centre.setZero(), section.height = 0.7 + 0.1 * i, section.used = true;
    s.sections.push_back(section);
  }
  s.contrast = 20;
  return s;
}

TEST(Quality, BlurLowersTheQualityOfAStemAndDoesNotRejectIt) {
  Stem s = clear_stem();
  s.radius_low = 0.13, s.radius_high = 0.17;
  s.sigma_m = 0.04, s.inside_share = 0.3, s.contrast = 2, s.pass_spread_m = 0.08;
  judge(s, 1.3);
  EXPECT_EQ(s.quality, "poor");
  EXPECT_EQ(s.state, "check");
  EXPECT_FALSE(objection(s, {}));
  // The same picture where rays pass is a bush.
  s.ray_through = 0.25;
  judge(s, 1.3);
  EXPECT_TRUE(objection(s, {}));
}

TEST(Quality, AStemThatWidensLikeAForkIsToBeChecked) {
  Stem s = clear_stem();
  s.taper = 0.015;  // 3 cm of diameter per metre
  judge(s, 1.3);
  EXPECT_EQ(s.quality, "fair");
  EXPECT_EQ(s.state, "auto");
  s.taper = 0.034;
  judge(s, 1.3);
  EXPECT_EQ(s.quality, "poor");
  EXPECT_EQ(s.state, "check");
  EXPECT_FALSE(objection(s, {}));
}

// From one side taper and radius are told apart by little: a fit whose taper no stem has is not believed.
TEST(Quality, AnOddTaperSeenFromOneSideIsToBeChecked) {
  for (const double narrowing_cm_per_m : {-1.3, 7.0}) {
    Stem s = clear_stem();
    s.taper = -narrowing_cm_per_m / 200;
    judge(s, 1.3);
    EXPECT_THAT(joined(s.reasons), testing::Not(testing::HasSubstr("mistaken"))) << narrowing_cm_per_m;  // all round
    s.arc_rad = s.unbroken_arc_rad = 4.6;
    judge(s, 1.3);
    EXPECT_EQ(s.state, "check") << narrowing_cm_per_m;
    EXPECT_THAT(joined(s.reasons), testing::HasSubstr("per metre"));
    EXPECT_FALSE(objection(s, {}));
  }
  Stem s = clear_stem();
  s.arc_rad = s.unbroken_arc_rad = 4.6;
  s.taper = -0.006;
  judge(s, 1.3);
  EXPECT_EQ(s.state, "auto");
}

// Breast height lies in a root flare, or the terrain lies too low: the diameter is not that of the stem.
TEST(Quality, AStemThatFlaresAtBreastHeightIsToBeChecked) {
  const auto state = [](double narrowing_cm_per_m, double radius_m) {
    Stem s = clear_stem();
    s.radius = radius_m, s.radius_low = radius_m - 0.002, s.radius_high = radius_m + 0.002;
    s.taper = -narrowing_cm_per_m / 200;
    judge(s, 1.3);
    return s.state + ", " + joined(s.reasons);
  };
  EXPECT_EQ(state(5, 0.14), "auto, ");
  EXPECT_THAT(state(8, 0.14), testing::StartsWith("check, narrows by 8.0 cm per metre"));
  EXPECT_EQ(state(8, 0.4), "auto, ");  // thick trees flare more
}

}  // namespace
}  // namespace bole::stems
