#include "evaluation/core/evaluate_stems.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "evaluation/core/assignment.h"
#include "summary_value.h"

namespace bole::evaluation {

const CountingRule plot{rectangle_area({0, 0}, 32, 32), 7.5};
namespace {

Table trees(const std::vector<std::array<double, 3>>& rows) {
  std::vector<std::int64_t> id;
  std::vector<double> x, y, dbh;
  for (const auto& r : rows)
    id.push_back(static_cast<std::int64_t>(id.size()) + 1), x.push_back(r[0]), y.push_back(r[1]), dbh.push_back(r[2]);
  Table t;
  t.set("tree_id", id), t.set("x_m", x), t.set("y_m", y), t.set("dbh_cm", dbh);
  return t;
}

TEST(Assignment, TheNearestPairIsGivenUpForMorePairs) {
  // Left 0 is nearest to right 0, but left 1 can only take right 0.
  const auto pairs = assign_pairs({{0, 0, 0.1}, {0, 1, 0.4}, {1, 0, 0.2}});
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].right, 1U);
  EXPECT_EQ(pairs[1].right, 0U);
}

TEST(Assignment, OfEquallyManyPairsTheCheapestSetWins) {
  const auto pairs = assign_pairs({{0, 0, 1}, {0, 1, 2}, {1, 0, 2}, {1, 1, 4}, {5, 7, 3}});
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_EQ(pairs[0].right, 1U);  // 2 + 2 < 1 + 4
  EXPECT_EQ(pairs[1].right, 0U);
  EXPECT_EQ(pairs[2].right, 7U);
  EXPECT_TRUE(assign_pairs({}).empty());
}

