#include "stems/core/measure_stems.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <stop_token>

#include "measured.h"
#include "stems/core/breast_height_slice.h"
#include "stems/core/fit/repeated_fits.h"
#include "stems/core/fit/stem_quality.h"
#include "stems/core/sensor_facts.h"
#include "synthetic/foreign_scanner.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

using synthetic::make_stem_cloud;
using synthetic::random_stand;
using synthetic::StemCloud;
using synthetic::StemCloudOptions;

// Few enough rays for a quick test.
struct Errors {
  std::size_t missed = 0, extra = 0, covered = 0;
  double bias = 0, rmse = 0;  // centimetres
};

Errors compare(const StemCloud& cloud, const StemSurvey& survey) {
  Errors e;
  std::set<int> used;
  double n = 0;
  for (const auto& t : cloud.stems) {
    const Eigen::Vector2d at = t.base + 1.3 * t.direction().head<2>();
    const auto it = std::ranges::find_if(survey.stems, [&](const Stem& s) {
      return (s.breast_height.head<2>() - at).norm() < 0.05 && !used.contains(s.id);
    });
    if (it == survey.stems.end()) {
      ++e.missed;
      continue;
    }
    used.insert(it->id);
    const double error = 200 * it->radius - 100 * t.dbh;
    n += 1, e.bias += error, e.rmse += error * error,
        e.covered += t.dbh >= 2 * it->radius_low && t.dbh <= 2 * it->radius_high;
  }
  e.extra = survey.stems.size() - used.size();
  e.bias /= n, e.rmse = std::sqrt(e.rmse / n);
  return e;
}

Stem fit_at(double x, double radius) {
  Stem s;
  s.breast_height = Eigen::Vector3d(x, 0, 1.3);
  s.radius = radius;
  return s;
}

// A stem whose better candidate fails in the second round is not lost with it.
TEST(RepeatedFits, ComeBackWhereTheBetterOneIsNoStem) {
  const auto never = [](const Stem&) { return false; };
  std::vector<Stem> fitted{fit_at(0, 0.2), fit_at(5, 0.1), fit_at(0.02, 0.21), fit_at(5.01, 0.1), fit_at(0.15, 0.2)};
  const auto repeated = take_repeated(fitted, never);
  EXPECT_EQ(fitted.size(), 3U);
  ASSERT_EQ(repeated.size(), 2U);
  EXPECT_EQ(repeated[0].better, 0U);
  EXPECT_EQ(repeated[1].better, 1U);
  EXPECT_TRUE(restored_fits(repeated, [](std::size_t) { return true; }).empty());
  const auto restored = restored_fits(repeated, [](std::size_t i) { return i != 0; });
  ASSERT_EQ(restored.size(), 1U);
  EXPECT_EQ(restored[0].radius, 0.21);
  // What is no stem from the start takes nothing away.
  std::vector<Stem> two{fit_at(0, 0.2), fit_at(0, 0.2)};
  EXPECT_TRUE(take_repeated(two, [](const Stem&) { return true; }).empty());
}

TEST(MeasureStems, TrueDiametersComeBackAlongRays) {
  const auto cloud = make_stem_cloud(random_stand(9, 0.07, 0.45, 1), coarse());
  MeasureOptions along_rays;
  // These stems are smooth, and their rays thin.
  along_rays.model = FitModel::ray;
  along_rays.bark_relief = 0.0;
  along_rays.beam_divergence_mrad = 0;
  along_rays.beam_aperture = 0;
  const auto survey = measure(cloud, along_rays);
  const auto e = compare(cloud, survey);
  EXPECT_EQ(e.missed + e.extra, 0U);
  EXPECT_LT(std::abs(e.bias), 0.1);
  EXPECT_LT(e.rmse, 0.3);
  EXPECT_GE(e.covered, 8U);
  EXPECT_EQ(survey.report.facts.at("fit"), "along rays");
}

