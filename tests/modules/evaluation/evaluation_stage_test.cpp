#include <gmock/gmock.h>

#include <cmath>

#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"

namespace bole {
namespace {

Table one_tree(double x, double dbh) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{1}), t.set("x_m", std::vector<double>{x}),
      t.set("y_m", std::vector<double>{0}), t.set("dbh_cm", std::vector<double>{dbh});
  return t;
}

class EvaluationStage : public testing::Test {
 protected:
  EvaluationStage() { register_all_stages(StageRegistry::global()); }
  StageResult run(const DataSet& in) {
    const auto& type = StageRegistry::global().at("evaluation.plot");
    return run_stage(type, in, OptionSet(*type.options), {});
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

}  // namespace
}  // namespace bole
