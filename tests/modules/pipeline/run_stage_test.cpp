#include <gmock/gmock.h>

#include "modules/pipeline/toy_stages.h"

namespace bole::pipeline {
namespace {

using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

class RunStage : public ::testing::Test {
 protected:
  StageRegistry registry = toy::toy_registry();
  const StageType& slice = registry.at("toy.slice");
  OptionSet options{*slice.options};
};

TEST_F(RunStage, MissingInputsAndArraysAreNamed) {
  DataSet inputs;
  EXPECT_THAT(error_of([&] { run_stage(slice, inputs, options, {}); }),
              HasSubstr("toy.slice: input 'points' is not connected"));
  inputs.set("points", PointCloud({{0, 0, 0}}));
  EXPECT_THAT(error_of([&] { run_stage(slice, inputs, options, {}); }), HasSubstr("no array 'height_above_ground'"));
  inputs.set("points", Table{});
  EXPECT_THAT(error_of([&] { run_stage(slice, inputs, options, {}); }), HasSubstr("is a table; needed: a cloud"));
}

TEST_F(RunStage, RelationsBetweenOptionsAreChecked) {
  options.set("height", 0.1);
  options.set("thickness", 0.5);
  EXPECT_THAT(error_of([&] { run_stage(slice, {}, options, {}); }), HasSubstr("thickness exceeds height"));
}

TEST_F(RunStage, ACancelledRunEndsBeforeItStarts) {
  std::stop_source source;
  source.request_stop();
  bole::Run run;
  run.cancel = source.get_token();
  PointCloud cloud({{0, 0, 0}});
  cloud.set_column(arrays::height_above_ground, std::vector<float>{1});
  DataSet inputs;
  inputs.set("points", cloud);
  try {
    run_stage(slice, inputs, options, run);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.exit_code(), 3);
  }
}

TEST_F(RunStage, TimeAndMemoryAreMeasured) {
  PointCloud cloud({{0, 0, 0}});
  cloud.set_column(arrays::height_above_ground, std::vector<float>{1});
  DataSet inputs;
  inputs.set("points", cloud);
  const auto result = run_stage(slice, inputs, options, {});
  EXPECT_GE(result.report.seconds, 0);
  EXPECT_GT(result.report.peak_mib, 1);
}

TEST(RunControl, PartsShareOneProgress) {
  std::vector<double> seen;
  bole::Run run;
  run.progress = [&](double f, std::string_view) { seen.push_back(f); };
  const auto half = run.part(0.5, 1.0);
  half.report(0, "");
  half.part(0, 0.5).report(1, "");
  EXPECT_THAT(seen, ::testing::ElementsAre(0.5, 0.75));
}

TEST(Registry, UnknownTypesAreAnsweredWithTheNearest) {
  const auto registry = toy::toy_registry();
  EXPECT_THAT(error_of([&] { registry.at("toy.slize"); }), HasSubstr("Did you mean toy.slice"));
}

}  // namespace
}  // namespace bole::pipeline