TEST(MeasureStems, WithoutRaysTheSurfaceIsFitted) {
  auto o = coarse();
  o.rays = o.time = false, o.range_noise = 0.003;
  const auto cloud = make_stem_cloud(random_stand(9, 0.07, 0.45, 2), o);
  const auto e = compare(cloud, measure(cloud));
  EXPECT_EQ(e.missed + e.extra, 0U);
  EXPECT_LT(e.rmse, 0.3);
}

// Nobody knows the beam of a cloud without rays, and stems seen in part depend on it: their intervals reach further
// down, the more so the less of them was seen.
TEST(MeasureStems, WithoutRaysStemsSeenInPartMayBeTooThick) {
  auto o = coarse();
  o.passes = 1, o.rays = false, o.time = false;
  const auto stand = random_stand(9, 0.2, 0.4, 3);
  const auto further_down = [](const Stem& s) { return 2 * s.radius - s.radius_low - s.radius_high; };
  std::size_t in_part = 0;
  for (const auto& s : measure(make_stem_cloud(stand, o)).stems) {
    EXPECT_NEAR(further_down(s), s.edges_m, 1e-12);
    if (s.arc_rad > 1.7 * std::numbers::pi) continue;
    ++in_part;
    EXPECT_GT(further_down(s), 0.1 * s.sigma_m);
  }
  EXPECT_GT(in_part, 3U);
  o.rays = o.time = true;
  for (const auto& s : measure(make_stem_cloud(stand, o)).stems) EXPECT_NEAR(further_down(s), 0, 1e-12);
}

// A tape lies on the ridges of a fluted stem: the fit gives the mean radius, and must not be sure of it.
TEST(MeasureStems, AFlutedStemIsToldAndItsIntervalReachesTheTape) {
  auto o = coarse();
  o.range_noise = 0.01;
  auto stand = random_stand(9, 0.2, 0.4, 4);
  stand[4].dbh = 0.4, stand[4].flutes = 0.08;
  constexpr double by_tape = 0.4144;  // hull of its section
  const auto cloud = make_stem_cloud(stand, o);
  std::size_t told = 0;
  for (const auto& s : measure(cloud).stems) {
    if (s.lobes_m == 0) continue;
    ++told;
    EXPECT_LT((s.breast_height.head<2>() - stand[4].base).norm(), 0.2);
    EXPECT_NE(joined(s.reasons).find("not round"), std::string::npos);
    EXPECT_LT(2 * (s.radius_high - s.lobes_m), by_tape);
    EXPECT_GT(2 * s.radius_high, by_tape);
  }
  EXPECT_EQ(told, 1U);
}

TEST(MeasureStems, ShrubsAndOutliersAreNoStems) {
  auto o = coarse();
  o.shrub_points = 20000, o.outlier_share = 0.05;
  const auto cloud = make_stem_cloud(random_stand(9, 0.08, 0.45, 3), o);
  MeasureOptions along_rays;
  along_rays.model = FitModel::ray;
  const auto e = compare(cloud, measure(cloud, along_rays));
  EXPECT_EQ(e.missed, 0U);
  EXPECT_EQ(e.extra, 0U);
  EXPECT_LT(e.rmse, 0.5);
}

TEST(MeasureStems, LeaningStemsAreMeasuredAcrossTheirAxis) {
  synthetic::TrueStem s;
  s.dbh = 0.25, s.slope = {std::tan(20 * std::numbers::pi / 180), 0};
  const auto cloud = make_stem_cloud({s}, coarse());
  const auto survey = measure(cloud);
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(200 * survey.stems[0].radius, 25, 0.4);
  const auto table = stem_table(survey);
  EXPECT_NEAR(table.numbers("lean_deg")[0], 20, 0.3);
  EXPECT_NEAR(table.numbers("lean_azimuth_deg")[0], 90, 1);  // towards the east
}

