#include "survey/core/check/check_survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/verdict.h"
#include "cloud/core/walk_facts.h"
#include "cloud/known_facts.h"
#include "modules/survey/check_plot.h"
#include "survey/core/plot_options.h"

namespace bole::survey {
namespace {

using testing_data::CheckPlot;
using testing_data::PlotMaker;
using testing_data::PlotSpoil;

SurveyCheck checked(const CheckPlot& plot, const CheckOptions& options = {}) {
  return check_survey(plot.inputs(), options, {});
}

std::string verdict(const SurveyCheck& check) { return check.findings.facts.at("verdict"); }

std::string all_findings(const SurveyCheck& check) {
  std::string text;
  for (const auto& f : check.report.findings) text += f.code + ": " + f.text + "\n";
  return text;
}

// The row of a finding, or nothing.
std::optional<std::size_t> row_of(const SurveyCheck& check, const std::string& code) {
  const auto& codes = check.findings.texts("code");
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (codes[i] == code) return i;
  return std::nullopt;
}

std::string text_of(const SurveyCheck& check, const std::string& code) {
  for (const auto& f : check.report.findings)
    if (f.code == code) return f.text;
  return "";
}

TEST(CheckSurvey, AGoodPlotMayBeSigned) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const auto check = checked(PlotMaker(seed).make());
    EXPECT_EQ(verdict(check), "sign") << all_findings(check);
    EXPECT_EQ(check.findings.facts.at("not_judged"), "distance of the targets: the distance by tape is not given");
    EXPECT_EQ(check.cells.rows(), 400u);
    EXPECT_EQ(check.stems.rows(), 25u);
    EXPECT_LT(check.report.metrics.at("wall").value, 1.5);
    EXPECT_LT(check.report.metrics.at("stem_pass_spread").value, 1.0);
    EXPECT_LT(check.report.metrics.at("ground_pass_spread").value, 1.0);
  }
}

TEST(CheckSurvey, AHoleInTheGroundIsFoundWhereItIs) {
  PlotSpoil spoil;
  spoil.no_ground = [](double x, double y) { return std::hypot(x - 4, y + 3) < 2.3; };
  const auto check = checked(PlotMaker(5, spoil).make());
  EXPECT_EQ(verdict(check), "look") << all_findings(check);
  const auto row = row_of(check, "ground_never_seen");
  ASSERT_TRUE(row);
  EXPECT_NEAR(check.findings.numbers("x_m")[*row], 4, 1);
  EXPECT_NEAR(check.findings.numbers("y_m")[*row], -3, 1);
  EXPECT_NEAR(check.findings.numbers("distance_m")[*row], 5, 1);
  EXPECT_NEAR(check.findings.numbers("bearing_deg")[*row], 127, 10);
}

TEST(CheckSurvey, AMissingQuarterSaysWalkAgain) {
  PlotSpoil spoil;
  spoil.no_ground = [](double x, double y) { return x > 0 && y > 0; };
  EXPECT_EQ(verdict(checked(PlotMaker(5, spoil).make())), "walk again");
}

TEST(CheckSurvey, AnAssumedSizeIsTheFirstThingToCheck) {
  PlotSpoil spoil;
  spoil.no_ground = [](double x, double y) { return x > 0 && y > 0; };
  auto plot = PlotMaker(5, spoil).make();
  plot.plot.facts[assumed_size_fact] = "20 m x 20 m";
  const auto check = checked(plot);
  auto row = row_of(check, "plot_partly_empty");
  if (!row) row = row_of(check, "ground_never_seen");
  ASSERT_TRUE(row);
  EXPECT_TRUE(check.findings.texts("text")[*row].starts_with("20 m x 20 m is assumed for the plot (set plot.width"));
}

TEST(CheckSurvey, ALaneThatWasNotWalkedIsFound) {
  PlotSpoil spoil;
  spoil.no_lane = [](int lane) { return lane == 3; };  // at x = 5
  const auto check = checked(PlotMaker(6, spoil).make());
  const auto row = row_of(check, "lane_not_walked");
  ASSERT_TRUE(row) << all_findings(check);
  EXPECT_NEAR(check.findings.numbers("x_m")[*row], 5, 1);
  EXPECT_EQ(verdict(checked(PlotMaker(6).make())), "sign") << "all lanes";
}

TEST(CheckSurvey, PassesThatDoNotMeetAreFound) {
  PlotSpoil spoil;
  spoil.slip = {0, 0, 0.08};
  auto check = checked(PlotMaker(7, spoil).make());
  EXPECT_TRUE(row_of(check, "ground_passes_apart")) << all_findings(check);
  EXPECT_NEAR(check.report.metrics.at("ground_pass_spread").value, 8, 0.5);
  spoil.slip = {0.08, -0.06, 0};
  check = checked(PlotMaker(7, spoil).make());
  EXPECT_TRUE(row_of(check, "stem_passes_apart")) << all_findings(check);
  EXPECT_NEAR(check.report.metrics.at("stem_pass_spread").value, 10, 1);
}

