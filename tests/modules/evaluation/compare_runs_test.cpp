#include "evaluation/core/compare_runs.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "evaluation/core/error_measures.h"

namespace bole::evaluation {
namespace {

using testing::HasSubstr;

struct Stand {
  std::vector<double> x, y, dbh;
};

// Trees at random places, at least 1.2 m apart, within 20 m.
Stand stand(unsigned seed, std::size_t trees = 30) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-10, 10), size(12, 40);
  Stand s;
  while (s.x.size() < trees) {
    const double x = place(random), y = place(random);
    bool free = true;
    for (std::size_t i = 0; i < s.x.size(); ++i) free = free && std::hypot(x - s.x[i], y - s.y[i]) > 1.2;
    if (!free) continue;
    s.x.push_back(x);
    s.y.push_back(y);
    s.dbh.push_back(size(random));
  }
  return s;
}

Table table_of(const Stand& s) {
  Table t;
  std::vector<std::int64_t> id;
  for (std::size_t i = 0; i < s.x.size(); ++i) id.push_back(static_cast<std::int64_t>(i) + 1);
  t.set("tree_id", id);
  t.set("x_m", s.x);
  t.set("y_m", s.y);
  t.set("dbh_cm", s.dbh);
  return t;
}

// Every tree off by the same amounts.
Stand shifted(Stand s, double dx_m, double dy_m, double dbh_cm) {
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    s.x[i] += dx_m;
    s.y[i] += dy_m;
    s.dbh[i] += dbh_cm;
  }
  return s;
}

Stand without_first(Stand s, std::size_t n) {
  for (auto* v : {&s.x, &s.y, &s.dbh}) v->erase(v->begin(), v->begin() + static_cast<std::ptrdiff_t>(n));
  return s;
}

ComparedRun run_of(const std::string& name, const Stand& stems, const Stand* reference,
                   const std::string& system = "best") {
  ComparedRun r;
  r.name = name;
  r.system = r.preset = system;
  r.stems = table_of(stems);
  if (reference != nullptr) r.reference = table_of(*reference);
  return r;
}

RunsComparison compare(std::vector<ComparedRun> runs, const CompareOptions& options = {}) {
  return compare_runs(std::move(runs), {}, nullptr, options, {});
}

std::size_t row_where(const Table& t, const std::string& column, const std::string& value, std::size_t nth = 0) {
  const auto& texts = t.texts(column);
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (texts[i] == value && nth-- == 0) return i;
  ADD_FAILURE() << "no row with " << column << " " << value;
  return 0;
}

std::vector<std::string> codes(const Report& report) {
  std::vector<std::string> all;
  for (const auto& f : report.findings) all.push_back(f.code);
  return all;
}

std::string text_of(const Report& report, const std::string& code) {
  for (const auto& f : report.findings)
    if (f.code == code) return f.text;
  return {};
}

TEST(CompareRuns, TwoRunsOfOnePlotWithAReference) {
  const auto truth = stand(1);
  const auto a = shifted(truth, 0.02, -0.01, 0.5), b = shifted(without_first(truth, 3), -0.05, 0.04, -1);
  const auto found = compare({run_of("A", a, &truth, "forest"), run_of("B", b, &truth, "loam")});
  const auto& g = found.groups;
  ASSERT_EQ(g.rows(), 2U) << "a row per run; nothing is pooled where each system has one run";
  EXPECT_EQ(g.texts("plot")[0], g.texts("plot")[1]);
  EXPECT_EQ(g.numbers("matched")[0], 30);
  EXPECT_EQ(g.numbers("matched")[1], 27);
  EXPECT_EQ(g.numbers("missed")[1], 3);
  EXPECT_EQ(g.numbers("extra")[1], 0);
  EXPECT_NEAR(g.numbers("mu_x_m")[0], 0.02, 1e-9);
  EXPECT_NEAR(g.numbers("rmse_y_m")[1], 0.04, 1e-9);
  EXPECT_NEAR(g.numbers("sigma_max_m")[1], 0, 1e-6);
  EXPECT_NEAR(g.numbers("dbh_bias_cm")[1], -1, 1e-9);
  double relative = 0;
  for (std::size_t i = 3; i < 30; ++i) relative += -100 / truth.dbh[i] / 27;
  EXPECT_NEAR(g.numbers("dbh_rel_bias_pct")[1], relative, 1e-9);
  // The later run minus the earlier one.
  const auto& p = found.pairs;
  ASSERT_EQ(p.rows(), 1U);
  EXPECT_EQ(p.texts("name")[0], "B");
  EXPECT_EQ(p.texts("against")[0], "A");
  EXPECT_NEAR(p.numbers("mu_x_m")[0], -0.07, 1e-9);
  EXPECT_NEAR(p.numbers("dbh_bias_cm")[0], -1.5, 1e-9);
  EXPECT_EQ(p.numbers("missed")[0], 3) << "trees that only A has";
  EXPECT_THAT(codes(found.report), testing::IsEmpty());
  EXPECT_EQ(found.trees.rows(), 60U);
}