TEST(MeasureStems, AStemMayLeanBy30Degrees) {
  synthetic::TrueStem s;
  s.dbh = 0.22, s.slope = {0, std::tan(30 * std::numbers::pi / 180)};
  const auto survey = measure(make_stem_cloud({s}, coarse()));
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(200 * survey.stems[0].radius, 22, 0.6);
  EXPECT_NEAR(stem_table(survey).numbers("lean_deg")[0], 30, 0.5);
}

TEST(MeasureStems, AForkBelowBreastHeightIsTwoStems) {
  synthetic::TrueStem left, right;
  left.base = {-0.10, 0}, right.base = {0.10, 0}, left.dbh = 0.20, right.dbh = 0.16;
  left.slope = {-0.12, 0}, right.slope = {0.12, 0.03};  // 0.51 m between their axes at breast height
  const auto cloud = make_stem_cloud({left, right}, coarse());
  const auto survey = measure(cloud);
  const auto e = compare(cloud, survey);
  EXPECT_EQ(e.missed + e.extra, 0U);
  EXPECT_LT(e.rmse, 0.6);
}

TEST(MeasureStems, ABreastHeightHiddenByLeavesIsInterpolatedAndMarked) {
  synthetic::TrueStem s;
  s.dbh = 0.24;
  auto cloud = make_stem_cloud({s}, coarse());
  const auto& height = cloud.points.values<float>(arrays::height_above_ground);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> leaf(-0.35F, 0.35F);
  std::vector<std::uint32_t> kept;
  auto positions = cloud.points.positions();
  for (std::uint32_t i = 0; i < height.size(); ++i) {
    const bool hidden = height[i] > 0.95F && height[i] < 1.65F;
    if (hidden && i % 4 != 0) continue;
    if (hidden) positions[i].head<2>() = Eigen::Vector2f(leaf(random), leaf(random));  // a leaf in place of the bark
    kept.push_back(i);
  }
  cloud.points.set_positions(std::move(positions));
  const auto survey = measure_stems(cloud.points.subset(kept), usual_breast_height_m, cloud.dem, nullptr, {}, {});
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(200 * survey.stems[0].radius, 24, 0.6);
  EXPECT_THAT(stem_table(survey).texts("reasons")[0], testing::HasSubstr("breast height hidden: interpolated between"));
}

TEST(MeasureStems, BreastHeightGoesWithTheTable) {
  synthetic::TrueStem s;
  s.dbh = 0.30, s.taper = 0.03;  // 3 cm of diameter per metre: 2.1 mm between 1.30 and 1.37 m
  const auto cloud = make_stem_cloud({s}, coarse());
  const auto usual = measure(cloud), higher = measure_stems(cloud.points, 1.37, cloud.dem, nullptr, {}, {});
  ASSERT_EQ(higher.stems.size(), 1U);
  EXPECT_EQ(breast_height_m(stem_table(usual)), 1.3);
  EXPECT_EQ(breast_height_m(stem_table(higher)), 1.37);
  EXPECT_NEAR(200 * (usual.stems[0].radius - higher.stems[0].radius), 0.21, 0.06);
}

TEST(MeasureStems, BreastHeightIsCountedFromTheUphillSide) {
  synthetic::TrueStem s;
  s.dbh = 0.40;
  auto o = coarse();
  o.ground_slope = 0.5;
  const auto cloud = make_stem_cloud({s}, o);
  MeasureOptions mean;
  mean.breast_height_from = BreastHeightFrom::mean;
  const auto uphill = measure(cloud), middle = measure(cloud, mean);
  ASSERT_EQ(uphill.stems.size(), 1U);
  ASSERT_EQ(middle.stems.size(), 1U);
  EXPECT_NEAR(uphill.stems[0].ground_z, 0.5 * 0.2, 0.01);
  EXPECT_NEAR(middle.stems[0].ground_z, 0, 0.01);
  EXPECT_NEAR(uphill.stems[0].breast_height.z(), 1.3 + 0.1, 0.01);
}

