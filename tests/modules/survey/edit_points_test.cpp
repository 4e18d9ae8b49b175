#include "survey/core/edit_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bole::survey {
namespace {

TEST(EditPoints, EveryEditIsToldAndOneThatHoldsNothingIsAFinding) {
  const PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {10, 0, 0});
  const auto edits = parse_point_edits(R"([
    {"action": "to_noise", "path": [[10, 0, 0], [11, 0, 0]], "radius_m": 0.1, "author": "A. Smith"},
    {"action": "to_tree", "tree": [5, 6], "path": [[0, 0, 0]], "radius_m": 0.1}])");
  const auto edited = edit_points(cloud, edits, {});
  EXPECT_THAT(edited.table.integers("points"), testing::ElementsAre(2, 0));
  EXPECT_THAT(edited.table.numbers("x_m"), testing::ElementsAre(10.5, 5));
  EXPECT_EQ(edited.table.text("author", 0), "A. Smith");
  ASSERT_EQ(edited.report.findings.size(), 1U);
  EXPECT_EQ(edited.report.findings[0].code, "selection_empty");
  EXPECT_THAT(edited.report.findings[0].text, testing::HasSubstr("edit 2 (to_tree)"));
  EXPECT_EQ(edit_points(cloud, {}, {}).table.rows(), 0U);
}

}  // namespace
}  // namespace bole::survey
