#include "stems/core/edits/stem_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace bole::stems {
namespace {

using testing::HasSubstr;

constexpr const char* all_actions = R"([
  {"action": "add", "at": [1.5, 2.25], "dbh_cm": 23.4, "height_m": 17.5, "author": "A. Smith",
   "time": "2026-05-02T10:15:00Z", "reason": "hidden by a shrub"},
  {"action": "delete", "at": [0, 0], "reason": "a post"},
  {"action": "move", "at": [1, 1], "to": [1.1, 1]},
  {"action": "resize", "at": [1, 1], "dbh_cm": 30.125, "was_dbh_cm": 31},
  {"action": "set_height", "at": [1, 1], "height_m": 21},
  {"action": "split", "at": [4, 4], "into": [{"at": [3.9, 4], "dbh_cm": 15}, {"at": [4.1, 4], "dbh_cm": 12}]},
  {"action": "merge", "at": [5, 5], "with": [[5.2, 5], [5.1, 5.1]]},
  {"action": "accept", "at": [6, 6], "was_dbh_cm": 20},
  {"action": "reject", "at": [7, 7]},
  {"action": "note", "at": [8, 8], "text": "bark beetle"},
  {"action": "set_species", "at": [8, 8], "species": "Picea abies"},
  {"action": "tilt", "at": [9, 9], "lean_deg": 4.5, "lean_azimuth_deg": 270}
])";

std::string trouble_with(const std::string& json) {
  try {
    parse_stem_edits(json);
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(StemEdits, GoThroughJsonUnchanged) {
  const auto edits = parse_stem_edits(all_actions);
  ASSERT_EQ(edits.size(), 12U);
  EXPECT_EQ(edits[0].author, "A. Smith");
  EXPECT_EQ(*edits[3].dbh_cm, 30.125);
  EXPECT_EQ(edits[5].into[1].dbh_cm, 12);
  EXPECT_EQ(edits[6].with[1], Eigen::Vector2d(5.1, 5.1));
  EXPECT_EQ(edits[11].lean_deg, 4.5);
  EXPECT_EQ(edits[11].lean_azimuth_deg, 270);
  const auto text = to_json(edits);
  EXPECT_EQ(to_json(parse_stem_edits(text)), text);
  EXPECT_EQ(parse_stem_edits("[]").size(), 0U);
}

TEST(StemEdits, WhatCannotBeMeantIsRefusedByNumber) {
  EXPECT_THAT(trouble_with("nonsense"), HasSubstr("no JSON"));
  EXPECT_THAT(trouble_with("{}"), HasSubstr("no list"));
  EXPECT_THAT(trouble_with(R"([{"action": "accept", "at": [0, 0]}, {"action": "fell", "at": [0, 0]}])"),
              AllOf(HasSubstr("edit 2"), HasSubstr("split, merge")));
  EXPECT_THAT(trouble_with(R"([{"action": "resize", "at": [0, 0]}])"), HasSubstr("resize without dbh_cm"));
  EXPECT_THAT(trouble_with(R"([{"action": "resize", "dbh_cm": 3}])"), HasSubstr("without at"));
  EXPECT_THAT(trouble_with(R"([{"action": "resize", "at": [0, 0], "dbh_cm": -3}])"), HasSubstr("dbh_cm is -3"));
  EXPECT_THAT(trouble_with(R"([{"action": "tilt", "at": [0, 0], "lean_deg": 90, "lean_azimuth_deg": 0}])"),
              HasSubstr("lean_deg is 90"));
  EXPECT_THAT(trouble_with(R"([{"action": "accept", "at": [0, 0], "dbh_cm": 3}])"),
              HasSubstr("does not take 'dbh_cm'"));
  EXPECT_THAT(trouble_with(R"([{"action": "move", "at": [0, 0], "to": [1]}])"), HasSubstr("[x, y]"));
  EXPECT_THAT(trouble_with(R"([{"action": "split", "at": [0, 0], "into": [{"at": [0, 0], "dbh_cm": 3}]}])"),
              HasSubstr("at least 2"));
}

}  // namespace
}  // namespace bole::stems
