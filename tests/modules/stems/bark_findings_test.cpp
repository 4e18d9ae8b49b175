// What the bark of all stems together says in the report.
#include <gmock/gmock.h>

#include "stems/core/bark_findings.h"

namespace bole::stems {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;

std::vector<Stem> stems_of(std::size_t count, double sigma_m, int inliers = 500) {
  Stem s;
  s.radius = 0.12, s.radius_low = 0.117, s.radius_high = 0.123;
  s.sigma_m = sigma_m, s.inliers = inliers;
  return std::vector<Stem>(count, s);
}

std::vector<Finding> findings(const std::vector<Stem>& stems, bool along_rays, double noise_m = 0) {
  Report report;
  judge_bark(stems, {}, along_rays, noise_m, report);
  return report.findings;
}

auto is(const char* code, Severity severity) {
  return testing::AllOf(Field(&Finding::code, code), Field(&Finding::severity, severity));
}

TEST(BarkFindings, WallsThatDoNotMeetAreToldOfCloudsWithoutRays) {
  EXPECT_THAT(findings(stems_of(6, 0.012), false), testing::IsEmpty());
  EXPECT_THAT(findings(stems_of(6, 0.021), false), ElementsAre(is("bark_blurred", Severity::look)));
  EXPECT_THAT(findings(stems_of(1, 0.021), false), testing::IsEmpty());  // one stem may be rough
}

TEST(BarkFindings, AlongRaysTheNoiseIsTold) {
  EXPECT_THAT(findings(stems_of(6, 0.021), true, 0.015), ElementsAre(is("bark_convention", Severity::note)));
  EXPECT_THAT(findings(stems_of(6, 0.021), true, 0.025),
              ElementsAre(is("noise_high", Severity::look), is("bark_convention", Severity::note)));
}

TEST(BarkFindings, TooFewPointsRefuseDiametersWhereMostStemsHaveThem) {
  auto stems = stems_of(4, 0.01);
  stems[0].inliers = 12;
  EXPECT_THAT(findings(stems, false), ElementsAre(is("stems_sparse", Severity::look)));
  stems[1].inliers = stems[2].inliers = 15;
  const auto most = findings(stems, false);
  EXPECT_THAT(most, ElementsAre(is("stems_sparse", Severity::refused)));
  EXPECT_THAT(most[0].text, HasSubstr("15 found in the middle of 3 of 4 stems"));
}

// The beam is the same for all stems: where a third of them depend on it, somebody must look.
TEST(BarkFindings, AnUnknownBeamIsToldWhereStemsWereSeenInPart) {
  auto stems = stems_of(6, 0.01);
  stems[0].edges_m = 0.008, stems[0].arc_rad = 4.2;
  EXPECT_THAT(findings(stems, false), testing::IsEmpty());
  stems[1].edges_m = 0.009, stems[1].arc_rad = 4.0;
  const auto found = findings(stems, false);
  EXPECT_THAT(found, ElementsAre(is("beam_unknown", Severity::look)));
  EXPECT_THAT(found[0].text, HasSubstr("2 of 6 stems were seen on 241 deg of their bark or less"));
  EXPECT_THAT(found[0].text, HasSubstr("too large by 1.8 cm"));
  EXPECT_THAT(found[0].text, HasSubstr("trajectory.file"));
  for (auto& s : stems) s.rays_known = true;  // the path is there, and the model does not use it
  EXPECT_THAT(findings(stems, false)[0].text, HasSubstr("Set stems.model=ray"));
}

TEST(BarkFindings, NoStemsNoWord) { EXPECT_THAT(findings({}, true, 0.03), testing::IsEmpty()); }

}  // namespace
}  // namespace bole::stems
