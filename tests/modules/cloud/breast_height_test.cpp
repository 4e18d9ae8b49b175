#include "cloud/breast_height.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace bole {
namespace {

TEST(BreastHeight, TravelsWithTheTable) {
  Table t;
  EXPECT_EQ(breast_height_m(t), 1.3);  // of field lists
  set_breast_height_m(t, 1.37);
  t.set("tree_id", std::vector<std::int64_t>{1, 2});
  EXPECT_EQ(breast_height_m(t), 1.37);
  EXPECT_EQ(breast_height_m(t.subset({1})), 1.37);
}

TEST(BreastHeight, WhatIsNoneIsToldAndNotTaken) {
  for (const char* text : {"", "breast", "1.3 m", "nan", "-1.3", "130", "1e999"}) {
    Table t;
    t.facts["breast_height_m"] = text;
    try {
      breast_height_m(t);
      ADD_FAILURE() << text;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      EXPECT_THAT(e.what(), testing::HasSubstr("for its breast height"));
    }
  }
}

}  // namespace
}  // namespace bole