TEST(CompareRuns, PoolsTheRunsOfASystemOverPlotsByTheirTrees) {
  const auto first = stand(1, 30), second = stand(2, 20);
  const auto found = compare({run_of("A1", shifted(first, 0.03, 0, 1), &first, "forest"),
                              run_of("B1", shifted(first, 0.1, 0, 2), &first, "loam"),
                              run_of("A2", shifted(second, -0.02, 0, -1), &second, "forest"),
                              run_of("B2", shifted(second, 0.1, 0, 2), &second, "loam")});
  const auto& g = found.groups;
  ASSERT_EQ(g.rows(), 6U) << "four runs and two systems";
  EXPECT_EQ(found.report.counts.at("plots"), 2);
  const auto pooled = row_where(g, "scope", "overall");
  EXPECT_EQ(g.texts("system")[pooled], "forest");
  EXPECT_EQ(g.numbers("matched")[pooled], 50);
  EXPECT_NEAR(g.numbers("mu_x_m")[pooled], (30 * 0.03 - 20 * 0.02) / 50, 1e-9) << "by trees, not by plots";
  EXPECT_NEAR(g.numbers("rmse_x_m")[pooled], std::sqrt((30 * 0.0009 + 20 * 0.0004) / 50), 1e-9);
  EXPECT_NEAR(g.numbers("dbh_bias_cm")[pooled], 0.2, 1e-9);
  EXPECT_EQ(found.pairs.rows(), 2U) << "runs of different plots are no pair";
}

TEST(CompareRuns, RunsOfASystemOnOnePlotArePooledThere) {
  const auto truth = stand(4);
  const auto found = compare(
      {run_of("seed 1", shifted(truth, 0.02, 0, 0), &truth), run_of("seed 2", shifted(truth, -0.02, 0, 0), &truth)});
  ASSERT_EQ(found.groups.rows(), 3U);
  EXPECT_EQ(found.groups.texts("scope")[2], "plot");
  EXPECT_EQ(found.groups.integers("runs")[2], 2);
  EXPECT_NEAR(found.groups.numbers("sigma_x_m")[2], 0.02, 1e-9);
}

TEST(CompareRuns, PublishedFiguresAreThoseOfTheSystemAndThePlotOfEachRun) {
  const auto truth = stand(1);
  auto loam = run_of("L", truth, &truth, "loam"), forest = run_of("F", truth, &truth, "forest"),
       best = run_of("B", truth, &truth, "best");
  for (auto* r : {&loam, &forest, &best}) r->plot = "plot1";
  const auto found = compare({loam, forest, best});
  const auto published = found.groups.numbers("published_dbh_rel_bias_pct");
  EXPECT_NEAR(published[0], 12.80, 1e-9);
  EXPECT_NEAR(published[1], 1.22, 1e-9);
  EXPECT_TRUE(std::isnan(published[2])) << "the paper has no such system";
}

TEST(CompareRuns, AnOptionBesideThePresetIsNoSystemOfThePaper) {
  const auto truth = stand(1);
  auto run = run_of("F", truth, &truth, "forest");
  run.system = "forest deskew=once";
  run.plot = "plot1";
  EXPECT_TRUE(std::isnan(compare({run}).groups.numbers("published_dbh_bias_cm")[0]));
}

