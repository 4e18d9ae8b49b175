#include "render/charts/linked_charts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/charts/worst_first.h"

namespace bole::render {
namespace {

Table four_stems() {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{11, 12, 13, 14});
  t.set("dbh_cm", std::vector<double>{20, 21, 30, 25});
  t.set("dbh_lo_cm", std::vector<double>{19, 20.9, std::nan(""), 20});
  t.set("dbh_hi_cm", std::vector<double>{21, 21.1, std::nan(""), 30});
  t.set("height_m", std::vector<double>{18, 19, std::nan(""), 22});
  t.set("quality", std::vector<std::string>{"good", "good", "fair", "poor"});
  return t;
}

TEST(WorstFirst, PutsPoorThenUncertainFirst) {
  EXPECT_EQ(worst_first(four_stems()), (std::vector<std::size_t>{3, 2, 0, 1}));
  EXPECT_TRUE(worst_first(Table()).empty());
}

TEST(LinkedCharts, APointIsATree) {
  const auto chart = height_over_diameter(four_stems(), {}, {});
  ASSERT_EQ(chart.marks.size(), 3u);  // the one without a height is left out
  const auto at = chart.marks[2].box.centre();
  EXPECT_EQ(chart.tree_at(at + Eigen::Vector2d(0.5, 0), 2, {}), 14);
  EXPECT_FALSE(chart.tree_at({0, 0}, 2, {}));
}

TEST(LinkedCharts, ABarGoesThroughItsTrees) {
  const auto chart = diameter_histogram(four_stems(), {}, 12);
  ASSERT_EQ(chart.marks.size(), 3u);
  const auto bar = chart.marks[0].box.centre();
  EXPECT_EQ(chart.tree_at(bar, 1, {}), 11);
  EXPECT_EQ(chart.tree_at(bar, 1, 11), 12);
  EXPECT_EQ(chart.tree_at(bar, 1, 12), 11);
}

TEST(LinkedCharts, MatchedTreesAloneAreCompared) {
  Table t;
  t.set("kind", std::vector<std::string>{"matched", "missed", "false"});
  t.set("tree_id", std::vector<double>{1, std::nan(""), 3});
  t.set("dbh_cm", std::vector<double>{20, std::nan(""), 22});
  t.set("ref_dbh_cm", std::vector<double>{21, 30, std::nan("")});
  const auto chart = estimated_over_field(t, {}, 1);
  ASSERT_EQ(chart.marks.size(), 1u);
  EXPECT_GT(figure_image(chart.figure, 96).width, 0);
  EXPECT_GT(figure_image(estimated_over_field(Table(), {}, {}).figure, 96).width, 0);  // says that there are none
}

}  // namespace
}  // namespace bole::render
