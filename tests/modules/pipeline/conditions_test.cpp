// Conditions of options, over all stages.
#include <gtest/gtest.h>

#include "pipeline/register_all_stages.h"
#include "pipeline/stage.h"

namespace bole::pipeline {
namespace {

// What is greyed when a stage is new: options of a choice that is not the default.
std::string unmet_by_default(const StageType& type) {
  const OptionSet defaults(*type.options);
  std::string names;
  for (const auto& spec : type.options->specs)
    if (type.options->unmet(spec, [&](const OptionSpec& o) { return defaults.get(o.name); })) names += spec.name + " ";
  return names;
}

TEST(Conditions, HoldByDefaultButForChoicesThatAreNot) {
  StageRegistry registry;
  register_all_stages(registry);
  EXPECT_EQ(unmet_by_default(registry.at("slam.run")), "");
  EXPECT_EQ(unmet_by_default(registry.at("ground.model")), "");
  EXPECT_EQ(unmet_by_default(registry.at("stems.measure")), "");
  EXPECT_EQ(unmet_by_default(registry.at("rows.trunks")), "range_sigma reach min_diameter min_height min_filled ");
  int greyed = 0;
  for (const auto* type : registry.all()) greyed += !unmet_by_default(*type).empty();
  EXPECT_GT(greyed, 2);
}

}  // namespace
}  // namespace bole::pipeline
