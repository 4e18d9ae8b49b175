// What is printed of presets.
#include "pipeline/printing.h"

#include <gmock/gmock.h>

#include <regex>

#include "pipeline/register_all_stages.h"

namespace bole::pipeline {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class Printing : public ::testing::Test {
 protected:
  Printing() { register_all_stages(registry_); }
  const StageType& slam() const { return registry_.at("slam.run"); }
  OptionSet with_preset(const char* name) const {
    OptionSet options(*slam().options);
    options.set_text("preset", name);
    return options;
  }
  StageRegistry registry_;
};

bool has_line(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex("(^|\n)" + pattern + "\n"));
}

TEST_F(Printing, ValuesInForceAreThoseOfThePreset) {
  const auto text = values_in_force_text(slam(), with_preset("forest"));
  EXPECT_TRUE(has_line(text, "\\* preset +forest")) << text;
  EXPECT_TRUE(has_line(text, "\\* features +connected")) << text;
  EXPECT_TRUE(has_line(text, "  loop_overlap +0.6")) << text;
  EXPECT_TRUE(has_line(text, "  max_range +60 m")) << text;
}

TEST_F(Printing, WhatIsSetHoldsAgainstThePresetAndIsMarked) {
  auto options = with_preset("best");
  EXPECT_FALSE(has_line(values_in_force_text(slam(), options), "\\* .*"));
  options.set_text("loop_overlap", "0");
  EXPECT_TRUE(has_line(values_in_force_text(slam(), options), "\\* loop_overlap +0"));
}

TEST_F(Printing, ThePageOfAStageHasItsPresetsAsATable) {
  const auto page = stage_markdown(slam());
  EXPECT_THAT(page, HasSubstr("| option | `loam` | `forest` | `lego_loam` | `orchard` | `best` |"));
  EXPECT_THAT(page, HasSubstr("| `refine_iterations` | 0 | 0 | 0 | 0 | 3 |"));
  EXPECT_THAT(stage_markdown(registry_.at("ground.model")), Not(HasSubstr("## Values by")));
}

TEST_F(Printing, TheListOfStagesHasTheirPorts) {
  const auto list = stages_index_markdown(registry_);
  EXPECT_THAT(list, HasSubstr("| [`ground.model`](ground.model.md) | Model the ground | `points`, `terrain`?, "
                              "`point_edits`? | `points`, `dem`"));
  EXPECT_THAT(list, HasSubstr("| [`io.read_table`](io.read_table.md) | Read a table |  | `table` |"));
}

}  // namespace
}  // namespace bole::pipeline