TEST(CheckSurvey, WallsTooThickAreFound) {
  PlotSpoil spoil;
  spoil.wall_noise_m = 0.035;
  EXPECT_TRUE(row_of(checked(PlotMaker(8, spoil).make()), "walls_thick"));
}

// A stand that is mapped twice, half a metre aside, has every tree twice, each seen by one pass.
TEST(CheckSurvey, AStandThatStandsTwiceIsFound) {
  PlotSpoil spoil;
  spoil.slip = {0.9, 0.5, 0};
  auto plot = PlotMaker(9, spoil).make();
  auto x = plot.stems.numbers("x_m"), y = plot.stems.numbers("y_m"), dbh = plot.stems.numbers("dbh_cm");
  const auto n = x.size();
  for (std::size_t i = 0; i < n; ++i) x.push_back(x[i] + 0.9), y.push_back(y[i] + 0.5), dbh.push_back(dbh[i]);
  plot.stems = {};
  plot.stems.set("x_m", x), plot.stems.set("y_m", y), plot.stems.set("dbh_cm", dbh);
  const auto check = checked(plot);
  EXPECT_TRUE(row_of(check, "stand_doubled")) << all_findings(check);
  EXPECT_EQ(verdict(check), "walk again");
}

TEST(CheckSurvey, ATiltedFrameIsFound) {
  PlotSpoil spoil;
  spoil.lean = std::tan(2 * std::numbers::pi / 180);
  const auto check = checked(PlotMaker(10, spoil).make());
  EXPECT_TRUE(row_of(check, "frame_tilted")) << all_findings(check);
  EXPECT_NEAR(check.report.metrics.at("common_lean").value, 2, 0.6);
}

TEST(CheckSurvey, AStandThatLeansUnderAKnownGravityIsNoTiltedFrame) {
  PlotSpoil spoil;
  spoil.lean = std::tan(2 * std::numbers::pi / 180);
  auto plot = PlotMaker(10, spoil).make();
  set_fact(plot.points.facts, facts::level_sigma, 0.05);
  const auto check = checked(plot);
  EXPECT_FALSE(row_of(check, "frame_tilted")) << all_findings(check);
  EXPECT_NEAR(check.report.metrics.at("common_lean").value, 2, 0.6);
  set_fact(plot.points.facts, facts::level_sigma, 1);  // tells the lean from nothing
  EXPECT_TRUE(row_of(checked(plot), "frame_tilted"));
}

TEST(CheckSurvey, AWalkThatIsTooShortIsFound) {
  auto plot = PlotMaker(11).make();
  set_fact(plot.stems.facts, facts::range_stretch, 0.02);
  EXPECT_EQ(verdict(checked(plot)), "sign");
  for (const double stretch_pct : {0.4, -0.4}) {
    set_fact(plot.stems.facts, facts::range_stretch, stretch_pct);
    const auto check = checked(plot);
    ASSERT_TRUE(row_of(check, "walk_length")) << all_findings(check);
    EXPECT_EQ(verdict(check), "look");
    EXPECT_NEAR(check.report.metrics.at("length_error").value, -stretch_pct, 1e-9);
    EXPECT_NE(text_of(check, "walk_length").find("per hectare"), std::string::npos) << all_findings(check);
    auto corrected = plot;
    set_fact(corrected.stems.facts, facts::walk_lengthened, stretch_pct);
    EXPECT_NE(text_of(checked(corrected), "walk_length").find("made to fit"), std::string::npos);
  }
  CheckOptions o;
  o.max_length_error_pct = 0.5;
  EXPECT_FALSE(row_of(checked(plot, o), "walk_length"));
}

TEST(CheckSurvey, TargetsThatAreMissingOrMovedAreFound) {
  auto plot = PlotMaker(11).make();
  CheckOptions o;
  o.target_distance = 8;
  EXPECT_EQ(verdict(checked(plot, o)), "sign");
  o.target_distance = 8.2;
  EXPECT_TRUE(row_of(checked(plot, o), "target_distance"));
  plot.targets = plot.targets.subset({0});
  EXPECT_TRUE(row_of(checked(plot), "target_missing"));
  o = {}, o.targets = 1;
  EXPECT_EQ(verdict(checked(plot, o)), "sign");
}

TEST(CheckSurvey, ALoopThatDisagreesIsFound) {
  PlotMaker maker(12);
  maker.make();
  maker.add_loop(0.3);
  const auto check = checked(maker.plot);
  EXPECT_TRUE(row_of(check, "loops_disagree")) << all_findings(check);
  EXPECT_NEAR(check.report.metrics.at("loop_residual_max").value, 0.3, 1e-6);
}