TEST(CompareRuns, WithoutAReferenceThereAreDifferencesAndNoErrors) {
  const auto truth = stand(1);
  const auto found = compare({run_of("A", truth, nullptr), run_of("B", shifted(truth, 0.03, 0, 1), nullptr)});
  EXPECT_EQ(found.groups.rows(), 0U);
  ASSERT_EQ(found.pairs.rows(), 1U);
  EXPECT_NEAR(found.pairs.numbers("dbh_bias_cm")[0], 1, 1e-9);
  EXPECT_THAT(codes(found.report), testing::ElementsAre("no_reference"));
  EXPECT_EQ(found.trees.texts("against")[0], "A");
}

TEST(CompareRuns, OneRunWithoutAReferenceHasNothingToCompareWith) {
  const auto truth = stand(1);
  EXPECT_THAT(codes(compare({run_of("A", truth, nullptr)}).report), testing::Contains("nothing_compared"));
}

TEST(CompareRuns, RunsOfTwoPlotsAreNotCompared) {
  const auto found = compare({run_of("A", stand(1), nullptr), run_of("B", stand(2), nullptr)});
  EXPECT_EQ(found.pairs.rows(), 0U);
  EXPECT_NE(found.runs.texts("plot")[0], found.runs.texts("plot")[1]);
  EXPECT_THAT(codes(found.report), testing::IsSupersetOf({"runs_disagree", "nothing_compared"}));
  EXPECT_THAT(text_of(found.report, "runs_disagree"), HasSubstr("different plots"));
}

Stand turned(Stand s, double angle_rad, double dx_m) {
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double x = s.x[i], y = s.y[i];
    s.x[i] = std::cos(angle_rad) * x - std::sin(angle_rad) * y + dx_m;
    s.y[i] = std::sin(angle_rad) * x + std::cos(angle_rad) * y;
  }
  return s;
}

TEST(CompareRuns, OtherAxesAreNamedAndAreNotPooled) {
  const auto truth = stand(1);
  const auto found = compare({run_of("A", truth, &truth), run_of("B", turned(truth, 0.7, 4), &truth)});
  EXPECT_EQ(found.runs.integers("agrees")[0], 1);
  EXPECT_EQ(found.runs.integers("agrees")[1], 0);
  EXPECT_THAT(text_of(found.report, "reference_disagrees"),
              testing::AllOf(HasSubstr("other axes"), HasSubstr("-40.1 deg")));
  for (const auto& scope : found.groups.texts("scope")) EXPECT_EQ(scope, "run");
  CompareOptions options;
  options.align_stems = AlignStems::search;
  const auto aligned = compare({run_of("A", truth, &truth), run_of("B", turned(truth, 0.7, 4), &truth)}, options);
  EXPECT_NEAR(aligned.groups.numbers("rmse_x_m")[1], 0, 1e-6);
  EXPECT_EQ(aligned.groups.numbers("matched")[1], 30);
}

TEST(CompareRuns, OtherUnitsAreNamed) {
  const auto truth = stand(1);
  auto feet = truth, millimetres = truth, swapped = truth;
  for (auto* v : {&feet.x, &feet.y})
    for (double& n : *v) n /= 0.3048;
  for (double& n : millimetres.dbh) n *= 10;
  std::swap(swapped.x, swapped.y);
  const auto reason = [&](const Stand& s) {
    return text_of(compare({run_of("A", s, &truth)}).report, "reference_disagrees");
  };
  EXPECT_THAT(reason(feet), HasSubstr("look like feet"));
  EXPECT_THAT(reason(millimetres), HasSubstr("look like millimetres"));
  EXPECT_THAT(reason(swapped), HasSubstr("x and y swapped"));
}

TEST(CompareRuns, WithoutABoundaryTheColumnCountedSaysWhatIsExtra) {
  const auto truth = stand(1);
  auto run = run_of("A", truth, nullptr);
  run.reference = table_of(without_first(truth, 2));  // the run has two stems outside its plot
  EXPECT_EQ(compare({run}).groups.numbers("extra")[0], 2);
  std::vector<std::int64_t> counted(30, 1);
  counted[0] = counted[1] = 0;
  run.stems.set("counted", counted);
  EXPECT_EQ(compare({run}).groups.numbers("extra")[0], 0);
}