TEST(MeasureStems, TheDriftOfPassesIsFoundAndTakenOut) {
  auto o = coarse();
  o.drift = 0.02, o.pass_step = 0.25;
  const auto cloud = make_stem_cloud(random_stand(9, 0.12, 0.40, 4), o);
  const auto survey = measure(cloud);
  EXPECT_LT(compare(cloud, survey).rmse, 0.7);
  EXPECT_GT(survey.report.metrics.at("drift_between_passes").value, 0.5);
  EXPECT_EQ(survey.stems.at(0).passes, 3);
}

// Properties: the same plot told differently gives the same stems.

TEST(MeasureStems, AnOffsetOfMillionsOfMetresChangesNothing) {
  auto o = coarse();
  const auto near = measure(make_stem_cloud(random_stand(4, 0.1, 0.3, 5), o));
  o.offset_x = 500000, o.offset_y = 5800000;
  const auto far = measure(make_stem_cloud(random_stand(4, 0.1, 0.3, 5), o));
  ASSERT_EQ(near.stems.size(), far.stems.size());
  for (std::size_t i = 0; i < near.stems.size(); ++i) {
    EXPECT_NEAR(near.stems[i].radius, far.stems[i].radius, 1e-6);
    EXPECT_NEAR(stem_table(near).numbers("y_m")[i] + 5800000, stem_table(far).numbers("y_m")[i], 1e-4);
  }
}

TEST(MeasureStems, TheOrderOfThePointsDoesNotMatter) {
  const auto cloud = make_stem_cloud(random_stand(4, 0.1, 0.3, 6), coarse());
  std::vector<std::uint32_t> order(cloud.points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  auto shuffled = cloud;
  shuffled.points = cloud.points.subset(order);
  const auto a = measure(cloud), b = measure(shuffled);
  ASSERT_EQ(a.stems.size(), b.stems.size());
  for (std::size_t i = 0; i < a.stems.size(); ++i) EXPECT_NEAR(a.stems[i].radius, b.stems[i].radius, 2e-4);
}

TEST(MeasureStems, TheDirectionOfNorthDoesNotMatter) {
  const auto cloud = make_stem_cloud(random_stand(4, 0.1, 0.3, 6), coarse());  // on level ground
  const Eigen::AngleAxisf turn(1.0F, Eigen::Vector3f::UnitZ());
  auto turned = cloud;
  auto positions = cloud.points.positions();
  for (auto& p : positions) p = turn * p;
  turned.points.set_positions(std::move(positions));
  auto x = cloud.points.values<float>(arrays::sensor_x), y = cloud.points.values<float>(arrays::sensor_y);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Eigen::Vector3f p = turn * Eigen::Vector3f(x[i], y[i], 0);
    x[i] = p.x(), y[i] = p.y();
  }
  turned.points.set_column(arrays::sensor_x, std::move(x)), turned.points.set_column(arrays::sensor_y, std::move(y));
  const auto a = measure(cloud), b = measure(turned);
  ASSERT_EQ(a.stems.size(), b.stems.size());
  for (const auto& s : a.stems) {
    const Eigen::Vector3d at = turn.cast<double>() * s.breast_height;
    const auto twin =
        std::ranges::min_element(b.stems, {}, [&](const Stem& o) { return (o.breast_height - at).norm(); });
    EXPECT_LT((twin->breast_height - at).norm(), 0.005);
    EXPECT_NEAR(twin->radius, s.radius, 0.001);
  }
}

TEST(MeasureStems, EveryPointTwiceGivesTheSameDiameters) {
  const auto cloud = make_stem_cloud(random_stand(4, 0.1, 0.3, 6), coarse());
  std::vector<std::uint32_t> twice(2 * cloud.points.size());
  for (std::uint32_t i = 0; i < twice.size(); ++i) twice[i] = i / 2;
  auto doubled = cloud;
  doubled.points = cloud.points.subset(twice);
  const auto a = measure(cloud), b = measure(doubled);
  ASSERT_EQ(a.stems.size(), b.stems.size());
  for (std::size_t i = 0; i < a.stems.size(); ++i) EXPECT_NEAR(a.stems[i].radius, b.stems[i].radius, 0.001);
}

