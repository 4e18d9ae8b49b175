#include "base/core/path_list.h"

#include <gmock/gmock.h>

namespace bole {
namespace {

OptionSpec spec_of(TextKind kind, std::vector<std::string> choices) {
  OptionSpec spec;
  spec.default_value = std::string();
  spec.text_kind = kind;
  spec.choices = std::move(choices);
  return spec;
}

TEST(PathList, ListsAreCutAtCommasAndFreedOfBlanks) {
  const auto list = spec_of(TextKind::input_path, {path_separator});
  EXPECT_TRUE(is_path_list(list));
  EXPECT_THAT(input_paths(list, "a, b c ,/d"), testing::ElementsAre("a", "b c", "/d"));
  EXPECT_THAT(input_paths(list, " ,, "), testing::IsEmpty());
}

TEST(PathList, AnOrdinaryPathMayHoldACommaAndBlanks) {
  const auto one = spec_of(TextKind::input_path, {});
  EXPECT_FALSE(is_path_list(one));
  EXPECT_THAT(input_paths(one, "plot 1, north.laz "), testing::ElementsAre("plot 1, north.laz "));
  EXPECT_FALSE(is_path_list(spec_of(TextKind::choice, {path_separator})));
}

}  // namespace
}  // namespace bole