TEST(CompareRuns, TheBoundaryOfTheRunSaysWhichTreesCount) {
  const auto truth = stand(1);
  auto run = run_of("A", without_first(truth, 30), &truth);
  run.stems = table_of(truth);
  run.rule = CountingRule{rectangle_area({0, 0}, 10, 10), 7.5};
  std::size_t inside = 0;
  for (std::size_t i = 0; i < truth.x.size(); ++i) inside += std::abs(truth.x[i]) <= 5 && std::abs(truth.y[i]) <= 5;
  const auto found = compare({run});
  EXPECT_EQ(found.groups.numbers("reference_trees")[0], static_cast<double>(inside));
  EXPECT_EQ(found.groups.numbers("extra")[0], 0);
}

TEST(CompareRuns, RunsOfOnePlotAreJudgedByTheSameTrees) {
  const auto truth = stand(1);
  auto a = run_of("A", truth, &truth), b = run_of("B", truth, &truth);
  a.rule = CountingRule{rectangle_area({0, 0}, 10, 10), 7.5};
  const auto shared = compare({a, b});
  EXPECT_EQ(shared.groups.numbers("reference_trees")[1], shared.groups.numbers("reference_trees")[0]);
  EXPECT_LT(shared.groups.numbers("reference_trees")[1], 30);
  EXPECT_THAT(codes(shared.report), testing::ElementsAre("boundary_shared"));
  b.rule = a.rule;
  EXPECT_THAT(codes(compare({a, b}).report), testing::IsEmpty());
  b.rule = CountingRule{rectangle_area({0, 0}, 12, 10), 7.5};
  EXPECT_THAT(text_of(compare({a, b}).report, "boundaries_differ"), HasSubstr("10 m × 10 m"));
  b.rule = CountingRule{rectangle_area({0, 0}, 10, 10), 10};
  EXPECT_THAT(codes(compare({a, b}).report), testing::ElementsAre("boundaries_differ"));
}

TEST(CompareRuns, AListWithOtherHeadingsIsReadByThem) {
  const auto truth = stand(1);
  auto run = run_of("A", truth, &truth);
  Table foreign;
  foreign.set("Tree", *run.stems.find("tree_id"));
  foreign.set("x", truth.x);
  foreign.set("y", truth.y);
  foreign.set("DBH", truth.dbh);
  run.stems = foreign;
  const auto found = compare({run});
  EXPECT_EQ(found.groups.numbers("matched")[0], 30);
  EXPECT_THAT(codes(found.report), testing::Contains("stem_columns_guessed"));
  foreign.remove("DBH");
  run.stems = foreign;
  try {
    compare({run});
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::AllOf(HasSubstr("stems of A"), HasSubstr("Tree, x, y")));
  }
}

Trajectory walk_off(double off_m) {
  Trajectory t;
  for (int i = 0; i <= 100; ++i) {
    StampedPose p;
    p.time_s = 0.1 * i;
    p.T_target_sensor.translation() = Eigen::Vector3d(0.1 * i, std::sin(0.1 * i) + (i % 3 == 0 ? off_m : -off_m), 1.5);
    t.poses.push_back(p);
  }
  return t;
}

TEST(CompareRuns, TrajectoriesAgainstTheReferenceAndEachOther) {
  const auto truth = stand(1);
  auto a = run_of("A", truth, &truth), b = run_of("B", truth, &truth);
  a.trajectory = walk_off(0.01);
  b.trajectory = walk_off(-0.01);
  a.reference_trajectory = b.reference_trajectory = walk_off(0);
  const auto found = compare({a, b});
  EXPECT_NEAR(found.groups.numbers("ate_rmse_m")[0], 0.01, 1e-3);
  EXPECT_NEAR(found.pairs.numbers("ate_rmse_m")[0], 0.02, 2e-3);
  EXPECT_GT(found.groups.numbers("rpe_translation_m")[0], 0);
}

TEST(CompareRuns, AnotherClockIsAFinding) {
  const auto truth = stand(1);
  auto a = run_of("A", truth, &truth);
  a.trajectory = walk_off(0.01);
  a.reference_trajectory = walk_off(0);
  for (auto& p : a.reference_trajectory.poses) p.time_s += 1e9;
  const auto found = compare({a});
  EXPECT_TRUE(std::isnan(found.groups.numbers("ate_rmse_m")[0]));
  EXPECT_THAT(codes(found.report), testing::Contains("trajectory_not_compared"));
}

}  // namespace
}  // namespace bole::evaluation
