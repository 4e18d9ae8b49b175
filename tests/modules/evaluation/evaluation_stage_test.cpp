#include <gmock/gmock.h>

#include <cmath>

#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"

namespace bole::evaluation {
namespace {

Table one_tree(double x, double dbh) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{1}), t.set("x_m", std::vector<double>{x}),
      t.set("y_m", std::vector<double>{0}), t.set("dbh_cm", std::vector<double>{dbh});
  return t;
}

class EvaluationStage : public testing::Test {
 protected:
  EvaluationStage() { pipeline::register_all_stages(pipeline::StageRegistry::global()); }
  pipeline::StageResult run(const DataSet& in) {
    const auto& type = pipeline::StageRegistry::global().at("evaluation.plot");
    return pipeline::run_stage(type, in, OptionSet(*type.options), {});
  }
};

TEST_F(EvaluationStage, WithoutAReferenceTheTablesAreEmptyAndTheReportSaysSo) {
  DataSet in;
  in.set("stems", one_tree(0, 20));
  const auto result = run(in);
  EXPECT_EQ(result.outputs.table("matches").rows(), 0U);
  EXPECT_TRUE(result.outputs.table("matches").has("dbh_error_cm"));
  EXPECT_EQ(result.outputs.table("summary").rows(), 0U);
  EXPECT_THAT(result.report.message, testing::HasSubstr("no reference"));
}

TEST_F(EvaluationStage, ComparesWithAReference) {
  DataSet in;
  in.set("stems", one_tree(0.1, 21)), in.set("reference_stems", one_tree(0, 20));
  const auto result = run(in);
  EXPECT_EQ(result.report.counts.at("matched"), 1);
  EXPECT_NEAR(result.report.metrics.at("dbh_bias").value, 1, 1e-12);
  EXPECT_EQ(result.report.metrics.at("dbh_bias").unit, Unit::centimetre);
}

Table two_rows(double turn_rad, double shift_m) {
  std::vector<std::int64_t> row;
  std::vector<double> x, y;
  for (const int r : {1, 2})
    for (int i = 0; i < 6; ++i) {
      row.push_back(r);
      x.push_back(0.8 * i * std::cos(turn_rad) + shift_m);
      y.push_back(0.8 * i * std::sin(turn_rad) + 3 * r);
    }
  Table t;
  t.set("row_id", row);
  t.set("x_m", x);
  t.set("y_m", y);
  return t;
}

pipeline::StageResult evaluated_rows(double turn_rad, double shift_m) {
  DataSet in;
  in.set("plants", two_rows(turn_rad, shift_m));
  in.set("reference", two_rows(0, 0));
  const auto& type = pipeline::StageRegistry::global().at("evaluation.rows");
  return pipeline::run_stage(type, in, OptionSet(*type.options), {});
}

TEST_F(EvaluationStage, RowsAreJudgedByTheirAngles) {
  const auto result = evaluated_rows(0.02, 0);
  EXPECT_EQ(result.report.counts.at("rows_matched"), 2);
  EXPECT_NEAR(result.report.metrics.at("angle_error_mean").value, 0.02 * 180 / M_PI, 1e-6);
  EXPECT_EQ(result.outputs.table("lines").rows(), 4U) << "two ends of two rows";
  EXPECT_EQ(result.outputs.table("matches").rows(), 2U);
}

TEST_F(EvaluationStage, RowsInOtherAxesAreSuspected) {
  EXPECT_THAT(evaluated_rows(0, 40).report.warnings, testing::Contains(testing::HasSubstr("same axes")));
}

TEST_F(EvaluationStage, WarnsOfTreesWithoutAPlace) {
  auto reference = one_tree(0, 20).subset({0, 0});
  reference.set("x_m", std::vector<double>{0, std::nan("")});
  DataSet in;
  in.set("stems", one_tree(0, 20)), in.set("reference_stems", std::move(reference));
  EXPECT_THAT(run(in).report.warnings, testing::Contains(testing::HasSubstr("have no position")));
}

TEST_F(EvaluationStage, OtherAxesAreSuspectedWhenNothingMatches) {
  DataSet in;
  in.set("stems", one_tree(7, 21)), in.set("reference_stems", one_tree(0, 20));
  EXPECT_THAT(run(in).report.warnings, testing::Contains(testing::HasSubstr("same axes")));
}

// Twelve trees on a spiral, turned.
Table spiral(double turn_rad) {
  std::vector<std::int64_t> id;
  std::vector<double> x, y, dbh;
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.9 * i + turn_rad, distance = 2 + 0.7 * i;
    id.push_back(i + 1), x.push_back(distance * std::cos(angle)), y.push_back(distance * std::sin(angle));
    dbh.push_back(15 + 1.3 * ((7 * i) % 12));
  }
  Table t;
  t.set("tree_id", id), t.set("x_m", x), t.set("y_m", y), t.set("dbh_cm", dbh);
  return t;
}

