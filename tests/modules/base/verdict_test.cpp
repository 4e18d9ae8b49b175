#include "base/verdict.h"

#include <gtest/gtest.h>

namespace bole {
namespace {

StageRecord record(const std::string& id, Report report) { return {id, "test." + id, {}, std::move(report), false}; }

TEST(Verdict, RunWithoutFindingsMayBeSigned) {
  EXPECT_EQ(judge({}).verdict, Verdict::sign);
  EXPECT_EQ(judge({record("a", {}), record("b", {})}).verdict, Verdict::sign);
}

TEST(Verdict, WorstFindingDecidesAndStandsFirst) {
  Report ground;
  ground.find(Severity::look, "terrain_filled", "terrain filled under 3 stems");
  Report stems;
  stems.find(Severity::note, "bark", "bark relief of 1.5 mm assumed");
  stems.find(Severity::refused, "too_sparse", "6 points per stem, 40 needed");
  const auto judged = judge({record("ground", ground), record("stems", stems)});
  EXPECT_EQ(judged.verdict, Verdict::refused);
  ASSERT_EQ(judged.findings.size(), 3u);
  EXPECT_EQ(judged.findings[0].finding.code, "too_sparse");
  EXPECT_EQ(judged.findings[0].stage, "stems");
  EXPECT_EQ(judged.findings[1].finding.code, "terrain_filled");
  EXPECT_EQ(judged.findings[2].finding.code, "bark");
}

TEST(Verdict, WarningsAreNotesAndNoFindingIsListedTwice) {
  Report report;
  report.warn("12 points without coordinates were left out");
  report.find(Severity::look, "tilted", "the cloud leans by 5 deg");
  EXPECT_EQ(report.warnings.size(), 2u);  // shown wherever warnings are
  const auto judged = judge({record("scan", report)});
  EXPECT_EQ(judged.verdict, Verdict::look);
  ASSERT_EQ(judged.findings.size(), 2u);
  EXPECT_EQ(judged.findings[0].finding.code, "tilted");
  EXPECT_EQ(judged.findings[1].finding.code, "warning");
}

TEST(Verdict, ResultThatEndedEarlyIsNotSignedUnseen) {
  Report report;
  report.status = Status::finished_early;
  const auto judged = judge({record("slam", report)});
  EXPECT_EQ(judged.verdict, Verdict::look);
  EXPECT_EQ(judged.findings.at(0).finding.code, "finished_early");
}

TEST(Verdict, TheHeadlineHasTheTreesToLookAt) {
  EXPECT_EQ(verdict_headline(Verdict::sign), "Nothing speaks against signing");
  EXPECT_EQ(verdict_headline(Verdict::sign, 1), "Sign after a look at 1 tree");
  EXPECT_EQ(verdict_headline(Verdict::sign, 2), "Sign after a look at 2 trees");
  EXPECT_EQ(verdict_headline(Verdict::look, 2), "Look before you sign");
  EXPECT_EQ(verdict_headline(Verdict::refused), "Do not use these values");
}

}  // namespace
}  // namespace bole