TEST(EvaluateStems, MeasuresAreThoseOfThePaper) {
  // Errors (0.1, 0), (-0.1, 0.2), DBH +1 and -2 cm on 20 and 40 cm.
  const auto e = evaluate_stems(trees({{1.1, 2, 21}, {-5.1, 3.2, 38}}), trees({{1, 2, 20}, {-5, 3, 40}}), {}, plot);
  EXPECT_EQ(e.matched, 2U);
  EXPECT_NEAR(value(e.summary, "position_mean_x"), 0.0, 1e-12);
  EXPECT_NEAR(value(e.summary, "position_mean_y"), 0.1, 1e-12);
  // Deviations (0.1, -0.1), (-0.1, 0.1): Sigma = [[0.01, -0.01], [-0.01, 0.01]], eigenvalues 0 and 0.02.
  EXPECT_NEAR(value(e.summary, "position_cov_xy"), -0.01, 1e-12);
  EXPECT_NEAR(value(e.summary, "position_sigma_x"), 0.1, 1e-12);
  EXPECT_NEAR(value(e.summary, "position_sigma_max"), std::sqrt(0.02), 1e-12);
  EXPECT_NEAR(value(e.summary, "position_rmse_x"), 0.1, 1e-12);
  EXPECT_NEAR(value(e.summary, "position_rmse_y"), std::sqrt(0.02), 1e-12);
  EXPECT_NEAR(value(e.summary, "dbh_bias"), -0.5, 1e-12);
  EXPECT_NEAR(value(e.summary, "dbh_relative_bias"), 0.0, 1e-12);  // +5 % and -5 %
  EXPECT_NEAR(value(e.summary, "dbh_rmse"), std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(value(e.summary, "dbh_relative_rmse"), 5.0, 1e-12);
}

TEST(EvaluateStems, TreesCountByPlaceAndDiameter) {
  const auto reference = trees({{0, 0, 20}, {5, 5, 20}, {-5, 5, 6}, {16.2, 0, 30}});
  const auto estimate = trees({
      {0.1, 0, 20},   // matched
      {-5, 5.1, 8},   // matches a tree below min_dbh: neither matched nor false
      {15.9, 0, 30},  // inside, but its tree stands just outside: not false
      {10, -10, 15},  // false
      {-10, -10, 5},  // too thin to be false
      {30, 30, 25},   // outside
  });
  const auto e = evaluate_stems(estimate, reference, {}, plot);
  EXPECT_EQ(e.matched, 1U);
  EXPECT_EQ(e.missed, 1U);
  EXPECT_EQ(e.extra, 1U);
  EXPECT_NEAR(value(e.summary, "completeness"), 50, 1e-12);
  EXPECT_NEAR(value(e.summary, "correctness"), 50, 1e-12);
  EXPECT_THAT(e.matches.texts("kind"), testing::ElementsAre("matched", "missed", "false"));
  EXPECT_THAT(e.matches.integers("tree_id"), testing::ElementsAre(1, 0, 4));
  EXPECT_THAT(e.matches.integers("ref_id"), testing::ElementsAre(1, 2, 0));
  const CountingRule circle{circle_area({0, 0}, 6), 7.5};
  EXPECT_EQ(evaluate_stems(estimate, reference, {}, circle).missed, 0U);  // (5, 5) lies 7.07 m out
}

TEST(EvaluateStems, GatesAndClasses) {
  const auto reference = trees({{0, 0, 12}, {0.3, 0, 31}});
  // Positions alone would cross the pairs; diameters tell them apart.
  const auto e = evaluate_stems(trees({{0.2, 0, 12.5}, {0.1, 0, 30}}), reference, {}, plot);
  EXPECT_THAT(e.matches.numbers("dbh_error_cm"),
              testing::UnorderedElementsAre(testing::DoubleNear(0.5, 1e-9), testing::DoubleNear(-1, 1e-9)));
  EXPECT_NEAR(value(e.summary, "dbh_12_to_16_cm_bias"), 0.5, 1e-12);
  EXPECT_NEAR(value(e.summary, "dbh_28_to_32_cm_trees"), 1, 1e-12);
  EXPECT_NEAR(value(e.summary, "distance_0_to_5_m_completeness"), 100, 1e-12);
  EvaluationOptions tight;
  tight.match_distance_m = 0.05;
  EXPECT_EQ(evaluate_stems(trees({{0.2, 0, 12.5}, {0.1, 0, 30}}), reference, tight, plot).matched, 0U);
}

TEST(EvaluateStems, IntervalsAreCountedThatHoldTheTruth) {
  auto estimate = trees({{0, 0, 20}, {5, 5, 30}});
  estimate.set("dbh_lo_cm", std::vector<double>{19, 30.5}), estimate.set("dbh_hi_cm", std::vector<double>{21, 31});
  EXPECT_NEAR(
      value(evaluate_stems(estimate, trees({{0, 0, 20.9}, {5, 5, 30}}), {}, plot).summary, "dbh_interval_coverage"), 50,
      1e-12);
}

TEST(EvaluateStems, ARigidMotionIsTakenOutWhenAsked) {
  const auto reference = trees({{0, 0, 20}, {8, 0, 20}, {0, 8, 20}, {-8, -8, 20}});
  std::vector<std::array<double, 3>> moved;
  const Eigen::Rotation2Dd turn(0.01);
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d p =
        turn * Eigen::Vector2d(reference.numbers("x_m")[i], reference.numbers("y_m")[i]) + Eigen::Vector2d(0.2, -0.1);
    moved.push_back({p.x(), p.y(), 20});
  }
  EvaluationOptions o;
  EXPECT_GT(value(evaluate_stems(trees(moved), reference, o, plot).summary, "position_rmse_x"), 0.1);
  o.align_stems = AlignStems::rigid;
  EXPECT_LT(value(evaluate_stems(trees(moved), reference, o, plot).summary, "position_rmse_x"), 1e-9);
}

TEST(EvaluateStems, PublishedFiguresStandBesideOurs) {
  EvaluationOptions o;
  o.published_plot = PublishedPlot::plot2;
  const auto summary = evaluate_stems(trees({{0, 0, 20}}), trees({{0, 0, 20}}), o, plot).summary;
  const auto& names = summary.texts("measure");
  const auto at = std::ranges::find(names, "dbh_rmse");
  ASSERT_NE(at, names.end());
  EXPECT_EQ(summary.texts("published")[static_cast<std::size_t>(at - names.begin())], "1.07");
}