TEST(MeasureStems, IdsAgreeInTableAndCloudFromNorthToSouth) {
  const auto cloud = make_stem_cloud(random_stand(4, 0.1, 0.3, 7), coarse());
  const auto survey = measure(cloud);
  const auto table = stem_table(survey);
  EXPECT_THAT(table.integers("tree_id"), testing::ElementsAre(1, 2, 3, 4));
  EXPECT_TRUE(std::ranges::is_sorted(table.numbers("y_m"), std::greater{}));
  const auto& id = survey.points.values<std::int32_t>(arrays::tree_id);
  const auto& bark = survey.points.values<std::uint8_t>(arrays::stem);
  std::size_t wrong = 0, marked = 0;
  for (std::size_t i = 0; i < id.size(); ++i) {
    if (bark[i] == 0) continue;
    ++marked;
    const auto& s = survey.stems.at(static_cast<std::size_t>(id[i]) - 1);
    const Eigen::Vector3d q = survey.points.positions()[i].cast<double>() - s.breast_height;
    wrong += std::abs((q - q.dot(s.direction) * s.direction).norm() - s.radius) > 0.08;
  }
  EXPECT_GT(marked, id.size() / 2);
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(table.facts.at("axes"), "plot");
  EXPECT_GT(section_table(survey).rows(), 30U);
}

TEST(MeasureStems, NothingToMeasureIsExplained) {
  StemCloudOptions o = coarse();
  auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 8), o);
  EXPECT_THROW(measure_stems(PointCloud(), 1.3, cloud.dem, nullptr, {}, {}), Error);
  EXPECT_THROW(slice_height(PointCloud()), Error);
  auto bare = cloud.points;
  bare.remove_column("height_above_ground");
  EXPECT_THROW(measure_stems(bare, 1.3, cloud.dem, nullptr, {}, {}), Error);
  MeasureOptions high;
  high.search_bottom = 15, high.search_top = 20;
  const auto nothing = measure(cloud, high);
  EXPECT_EQ(stem_table(nothing).rows(), 0U);
  EXPECT_THAT(nothing.report.warnings,
              testing::Contains(testing::HasSubstr("no point lies 15.0 to 20.0 m above ground")));
  EXPECT_EQ(nothing.points.values<std::int32_t>(arrays::tree_id).size(), cloud.points.size());
}

TEST(MeasureStems, PointsThatAreNotNumbersAreLeftOut) {
  auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 8), coarse());
  auto positions = cloud.points.positions();
  auto heights = cloud.points.values<float>(arrays::height_above_ground);
  for (std::size_t i = 0; i < positions.size(); i += 50)
    positions[i].x() = std::nanf(""), heights[i + 1] = std::nanf("");
  cloud.points.set_positions(std::move(positions)),
      cloud.points.set_column(arrays::height_above_ground, std::move(heights));
  const auto survey = measure(cloud);
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(2 * survey.stems[0].radius, cloud.stems[0].dbh, 0.005);
}

TEST(MeasureStems, ThinStemsAreListedAsRejectedWithTheReason) {
  const auto cloud = make_stem_cloud(random_stand(1, 0.12, 0.12, 9), coarse());
  MeasureOptions o;
  o.min_dbh_cm = 15;
  const auto survey = measure(cloud, o);
  EXPECT_TRUE(survey.stems.empty());
  EXPECT_THAT(rejected_table(survey).texts("reason"),
              testing::Contains(testing::HasSubstr("below min_dbh of 15.0 cm")));
}

TEST(MeasureStems, ACancelIsHeeded) {
  const auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 8), coarse());
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  stop.request_stop();
  EXPECT_THROW(measure_stems(cloud.points, 1.3, cloud.dem, nullptr, {}, run), Error);
}

