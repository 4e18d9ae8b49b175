#include "stems/core/shared/range_stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloud/core/walk_facts.h"
#include "cloud/known_facts.h"
#include "stems/core/measure_stems.h"
#include "stems/core/shared/pooled_priors.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

// As SLAM would have made it.
void make_short(PointCloud& points, double stretch) {
  if (stretch != 0) points = lengthened(points, nullptr, {-stretch, points.origin.head<2>()}, {});
  points.facts.clear();
  set_fact(points.facts, PoseOrigin::estimated);
}

synthetic::StemCloud stretched_stand(unsigned seed, double stretch, synthetic::StemCloudOptions o = {}) {
  o.azimuth_step = 0.3, o.pass_step = 0.5, o.passes = 4, o.seed = seed;
  auto cloud = synthetic::make_stem_cloud(synthetic::random_stand(8, 0.12, 0.40, seed), o);
  make_short(cloud.points, stretch);
  return cloud;
}

// The rays of the stand are thin.
MeasureOptions thin_rays() {
  MeasureOptions o;
  o.beam_divergence_mrad = 0, o.beam_aperture = 0;
  return o;
}

// 0.40 % is told as 0.42 to 0.45, -0.40 % as -0.34 to -0.37 (eight seeds).
constexpr double told_within_pct = 0.07;

// Once and no more.
bool tells(const Report& report, const std::string& code) {
  return std::ranges::count_if(report.findings, [&](const auto& f) { return f.code == code; }) == 1;
}

struct ErrorsOfWalk {
  int found = 0, held = 0;
  double bias_cm = 0, place_m = 0;  // place: the worst
};

ErrorsOfWalk errors_of_walk(const StemSurvey& survey, const synthetic::StemCloud& truth) {
  ErrorsOfWalk e;
  for (const auto& t : truth.stems)
    for (const auto& s : survey.stems)
      if (const double d = (s.breast_height.head<2>() - t.base - 1.3 * t.direction().head<2>()).norm(); d < 0.10) {
        e.place_m = std::max(e.place_m, d);
        ++e.found, e.bias_cm += 200 * s.radius - 100 * t.dbh;
        if (2 * s.radius_low <= t.dbh && t.dbh <= 2 * s.radius_high) ++e.held;
      }
  e.bias_cm /= std::max(1, e.found);
  return e;
}

TEST(RangeStretch, TheMeanFollowsManyStemsAndNoWildOne) {
  std::vector<RangeStretchEvidence> stems(30, {0.003, 0.0002, 0});
  stems.push_back({0.05, 0.0002, 0}), stems.push_back({-0.02, 0.0002, 0});
  const auto mean = mean_range_stretch(stems);
  EXPECT_NEAR(mean.mean, 0.003, 1e-4);
  EXPECT_GT(mean.sd, 5e-5);  // what all stems share is never averaged out
  EXPECT_LT(mean.sd, 2e-4);
}

TEST(RangeStretch, LittleIsDrawnToZero) {
  const auto mean = mean_range_stretch(std::vector<RangeStretchEvidence>(30, {8e-5, 0.0002, 0}));
  EXPECT_GT(mean.mean, 0);
  EXPECT_LT(mean.mean, 6e-5);
  EXPECT_NEAR(mean_range_stretch({}).mean, 0, 1e-9);
}

TEST(RangeStretch, ADoubtOfTheBeamCountsForAll) {
  const std::vector<RangeStretchEvidence> sure(30, {4e-4, 0.0002, 0}), doubted(30, {4e-4, 0.0002, 0.001});
  EXPECT_LT(mean_range_stretch(doubted).mean, 0.5 * mean_range_stretch(sure).mean);
}

Eigen::Vector2f sensor_of(const PointCloud& cloud, std::size_t i) {
  return {cloud.values<float>(arrays::sensor_x)[i], cloud.values<float>(arrays::sensor_y)[i]};
}

TEST(RangeStretch, PointsGoWithTheirSensorAndWithoutOneStay) {
  auto cloud = stretched_stand(1, 0).points;
  auto x = cloud.values<float>(arrays::sensor_x);
  x[0] = std::numeric_limits<float>::quiet_NaN();
  cloud.set_column(arrays::sensor_x, std::move(x));
  cloud.origin = {100, 200, 0};
  const auto moved = lengthened(cloud, nullptr, {0.01, {103, 198}}, {});
  EXPECT_EQ(moved.positions()[0], cloud.positions()[0]);
  const Eigen::Vector2f before = sensor_of(cloud, 1), move = 0.01F * (before - Eigen::Vector2f(3, -2));
  EXPECT_LT((sensor_of(moved, 1) - before - move).norm(), 1e-5);
  EXPECT_LT((moved.positions()[1].head<2>() - cloud.positions()[1].head<2>() - move).norm(), 1e-5);
  EXPECT_EQ(moved.positions()[1].z(), cloud.positions()[1].z());
}

