#include "base/markup.h"

#include <gtest/gtest.h>

namespace bole {
namespace {

TEST(Markup, SpecialCharactersAreHarmless) {
  EXPECT_EQ(escaped("<a href=\"x\">'&'\x01"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;");
  EXPECT_EQ(escaped("32 m × 32 m"), "32 m × 32 m");
}

}  // namespace
}  // namespace bole