TEST(CheckSurvey, AStemThatIsNotInTheTableIsFound) {
  auto plot = PlotMaker(13).make();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < plot.stems.rows(); ++i)
    if (i != 7) kept.push_back(i);
  const Eigen::Vector2d left_out(plot.stems.numbers("x_m")[7], plot.stems.numbers("y_m")[7]);
  plot.stems = plot.stems.subset(kept);
  const auto check = checked(plot);
  const auto row = row_of(check, "stems_left_out");
  ASSERT_TRUE(row) << all_findings(check);
  EXPECT_NEAR(check.findings.numbers("x_m")[*row], left_out.x(), 0.05);
  EXPECT_NEAR(check.findings.numbers("y_m")[*row], left_out.y(), 0.05);
}

TEST(CheckSurvey, StemsInEachOtherAndStemsWithoutPointsAreFound) {
  auto plot = PlotMaker(14).make();
  auto x = plot.stems.numbers("x_m");
  auto y = plot.stems.numbers("y_m");
  x[1] = x[0] + 0.05, y[1] = y[0];
  x[2] = x[2] + 1.5;
  plot.stems.set("x_m", x), plot.stems.set("y_m", y);
  const auto check = checked(plot);
  EXPECT_TRUE(row_of(check, "stems_overlap")) << all_findings(check);
  EXPECT_TRUE(row_of(check, "stems_without_points")) << all_findings(check);
}

// One tree of 40 cm whose axis lies 5 cm inside the eastern edge, one 5 cm outside of the southern one.
CheckPlot boundary_plot() {
  CheckPlot plot;
  plot.stems.set("tree_id", std::vector<std::int64_t>{1, 2, 3});
  plot.stems.set("x_m", std::vector<double>{9.95, 0, 3});
  plot.stems.set("y_m", std::vector<double>{0, -10.05, 3});
  plot.stems.set("dbh_cm", std::vector<double>{40, 40, 40});
  plot.plot = to_table({rectangle_area({0, 0}, 20, 20), 7.5});
  return plot;
}

std::vector<std::int64_t> in_by(BoundaryRule rule) {
  const auto plot = boundary_plot();
  CheckInputs in;
  in.stems = &plot.stems, in.plot = &plot.plot;
  CheckOptions o;
  o.boundary_rule = rule;
  const auto check = check_survey(in, o, {});
  EXPECT_EQ(check.boundary.rows(), 2u);
  EXPECT_EQ(row_of(check, "boundary_rule_differs").has_value(),
            rule != BoundaryRule::centre && rule != BoundaryRule::base);
  return check.boundary.integers("in");
}

TEST(CheckSurvey, TreesOnTheBoundaryFollowTheRule) {
  using In = std::vector<std::int64_t>;
  EXPECT_EQ(in_by(BoundaryRule::centre), (In{1, 0}));
  EXPECT_EQ(in_by(BoundaryRule::base), (In{1, 0})) << "without feet the centre";
  EXPECT_EQ(in_by(BoundaryRule::whole), (In{0, 0}));
  EXPECT_EQ(in_by(BoundaryRule::any_part), (In{1, 1}));
  EXPECT_EQ(in_by(BoundaryRule::half), (In{0, 1}));
}

TEST(CheckSurvey, WhatIsNotThereIsSaid) {
  const auto plot = PlotMaker(15).make();
  CheckInputs in;
  EXPECT_THROW(check_survey(in, {}, {}), Error);
  in.stems = &plot.stems;
  EXPECT_THAT(check_survey(in, {}, {}).findings.facts.at("not_judged"), testing::HasSubstr("there is no cloud"));
  in = {};
  in.points = &plot.points;
  EXPECT_THAT(check_survey(in, {}, {}).findings.facts.at("not_judged"), testing::HasSubstr("there is no trajectory"));
}

TEST(CheckSurvey, ADuplicateFindingIsListedOnce) {
  StageRecord plot{"plot", "survey.plot", {}, {}, false}, check{"check", "survey.check", {}, {}, false};
  plot.report.find(Severity::look, "plot_partly_empty", "a");
  check.report.find(Severity::refused, "plot_partly_empty", "b");
  auto judgement = judge({plot, check});
  ASSERT_EQ(judgement.findings.size(), 1u);
  EXPECT_EQ(judgement.findings[0].finding.text, "b");
  check.report.findings[0].severity = Severity::look;
  judgement = judge({plot, check});
  ASSERT_EQ(judgement.findings.size(), 1u);
  EXPECT_EQ(judgement.findings[0].finding.text, "a");
}

}  // namespace
}  // namespace bole::survey
