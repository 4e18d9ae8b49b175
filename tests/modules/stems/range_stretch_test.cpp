#include "stems/core/shared/range_stretch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stems/core/measure_stems.h"
#include "stems/core/shared/pooled_priors.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

synthetic::StemCloud stretched_stand(unsigned seed, double stretch) {
  synthetic::StemCloudOptions o;
  o.azimuth_step = 0.3, o.pass_step = 0.5, o.passes = 4, o.seed = seed;
  auto cloud = synthetic::make_stem_cloud(synthetic::random_stand(8, 0.12, 0.40, seed), o);
  if (stretch != 0) cloud.points = without_stretch(cloud.points, -stretch, {});
  return cloud;
}

// The rays of the stand are thin.
MeasureOptions thin_rays() {
  MeasureOptions o;
  o.beam_divergence_mrad = 0, o.beam_aperture = 0;
  return o;
}

// Once and no more.
bool tells(const Report& report, const std::string& code) {
  return std::ranges::count_if(report.findings, [&](const auto& f) { return f.code == code; }) == 1;
}

struct ErrorsOfWalk {
  int found = 0, held = 0;
  double bias_cm = 0;
};

ErrorsOfWalk errors_of_walk(const StemSurvey& survey, const synthetic::StemCloud& truth) {
  ErrorsOfWalk e;
  for (const auto& t : truth.stems)
    for (const auto& s : survey.stems)
      if ((s.breast_height.head<2>() - t.base - 1.3 * t.direction().head<2>()).norm() < 0.10) {
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

TEST(RangeStretch, PointsWithoutASensorStay) {
  auto cloud = stretched_stand(1, 0).points;
  auto x = cloud.values<float>(arrays::sensor_x);
  x[0] = std::numeric_limits<float>::quiet_NaN();
  cloud.set_column(arrays::sensor_x, std::move(x));
  const auto moved = without_stretch(cloud, 0.01, {});
  EXPECT_EQ(moved.positions()[0], cloud.positions()[0]);
  const Eigen::Vector2f sensor(cloud.values<float>(arrays::sensor_x)[1], cloud.values<float>(arrays::sensor_y)[1]),
      before = cloud.positions()[1].head<2>() - sensor, after = moved.positions()[1].head<2>() - sensor;
  EXPECT_NEAR(after.norm(), 0.99F * before.norm(), 1e-4);
  EXPECT_EQ(moved.positions()[1].z(), cloud.positions()[1].z());
}

TEST(RangeStretch, StemsOfAWalkThatIsTooShortHaveTheirDiameters) {
  for (const double stretch : {0.004, -0.004}) {
    const auto cloud = stretched_stand(5, stretch);
    const auto survey = measure_stems(cloud.points, usual_breast_height_m, cloud.dem, nullptr, thin_rays(), {});
    const auto e = errors_of_walk(survey, cloud);
    EXPECT_EQ(e.found, 8);
    EXPECT_GE(e.held, 7) << stretch;
    EXPECT_LT(std::abs(e.bias_cm), 0.25) << stretch;
    EXPECT_NEAR(survey.report.metrics.at("range_stretch").value, 100 * stretch, 0.05);
    EXPECT_TRUE(tells(survey.report, stretch > 0 ? "walk_too_short" : "walk_too_long"));
    EXPECT_EQ(survey.points.positions(), cloud.points.positions());  // the cloud itself stays as it is
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
}

}  // namespace
}  // namespace bole::stems