// Places as a survey in UTM has them, and no plot: no rings about a point that nobody chose.
TEST(EvaluateStems, WithoutAPlotThereAreNoRings) {
  const auto utm = trees({{512345, 5412345, 5}, {512355, 5412345, 32}, {512365, 5412345, std::nan("")}});
  const auto e = evaluate_stems(utm, utm, {}, {});
  EXPECT_EQ(e.matched, 3U);  // thin ones and those without a diameter too
  const auto& names = e.summary.texts("measure");
  EXPECT_TRUE(std::ranges::none_of(names, [](const auto& n) { return n.starts_with("distance_"); }));
  EXPECT_EQ(std::ranges::count_if(names, [](const auto& n) { return n.ends_with("_cm_trees"); }), 2);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  const CountingRule around{circle_area({512345, 5412345}, 25), 0};
  EXPECT_EQ(value(evaluate_stems(utm, utm, {}, around).summary, "distance_10_to_15_m_trees"), 1);
}

TEST(EvaluateStems, RejectedStemsTakeNoPart) {
  const auto reference = trees({{0, 0, 20}, {5, 5, 20}});
  auto estimate = trees({{0, 0, 20}, {5, 5, 20}, {-5, 5, 20}});
  estimate.set("state", std::vector<std::string>{"accepted", "rejected", "rejected"});
  const auto e = evaluate_stems(estimate, reference, {}, plot);
  EXPECT_EQ(e.matched, 1U);
  EXPECT_EQ(e.missed, 1U);
  EXPECT_EQ(e.extra, 0U);
  EXPECT_THAT(e.matches.integers("tree_id"), testing::ElementsAre(1, 0));
}

TEST(EvaluateStems, FieldListsNameTheirTreesAsTheyLike) {
  auto reference = trees({{0, 0, 20}, {5, 5, 20}, {-5, 5, 20}});
  const auto estimate = trees({{0, 0, 20}, {5, 5, 20}});
  reference.set("tree_id", std::vector<std::string>{"A12", "7", ""});
  const auto named = evaluate_stems(estimate, reference, {}, plot).matches;
  EXPECT_THAT(named.integers("ref_id"), testing::ElementsAre(8, 7, 9));
  EXPECT_THAT(named.texts("ref_name"), testing::ElementsAre("A12", "", ""));
  EXPECT_FALSE(named.has("tree_name"));
  reference.set("tree_id",
                std::vector<double>{4, std::nan(""), 1000000});  // what a blank makes of a column of whole numbers
  const auto blank = evaluate_stems(estimate, reference, {}, plot).matches;
  EXPECT_THAT(blank.integers("ref_id"), testing::ElementsAre(4, 1000001, 1000000));
  EXPECT_FALSE(blank.has("ref_name"));
}

TEST(EvaluateStems, ATreeWithoutAPlaceIsToldAndLeftOut) {
  const auto e = evaluate_stems(trees({{0, 0, 20}}), trees({{0, 0, 20}, {std::nan(""), 3, 20}}), {}, plot);
  EXPECT_EQ(e.matched, 1U);
  EXPECT_EQ(e.missed, 0U);
  EXPECT_THAT(e.warnings, testing::ElementsAre("1 of 2 rows of the reference have no position and are left out"));
}

TEST(EvaluateStems, AbsentColumnsAndPositionsAreNamed) {
  Table empty;
  empty.set("x_m", std::vector<double>{1});
  EXPECT_THROW(evaluate_stems(empty, trees({{0, 0, 1}}), {}, plot), Error);
  try {
    evaluate_stems(trees({{0, std::nan(""), 20}}), trees({{0, 0, 20}}), {}, plot);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("no row of the stems has a position"));
  }
}

}  // namespace
}  // namespace bole::evaluation