// Wherever the run is when the cancel comes, it ends with it and with no result that is half made.
TEST(MeasureStems, ACancelIsHeededAtEveryStep) {
  const auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 6), coarse());
  std::set<std::string> steps;
  bole::Run run;
  run.progress = [&](double, std::string_view what) { steps.emplace(what); };
  measure_stems(cloud.points, 1.3, cloud.dem, nullptr, {}, run);
  EXPECT_GE(steps.size(), 5U);
  for (const auto& step : steps) {
    std::stop_source stop;
    run.cancel = stop.get_token();
    run.progress = [&](double, std::string_view what) {
      if (what == step) stop.request_stop();
    };
    try {
      measure_stems(cloud.points, 1.3, cloud.dem, nullptr, {}, run);
      ADD_FAILURE() << step;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::cancelled) << step;
    }
  }
}

TEST(MeasureStems, StemsDoNotDependOnWhereTheCloudLies) {
  auto o = coarse();
  o.shrub_points = 20000, o.outlier_share = 0.05;
  auto cloud = make_stem_cloud(random_stand(9, 0.08, 0.45, 3), o);
  // Coordinates of files lie on a lattice: many points lie on borders of cells.
  auto positions = cloud.points.positions();
  for (auto& p : positions) p = (1000 * p).array().round() / 1000;
  cloud.points.set_positions(std::move(positions));
  const auto here = measure(cloud);
  for (const Eigen::Vector3f& by :
       {Eigen::Vector3f(0.1F, 0.07F, 0), Eigen::Vector3f(0, 0, 300), Eigen::Vector3f(-3.33F, 17.01F, 0.5F)}) {
    const auto there = measure(moved(cloud, by));
    ASSERT_EQ(there.stems.size(), here.stems.size());
    for (std::size_t i = 0; i < here.stems.size(); ++i) {
      const auto &a = here.stems[i], &b = there.stems[i];
      EXPECT_LT((b.breast_height - a.breast_height - by.cast<double>()).norm(), 0.001) << i;
      EXPECT_NEAR(200 * b.radius, 200 * a.radius, 0.05) << i;
      EXPECT_EQ(b.quality, a.quality) << i;
    }
  }
}

TEST(MeasureStems, FewPointsMakeNoGoodStem) {
  const auto whole = make_stem_cloud(random_stand(4, 0.2, 0.3, 5), coarse());
  std::vector<std::uint32_t> few;
  std::mt19937 random(3);
  for (std::uint32_t i = 0; i < whole.points.size(); ++i)
    if (random() % 40 == 0) few.push_back(i);
  auto cloud = whole;
  cloud.points = whole.points.subset(few);
  MeasureOptions options;
  options.min_section_points = 4;
  const auto survey = measure(cloud, options);
  ASSERT_FALSE(survey.stems.empty());
  for (const auto& s : survey.stems) {
    EXPECT_NE(s.quality, "good") << s.inliers;
    EXPECT_THAT(s.reasons, testing::Contains(testing::Property(&Reason::text, testing::HasSubstr("few points"))));
  }
  Stem s = survey.stems[0];
  s.inliers = points_for_a_diameter - 1;
  judge(s, usual_breast_height_m);
  EXPECT_EQ(s.quality, "poor");
  EXPECT_EQ(s.state, "check");
}