TEST(RangeStretch, APathSaysWhereThePointsGo) {
  PointCloud cloud({{5, 0, 1}, {5, 2, 1}, {9, 9, 1}});
  cloud.set_column(arrays::time, std::vector<double>{0, 1, 7});  // the last is of no time of the path
  Trajectory path;
  for (const double t : {0.0, 1.0}) path.poses.push_back({t, Eigen::Isometry3d(Eigen::Translation3d(10 * t, 0, 0))});
  const auto moved = lengthened(cloud, &path, {0.01, {0, 0}}, {});
  EXPECT_LT((moved.positions()[0] - Eigen::Vector3f(5, 0, 1)).norm(), 1e-6);
  EXPECT_LT((moved.positions()[1] - Eigen::Vector3f(5.1F, 2, 1)).norm(), 1e-6);
  EXPECT_EQ(moved.positions()[2], cloud.positions()[2]);
  EXPECT_FALSE(moved.has(arrays::sensor_x));
  EXPECT_EQ(lengthened(cloud, nullptr, {0.01, {0, 0}}, {}).positions(), cloud.positions());
}

// On a slope, in coordinates far from their origin: the middle of the stems stays, 1 m are 30 cm of height.
TEST(RangeStretch, AMapAnywhereIsMadeLongerAboutItsMiddle) {
  synthetic::StemCloudOptions o;
  o.offset_x = 600000, o.offset_y = 5400000, o.ground_slope = 0.3;
  const auto cloud = stretched_stand(6, 0.004, o);
  const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
  EXPECT_LT((survey.walk.still - Eigen::Vector2d(600000, 5400000)).norm(), 1);
  const auto e = errors_of_walk(survey, cloud);
  EXPECT_EQ(e.found, 8);
  EXPECT_LT(e.place_m, 0.008);  // 0.4 % of the metre between the two middles, and what is told wrong
  EXPECT_NEAR(*fact_number(survey.points.facts, facts::walk_lengthened), 100 * survey.walk.share, 1e-6);
  EXPECT_NEAR(*fact_number(stem_table(survey).facts, facts::walk_lengthened), 100 * survey.walk.share, 1e-6);
  EXPECT_EQ(
      fact_number(
          stem_table(measure_stems(survey.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {})).facts,
          facts::walk_lengthened),
      std::nullopt);
}

template <class T>
std::vector<T> joined(const PointCloud& one, T by_one, const PointCloud& other, T by_other, const ArrayInfo& info) {
  std::vector<T> out;
  for (const T v : one.values<T>(info)) out.push_back(v + by_one);
  for (const T v : other.values<T>(info)) out.push_back(v + by_other);
  return out;
}

// Two stands on flat ground that one walk goes through, to either side of the origin.
synthetic::StemCloud two_stands(float apart_m) {
  const auto one = stretched_stand(5, 0), other = stretched_stand(6, 0);
  const float half_m = apart_m / 2;
  PointCloud::Positions positions;
  for (const auto& p : one.points.positions()) positions.push_back(p - Eigen::Vector3f(half_m, 0, 0));
  for (const auto& p : other.points.positions()) positions.push_back(p + Eigen::Vector3f(half_m, 0, 0));
  synthetic::StemCloud out;
  out.points = PointCloud(std::move(positions));
  out.points.axes = one.points.axes;
  out.points.set_column(arrays::sensor_x, joined(one.points, -half_m, other.points, half_m, arrays::sensor_x));
  for (const auto* info : {&arrays::sensor_y, &arrays::sensor_z, &arrays::height_above_ground})
    out.points.set_column(*info, joined(one.points, 0.0F, other.points, 0.0F, *info));
  out.points.set_column(arrays::time, joined(one.points, 0.0, other.points, 1000.0, arrays::time));
  for (auto stem : one.stems) stem.base.x() -= half_m, out.stems.push_back(stem);
  for (auto stem : other.stems) stem.base.x() += half_m, out.stems.push_back(stem);
  out.dem.origin = {-100, -100}, out.dem.cell_m = 1, out.dem.nx = out.dem.ny = 200;
  out.dem.values.assign(40000, 0);
  return out;
}

// Stems that stand 60 m from the place that stays move by 24 cm, further than a fit looks for bark.
TEST(RangeStretch, StemsFarFromThePlaceThatStaysAreFoundWhereTheyMoveTo) {
  auto cloud = two_stands(120);
  make_short(cloud.points, 0.004);
  const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
  EXPECT_EQ(survey.walk.still, Eigen::Vector2d::Zero());
  EXPECT_NEAR(survey.report.metrics.at("range_stretch").value, 0.4, told_within_pct);
  const auto e = errors_of_walk(survey, cloud);
  EXPECT_EQ(e.found, 16);
  EXPECT_LT(e.place_m, 0.04);  // 0.24 before
  EXPECT_LT(std::abs(e.bias_cm), 0.25);
}

