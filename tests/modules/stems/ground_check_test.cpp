// Stems on a terrain that is not their ground are told, each and in the report.
#include <gmock/gmock.h>

#include <algorithm>

#include "cloud/core/height_facts.h"
#include "measured.h"
#include "stems/core/measure_stems.h"
#include "synthetic/stem_cloud.h"

namespace bole::stems {
namespace {

using synthetic::StemCloud;
using ::testing::HasSubstr;

// Nine stems seen all round, the terrain as ground.model tells it. `lowest`: of the points; `terrain`: height of the
// terrain model above the ground; `ground`: whether returns from the ground are in the cloud.
StemCloud stand_on_terrain(double lowest, double terrain, bool ground) {
  synthetic::StemCloudOptions o;
  o.pass_step = 0.5, o.azimuth_step = 0.4, o.rays = false, o.time = false;
  auto made = synthetic::make_stem_cloud(synthetic::random_stand(9, 0.2, 0.4, 3), o);
  PointCloud::Positions positions;
  for (const auto& p : made.points.positions())
    if (p.z() >= static_cast<float>(lowest)) positions.push_back(p);
  if (ground)
    for (float x = -6; x <= 6; x += 0.1F)
      for (float y = -6; y <= 6; y += 0.1F) positions.emplace_back(x, y, 0.0F);
  std::vector<float> height;
  std::vector<std::uint8_t> classes;
  for (const auto& p : positions) {
    height.push_back(p.z() - static_cast<float>(terrain));
    classes.push_back(std::abs(height.back()) < 0.15F ? 2 : 1);
  }
  const auto axes = made.points.axes;
  made.points = PointCloud(std::move(positions));
  made.points.axes = axes;
  made.points.set_column(arrays::height_above_ground, std::move(height));
  made.points.set_column(arrays::classification, std::move(classes));
  set_fact(made.points.facts, facts::terrain, "ground");
  for (auto& z : made.dem.values) z += static_cast<float>(terrain);
  return made;
}

const Finding* finding(const Report& report, const std::string& code) {
  const auto it = std::ranges::find(report.findings, code, &Finding::code);
  return it == report.findings.end() ? nullptr : &*it;
}

std::size_t with_reason(const StemSurvey& survey, const std::string& words) {
  return static_cast<std::size_t>(std::ranges::count_if(survey.stems, [&](const Stem& s) {
    return std::ranges::any_of(s.reasons, [&](const auto& r) { return r.text().find(words) != std::string::npos; });
  }));
}

TEST(GroundCheck, GroundAroundEveryStemIsNoReason) {
  const auto survey = measure(stand_on_terrain(0, 0, true));
  EXPECT_EQ(survey.stems.size(), 9U);
  EXPECT_TRUE(survey.report.findings.empty());
  EXPECT_EQ(survey.report.counts.at("points_below_terrain"), 0);
}

TEST(GroundCheck, StemsThatGoOnBelowTheTerrainAreRefused) {
  const auto survey = measure(stand_on_terrain(0, 0.8, true));
  const auto* told = finding(survey.report, "points_below_terrain");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->severity, Severity::refused);
  EXPECT_EQ(with_reason(survey, "below the terrain"), survey.stems.size());
  for (const auto& s : survey.stems) {
    EXPECT_EQ(s.quality, "poor");
    EXPECT_EQ(s.state, "check");
  }
}

TEST(GroundCheck, WithoutGroundTheTerrainIsInterpolated) {
  const auto survey = measure(stand_on_terrain(0, 0, false));
  const auto* told = finding(survey.report, "terrain_filled_under_stems");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->severity, Severity::look);
  EXPECT_EQ(with_reason(survey, "no ground seen"), survey.stems.size());
  EXPECT_EQ(std::ranges::count(survey.stems, "good", &Stem::quality), 0);
}

// A cloud that was cut above the ground: as many feet as one likes do not tell by how much.
TEST(GroundCheck, FeetAloneAreNoGroundToSignOn) {
  auto cloud = stand_on_terrain(0, 0, false);
  set_fact(cloud.points.facts, facts::terrain, "feet");
  const auto survey = measure(cloud);
  const auto* told = finding(survey.report, "terrain_filled_under_stems");
  ASSERT_TRUE(told);
  EXPECT_EQ(told->severity, Severity::refused);
  EXPECT_THAT(told->text, HasSubstr("Give the cloud with its ground"));
}

TEST(GroundCheck, StemsWithoutFeetBeginInTheAir) {
  const auto survey = measure(stand_on_terrain(0.8, 0, false));
  const auto* told = finding(survey.report, "stems_begin_in_air");
  ASSERT_TRUE(told);
  EXPECT_THAT(told->text, HasSubstr("Give the cloud with its ground"));
  EXPECT_EQ(with_reason(survey, "begins 0."), survey.stems.size());
  // A hidden foot is harmless where the ground beside it was seen.
  EXPECT_TRUE(measure(stand_on_terrain(0.8, 0, true)).report.findings.empty());
}

TEST(GroundCheck, HeightsOfANormalisedCloudNeedNoGround) {
  auto cloud = stand_on_terrain(0.8, 0, false);
  set_fact(cloud.points.facts, facts::terrain, "normalised");
  EXPECT_TRUE(measure(cloud).report.findings.empty());
}

}  // namespace
}  // namespace bole::stems