TEST(MeasureStems, ABushyFootAndSlashAreOneStem) {
  synthetic::TrueStem s;
  s.dbh = 0.25;
  auto cloud = make_stem_cloud({s}, coarse());
  std::mt19937 random(11);
  std::normal_distribution<float> leaf(0, 0.25F), slash(0, 0.12F);
  std::uniform_real_distribution<float> along(-1.5F, 1.5F), unit(0, 1);
  auto positions = cloud.points.positions();
  auto height = cloud.points.values<float>(arrays::height_above_ground),
       x = cloud.points.values<float>(arrays::sensor_x), y = cloud.points.values<float>(arrays::sensor_y),
       z = cloud.points.values<float>(arrays::sensor_z), range = cloud.points.values<float>(arrays::range);
  auto time = cloud.points.values<double>(arrays::time);
  const auto add = [&](const Eigen::Vector3f& p) {
    const Eigen::Vector3f sensor(4, 1, 1.6F);
    positions.push_back(p), height.push_back(p.z()), x.push_back(sensor.x()), y.push_back(sensor.y()),
        z.push_back(sensor.z());
    range.push_back((p - sensor).norm()), time.push_back(3);
  };
  for (int i = 0; i < 3000; ++i) {  // shoots round the foot, and branches on the ground beside it
    if (const Eigen::Vector3f p(leaf(random), leaf(random), 1.1F * unit(random)); p.head<2>().norm() > 0.14F) add(p);
    const float t = along(random);
    add({0.6F + 0.3F * t + 0.2F * slash(random), t, 0.15F + std::abs(slash(random))});
  }
  cloud.points.set_positions(std::move(positions));
  cloud.points.set_column(arrays::height_above_ground, std::move(height)),
      cloud.points.set_column(arrays::range, std::move(range));
  cloud.points.set_column(arrays::sensor_x, std::move(x)), cloud.points.set_column(arrays::sensor_y, std::move(y));
  cloud.points.set_column(arrays::sensor_z, std::move(z)), cloud.points.set_column(arrays::time, std::move(time));
  const auto survey = measure(cloud);
  ASSERT_EQ(survey.stems.size(), 1U);
  EXPECT_NEAR(200 * survey.stems[0].radius, 25, 0.6);
}

// A scanner that shares nothing with the fit but the laws of light, and is noisier than it says.
TEST(MeasureStems, AForeignScannerIsMeasuredAsWellAsByCircles) {
  synthetic::ForeignOptions o;
  o.noise = 0.025, o.voxel = 0, o.column = 0.015, o.side = 3, o.seed = 7;
  const auto cloud = synthetic::ForeignScanner(o).scan();
  const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, {}, {});
  ASSERT_EQ(survey.stems.size(), cloud.stems.size());
  double bias = 0, square = 0;
  int held = 0;
  for (const auto& t : cloud.stems) {
    const Eigen::Vector2d at = t.base + 1.3 * t.slope;
    const auto it = std::ranges::min_element(survey.stems, {},
                                             [&](const Stem& s) { return (s.breast_height.head<2>() - at).norm(); });
    const double error = 200 * it->radius - 100 * t.dbh, n = static_cast<double>(cloud.stems.size());
    bias += error / n, square += error * error / n;
    held += t.dbh >= 2 * it->radius_low && t.dbh <= 2 * it->radius_high;
  }
  EXPECT_LT(std::abs(bias), 0.3);
  EXPECT_LT(std::sqrt(square), 0.6);
  EXPECT_GE(held, 8);
  EXPECT_THAT(survey.report.findings, testing::Contains(testing::Field(&Finding::code, "noise_high")));
}

TEST(Slice, KeepsTheLayerAndNamesItsHeight) {
  const auto cloud = make_stem_cloud(random_stand(1, 0.2, 0.2, 8), coarse());
  SliceOptions o;
  o.height = 1.37;
  const auto slice = breast_height_slice(cloud.points, o, {});
  for (const float h : slice.values<float>(arrays::height_above_ground)) EXPECT_NEAR(h, 1.37, 0.0501);
  EXPECT_EQ(slice_height(slice), 1.37);
  EXPECT_EQ(slice_height(slice.subset({0})), 1.37);
  auto plain = slice;  // of another program
  plain.facts.clear();
  EXPECT_NEAR(slice_height(plain), 1.37, 0.0101);  // scan lines leave the edges of the slice empty
  o.height = 5, o.thickness = 0.01;
  auto low = cloud.points;
  low.set_column(arrays::height_above_ground, std::vector<float>(low.size(), 0.5F));
  try {
    breast_height_slice(low, o, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("heights run from 0.50 to 0.50 m"));
  }
}

}  // namespace
}  // namespace bole::stems