// Poses that were given, or are not known: the ranges may be at fault, and nothing but the diameters follows.
TEST(RangeStretch, AMapThatIsNotOfSlamKeepsItsPlaces) {
  for (const bool known : {true, false}) {
    auto cloud = stretched_stand(5, 0.004);
    cloud.points.facts.clear();
    if (known) set_fact(cloud.points.facts, PoseOrigin::given);
    const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
    EXPECT_TRUE(tells(survey.report, "walk_too_short"));
    EXPECT_EQ(survey.walk.share, 0);
    EXPECT_EQ(survey.points.positions(), cloud.points.positions());
    const auto e = errors_of_walk(survey, cloud);
    EXPECT_GE(e.held, 7);
    EXPECT_LT(std::abs(e.bias_cm), 0.25);
    EXPECT_GT(e.place_m, 0.005);
  }
}

TEST(RangeStretch, TheTerrainGoesWithTheWalk) {
  Raster dem;
  dem.origin = {-10, -10}, dem.cell_m = 0.5, dem.nx = dem.ny = 40;
  for (int i = 0; i < dem.nx * dem.ny; ++i) dem.values.push_back(0.1F * static_cast<float>(i % dem.nx));
  const auto moved = lengthened(dem, {0.01, {2, 0}});
  EXPECT_NEAR(moved.sample(2, 3), dem.sample(2, 3 / 1.01), 1e-6);
  EXPECT_NEAR(moved.sample(2 + 1.01 * 5, -4.04), dem.sample(7, -4), 1e-6);
}

TEST(RangeStretch, TheOriginStaysWhereItLiesAmongTheStems) {
  EXPECT_EQ(still_place({{-3, -3}, {5, 4}}), Eigen::Vector2d::Zero());
  EXPECT_EQ(still_place({{600000, 5400000}, {600020, 5400010}}), Eigen::Vector2d(600010, 5400005));
  EXPECT_EQ(still_place({}), Eigen::Vector2d::Zero());
}

TEST(RangeStretch, StemsOfAWalkOfAnotherLengthHaveTheirDiametersAndPlaces) {
  for (const double stretch : {0.004, -0.004}) {
    const auto cloud = stretched_stand(5, stretch);
    const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
    const auto e = errors_of_walk(survey, cloud);
    EXPECT_EQ(e.found, 8);
    EXPECT_GE(e.held, 7) << stretch;
    EXPECT_LT(std::abs(e.bias_cm), 0.25) << stretch;
    EXPECT_NEAR(survey.report.metrics.at("range_stretch").value, 100 * stretch, told_within_pct);
    EXPECT_TRUE(tells(survey.report, stretch > 0 ? "walk_too_short" : "walk_too_long"));
    EXPECT_LT(e.place_m, 0.002) << stretch;  // 0.4 % of 3 m are 1.2 cm
    EXPECT_EQ(survey.points.positions(), lengthened(cloud.points, nullptr, survey.walk, {}).positions());
  }
}

TEST(RangeStretch, AGoodWalkIsLeftAlone) {
  for (const unsigned seed : {5U, 6U, 7U}) {
    const auto cloud = stretched_stand(seed, 0);
    const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
    EXPECT_LT(std::abs(survey.report.metrics.at("range_stretch").value), 0.02) << seed;
    EXPECT_FALSE(tells(survey.report, "walk_too_short") || tells(survey.report, "walk_too_long"));
  }
}

// Tiles of one cloud say together what one of them alone cannot.
TEST(RangeStretch, IsPooledOverParts) {
  const auto one = stretched_stand(5, 0.004), other = stretched_stand(6, 0.004);
  auto rows = stem_evidence(one.points, usual_breast_height_m, one.dem, nullptr, thin_rays(), {});
  for (auto& row : stem_evidence(other.points, usual_breast_height_m, other.dem, nullptr, thin_rays(), {}))
    rows.push_back(row);
  const auto priors = priors_in(priors_table(pool(evidence_in(evidence_table(rows)), std::nullopt), rows.size()));
  ASSERT_TRUE(priors.range_stretch);
  EXPECT_NEAR(priors.range_stretch->mean, 0.004, 0.0006);
  const auto survey = measure_stems(one.points, usual_breast_height_m, one.dem, nullptr, thin_rays(), {}, &priors);
  EXPECT_LT(std::abs(errors_of_walk(survey, one).bias_cm), 0.35);
  EXPECT_TRUE(tells(survey.report, "walk_too_short"));
  EXPECT_EQ(survey.walk.share, 0) << "a part keeps its place beside the others";
  EXPECT_EQ(survey.points.positions(), one.points.positions());
}

// What comes out and is measured again is as it should be.
TEST(RangeStretch, ACorrectedCloudIsRight) {
  const auto cloud = stretched_stand(5, 0.004);
  const auto first = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
  const auto again = measure_stems(first.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
  EXPECT_EQ(again.walk.share, 0);
  EXPECT_FALSE(tells(again.report, "walk_too_short"));
  EXPECT_LT(errors_of_walk(again, cloud).place_m, 0.002);
}

}  // namespace
}  // namespace bole::stems