TEST_F(EvaluationStage, PairsThatMetByChanceAreTold) {
  DataSet in;
  in.set("stems", spiral(0)), in.set("reference_stems", spiral(0));
  EXPECT_TRUE(run(in).report.findings.empty());
  in.set("reference_stems", spiral(0.7));
  const auto turned = run(in);
  ASSERT_EQ(turned.report.findings.size(), 1U);
  EXPECT_EQ(turned.report.findings.front().code, "reference_disagrees");
  EXPECT_THAT(turned.report.findings.front().text, testing::HasSubstr("turned by 40.1 deg"));
  EXPECT_EQ(turned.report.findings.front().severity, Severity::look);
}

// A field list with names, units and a polar origin of its own gives the errors of the list in our own columns.
TEST_F(EvaluationStage, ComparesWithAListWhoseColumnsAreMapped) {
  Table stems;
  stems.set("tree_id", std::vector<std::int64_t>{1, 2}), stems.set("x_m", std::vector<double>{3, 0.05}),
      stems.set("y_m", std::vector<double>{0, -4}), stems.set("dbh_cm", std::vector<double>{21, 30});
  Table list;
  list.set("Nr", std::vector<std::int64_t>{11, 12, 13}), list.set("DIAM", std::vector<double>{200, 310, 250});
  list.set("gon", std::vector<double>{100, 200, 0}), list.set("dist", std::vector<double>{300, 400, 100});
  list.set("plot", std::vector<std::int64_t>{3, 3, 4});
  DataSet in;
  in.set("stems", stems), in.set("reference_stems", list);
  OptionSet options(*pipeline::StageRegistry::global().at("evaluation.plot").options);
  options.set_text("reference_columns", "tree_id=Nr, dbh_cm=DIAM:mm, azimuth_deg=gon:gon, distance_m=dist:cm");
  options.set_text("reference_rows", "plot=3");
  const auto result = pipeline::run_stage(pipeline::StageRegistry::global().at("evaluation.plot"), in, options, {});
  EXPECT_EQ(result.report.counts.at("matched"), 2);
  EXPECT_EQ(result.report.counts.at("missed"), 0) << "the tree of the other plot takes no part";
  EXPECT_NEAR(result.report.metrics.at("dbh_bias").value, (1.0 - 1.0) / 2, 1e-9);
  const auto& matches = result.outputs.table("matches");
  EXPECT_THAT(matches.numbers("ref_dbh_cm"), testing::Pointwise(testing::DoubleNear(1e-9), std::vector{20.0, 31.0}));
  EXPECT_THAT(matches.numbers("dx_m"), testing::Pointwise(testing::DoubleNear(1e-9), std::vector{0.0, 0.05}));
}

TEST_F(EvaluationStage, AMappedColumnThatIsAbsentIsNamed) {
  DataSet in;
  in.set("stems", one_tree(0, 20)), in.set("reference_stems", one_tree(0, 20));
  OptionSet options(*pipeline::StageRegistry::global().at("evaluation.plot").options);
  options.set_text("reference_columns", "dbh_cm=BHD:mm");
  try {
    pipeline::run_stage(pipeline::StageRegistry::global().at("evaluation.plot"), in, options, {});
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::AllOf(testing::HasSubstr("BHD"), testing::HasSubstr("dbh_cm")));
  }
}

TEST_F(EvaluationStage, OrdinaryHeadingsAreGuessedAndTold) {
  Table list;
  list.set("id", std::vector<std::int64_t>{7});
  list.set("x", std::vector<double>{0}), list.set("y", std::vector<double>{0});
  list.set("DBH", std::vector<double>{200}), list.set("Species", std::vector<std::string>{"Fagus sylvatica"});
  DataSet in;
  in.set("stems", one_tree(0.1, 21)), in.set("reference_stems", list);
  const auto result = run(in);
  EXPECT_EQ(result.report.counts.at("matched"), 1);
  EXPECT_NEAR(result.report.metrics.at("dbh_bias").value, 1, 1e-12) << "200 are millimetres";
  EXPECT_EQ(result.outputs.table("matches").texts("species")[0], "Fagus sylvatica");
  ASSERT_EQ(result.report.findings.size(), 1U);
  EXPECT_EQ(result.report.findings[0].code, "reference_columns_guessed");
  EXPECT_THAT(result.report.findings[0].text, testing::HasSubstr("dbh_cm=DBH:mm"));
}

TEST_F(EvaluationStage, AListThatNobodyCanReadIsAFindingThatNamesTheOption) {
  Table list;
  list.set("foo", std::vector<double>{0}), list.set("bar", std::vector<double>{0});
  DataSet in;
  in.set("stems", one_tree(0.1, 21)), in.set("reference_stems", list);
  const auto result = run(in);
  EXPECT_EQ(result.outputs.table("matches").rows(), 0U);
  ASSERT_EQ(result.report.findings.size(), 1U);
  EXPECT_EQ(result.report.findings[0].code, "reference_not_read");
  EXPECT_EQ(result.report.findings[0].severity, Severity::look);
  EXPECT_THAT(result.report.findings[0].text,
              testing::AllOf(testing::HasSubstr("foo, bar"), testing::HasSubstr("evaluate.reference_columns")));
}

}  // namespace
}  // namespace bole::evaluation
