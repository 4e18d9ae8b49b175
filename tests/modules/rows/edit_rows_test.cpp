#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "rows/core/edits/apply_row_edits.h"

namespace bole::rows {
namespace {

using ::testing::HasSubstr;

// Three rows along x at y = 0, 4, 8 with ten plants 2 m apart, and two plants in no row at y = 13.
FoundRows three_rows() {
  std::vector<double> x, y;
  for (const double across : {0.0, 4.0, 8.0})
    for (int i = 0; i < 10; ++i) {
      x.push_back(2.0 * i);
      y.push_back(across + 0.01 * (i % 3));
    }
  for (const double at : {3.0, 9.0}) {
    x.push_back(at);
    y.push_back(13);
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  return find_rows(t, {}, bole::Run{});
}

EditedRows edit(const std::string& json, const FoundRows& found = three_rows()) {
  return apply_row_edits(found, parse_row_edits(json), {}, bole::Run{});
}

std::size_t row_named(const Table& rows, const std::string& id) {
  for (std::size_t i = 0; i < rows.rows(); ++i)
    if (rows.text("row_id", i) == id) return i;
  throw std::runtime_error("no row " + id);
}

TEST(EditRows, WithoutEditsNothingChanges) {
  const auto found = three_rows();
  const auto out = edit("[]", found);
  EXPECT_EQ(out.found.rows.numbers("angle_deg"), found.rows.numbers("angle_deg"));
  EXPECT_EQ(out.found.plants.rows(), found.plants.rows());
  EXPECT_EQ(out.found.rows.texts("state")[0], "auto");
  EXPECT_EQ(out.log.rows(), 0U);
}

TEST(EditRows, EveryActionDoesWhatItSays) {
  const auto found = three_rows();
  ASSERT_EQ(found.rows.rows(), 3U);
  const std::string middle = found.rows.text("row_id", 1);

  auto out = edit(R"([{"action": "move", "at": [5, 4], "from": [-1, 4], "to": [19, 4.5]}])");
  const auto k = row_named(out.found.rows, middle);
  EXPECT_NEAR(out.found.rows.numbers("angle_deg")[k], std::atan2(0.5, 20) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(out.found.rows.numbers("x0_m")[k], -1, 1e-9);
  EXPECT_TRUE(std::isnan(out.found.rows.numbers("angle_se_deg")[k]));
  EXPECT_EQ(out.found.rows.integers("plants")[k], 10);
  EXPECT_EQ(out.found.rows.texts("state")[k], "edited");

  out = edit(R"([{"action": "delete", "at": [5, 4]}])");
  EXPECT_EQ(out.found.rows.rows(), 2U);
  EXPECT_EQ(out.found.strays.rows(), found.strays.rows() + 10);

  out = edit(R"([{"action": "split", "at": [9, 4]}])");
  EXPECT_EQ(out.found.rows.rows(), 4U);
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, middle)], 5);
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, "4")], 5);

  out = edit(R"([{"action": "split", "at": [9, 4]}, {"action": "merge", "at": [3, 4], "with": [[15, 4]]}])");
  EXPECT_EQ(out.found.rows.rows(), 3U);
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, middle)], 10);
  EXPECT_NEAR(out.found.rows.numbers("angle_deg")[1], found.rows.numbers("angle_deg")[1], 1e-9);

  out = edit(R"([{"action": "add", "from": [0, 13], "to": [18, 13]}])");
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, "4")],
            static_cast<std::int64_t>(found.strays.rows()));
  EXPECT_EQ(out.found.strays.rows(), 0U);

  out = edit(R"([{"action": "add", "from": [0, 30], "to": [0, 50], "row_id": 9}])");  // no plant near
  const auto drawn = row_named(out.found.rows, "9");
  EXPECT_NEAR(out.found.rows.numbers("angle_deg")[drawn], 90, 1e-9);
  EXPECT_EQ(out.found.rows.integers("plants")[drawn], 0);

  out = edit(R"([{"action": "renumber", "at": [5, 4], "row_id": "17"}])");
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, "17")], 10);
  out = edit(R"([{"action": "renumber", "at": [5, 4], "row_id": "north"}])");
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, "north")], 10);
}

TEST(EditRows, WhatDoesNotFitIsAConflict) {
  const auto out = edit(R"([{"action": "delete", "at": [5, 100]}, {"action": "split", "at": [-0.5, 4]},
    {"action": "merge", "at": [3, 4], "with": [[15, 4]]}, {"action": "renumber", "at": [3, 4], "row_id": "3"},
    {"action": "delete", "at": [5, 2]}, {"action": "move", "at": [5, 4], "from": [0, 4], "to": [18, 4], "was_angle_deg": 30}])");
  EXPECT_EQ(out.found.report.counts.at("conflicts"), 5);
  EXPECT_EQ(out.found.report.counts.at("applied"), 1);
  EXPECT_THAT(out.log.texts("message")[0], HasSubstr("no row within"));
  EXPECT_THAT(out.log.texts("message")[1], HasSubstr("one side"));
  EXPECT_THAT(out.log.texts("message")[2], HasSubstr("twice"));
  EXPECT_THAT(out.log.texts("message")[3], HasSubstr("already"));
  EXPECT_THAT(out.log.texts("message")[5], HasSubstr("30.00 deg"));
  EXPECT_EQ(out.log.texts("outcome")[5], "applied");
  EXPECT_EQ(out.found.rows.rows(), 3U);
}

// What a person did to one row must not change a digit of another, whatever is odd about it.
TEST(EditRows, RowsThatNobodyTouchedStayAsTheyWere) {
  std::vector<double> x, y;
  for (const double across : {0.0, 4.0, 8.0})
    for (int i = 0; i < 24; ++i)
      if (i % 7 != 3) {
        x.push_back(2.0 * i + 0.3 * ((i * 5) % 3));
        y.push_back(across + 0.0012 * 4 * i * i);
      }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  RowOptions options;
  options.plant_spacing = 2;
  const auto found = find_rows(t, options, bole::Run{});
  ASSERT_EQ(found.rows.rows(), 3U);
  const auto out = edit(R"([{"action": "move", "at": [10, 4.5], "from": [0, 4], "to": [46, 5]}])", found);
  int edited = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool moved = out.found.rows.texts("state")[i] == "edited";
    edited += moved;
    const auto j = row_named(found.rows, out.found.rows.text("row_id", i));
    for (const char* name : {"plants", "missing", "spacing_m", "spacing_sd_m"})
      EXPECT_EQ(out.found.rows.text(name, i), found.rows.text(name, j)) << name;
    if (moved) continue;
    const std::set<std::string> of_the_block{"block", "row_in_block", "to_next_m"};
    for (const auto& column : found.rows.columns()) {
      if (of_the_block.contains(column.name)) continue;
      EXPECT_EQ(out.found.rows.text(column.name, i), found.rows.text(column.name, j)) << column.name;
    }
  }
  EXPECT_EQ(edited, 1);
  EXPECT_EQ(out.found.plants.rows(), found.plants.rows());  // missing ones too
}

TEST(EditRows, PartsOfAMovedRowKeepItsLine) {
  const auto out = edit(R"([{"action": "move", "at": [5, 4], "from": [0, 4], "to": [20, 5]},
    {"action": "split", "at": [10, 4.4]}])");
  ASSERT_EQ(out.found.report.counts.at("conflicts"), 0);
  const auto k = row_named(out.found.rows, "4");
  const double angle = std::atan2(1, 20);
  EXPECT_NEAR(out.found.rows.numbers("angle_deg")[k], angle * 180 / M_PI, 1e-9);
  EXPECT_NEAR(out.found.rows.numbers("x1_m")[k], 20, 1e-9);
  const double x = out.found.rows.numbers("x0_m")[k], y = out.found.rows.numbers("y0_m")[k];
  EXPECT_NEAR(y, 4 + x / 20, 1e-9);                  // on the line
  EXPECT_NEAR(x, 10 - 0.1 * std::sin(angle), 0.01);  // at the foot of the cut
  // Plants are told their distance from the line that was given.
  for (std::size_t i = 0; i < out.found.plants.rows(); ++i)
    if (out.found.plants.text("row_id", i) == "4") {
      const double px = out.found.plants.numbers("x_m")[i], py = out.found.plants.numbers("y_m")[i];
      EXPECT_NEAR(out.found.plants.numbers("across_m")[i], (py - 4 - px / 20) * std::cos(angle), 1e-9);
    }
}

TEST(EditRows, DrawnRowsWithoutPlantsCanBeSplitAndMerged) {
  const std::string drawn = R"({"action": "add", "from": [0, 40], "to": [20, 40]})";
  auto out = edit("[" + drawn + R"(, {"action": "split", "at": [8, 40]}])");
  ASSERT_EQ(out.found.rows.rows(), 5U);
  EXPECT_NEAR(out.found.rows.numbers("x1_m")[row_named(out.found.rows, "4")], 8, 1e-9);
  EXPECT_NEAR(out.found.rows.numbers("x0_m")[row_named(out.found.rows, "5")], 8, 1e-9);
  out = edit("[" + drawn + R"(, {"action": "add", "from": [24, 40], "to": [30, 40]},
    {"action": "merge", "at": [10, 40], "with": [[27, 40]]}])");
  ASSERT_EQ(out.found.rows.rows(), 4U);
  EXPECT_NEAR(out.found.rows.numbers("length_m")[row_named(out.found.rows, "4")], 30, 1e-9);
  out = edit(
      R"([{"action": "delete", "at": [5, 0]}, {"action": "delete", "at": [5, 4]}, {"action": "delete", "at": [5, 8]}, )" +
      drawn + "]");
  ASSERT_EQ(out.found.rows.rows(), 1U);  // no plant in any row
  EXPECT_EQ(out.found.lines.rows(), 2U);
  EXPECT_EQ(out.found.strays.rows(), 32U);
}

TEST(EditRows, NamesAreKeptAsTheyAreWritten) {
  auto out = edit(
      R"([{"action": "renumber", "at": [5, 4], "row_id": "007"}, {"action": "move", "at": [5, 8], "from": [0, 8], "to": [18, 8]}])");
  EXPECT_EQ(out.found.rows.rows(), 3U);
  EXPECT_EQ(out.found.rows.integers("plants")[row_named(out.found.rows, "007")], 10);
  for (const Table* t : {&out.found.rows, &out.found.plants, &out.found.lines}) {
    EXPECT_TRUE(std::holds_alternative<std::vector<std::string>>(*t->find("row_id")));
    for (std::size_t i = 0; i < t->rows(); ++i) EXPECT_NE(t->text("row_id", i), "");
  }
  // A second list of edits does not forget the first.
  const auto again = edit(R"([{"action": "renumber", "at": [5, 0], "row_id": "A"}])", out.found);
  EXPECT_EQ(again.found.rows.texts("state")[row_named(again.found.rows, "007")], "edited");
}

TEST(EditRows, TreeIdsStayWithTheirPlants) {
  std::vector<double> x, y;
  std::vector<std::int64_t> id;
  for (const double across : {0.0, 4.0, 8.0})
    for (int i = 0; i < 10; ++i) {
      x.push_back(2.0 * i);
      y.push_back(across);
      id.push_back(static_cast<std::int64_t>(100 * across) + i);
    }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("tree_id", id);
  const auto out =
      edit(R"([{"action": "split", "at": [9, 4]}, {"action": "delete", "at": [5, 8]}])", find_rows(t, {}, bole::Run{}));
  for (const Table* part : {&out.found.plants, &out.found.strays})
    for (std::size_t i = 0; i < part->rows(); ++i)
      EXPECT_EQ(part->text("tree_id", i),
                std::to_string(static_cast<int>(100 * part->numbers("y_m")[i] + part->numbers("x_m")[i] / 2)));
  EXPECT_EQ(out.found.plants.rows() + out.found.strays.rows(), 30U);
}

// The same edits after a run that found the rows a little elsewhere and in another order.
TEST(EditRows, EditsAreAppliedByPlaceAfterARerun) {
  std::vector<double> x, y;
  for (const double across : {8.05, 4.05, 0.05})
    for (int i = 9; i >= 0; --i) {
      x.push_back(2.0 * i + 0.04);
      y.push_back(across - 0.01 * (i % 3));
    }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  const auto again = find_rows(t, {}, bole::Run{});
  const auto out = edit(R"([{"action": "delete", "at": [5, 4]}])", again);
  ASSERT_EQ(out.found.rows.rows(), 2U);
  for (const double at : out.found.rows.numbers("y0_m")) EXPECT_GT(std::abs(at - 4), 3);
}

TEST(EditRows, JsonThereAndBack) {
  const std::string json = R"([{"action": "move", "at": [5, 4], "from": [0, 4], "to": [18, 4.5], "was_angle_deg": 1.5,
    "author": "A. Smith", "time": "2026-05-02T10:15:00Z", "reason": "post"}, {"action": "add", "from": [0, 1], "to": [2, 3], "row_id": "7"},
    {"action": "merge", "at": [1, 2], "with": [[3, 4], [5, 6]]}, {"action": "note", "at": [1, 1], "text": "replant"}])";
  const auto once = to_json(parse_row_edits(json));
  EXPECT_EQ(to_json(parse_row_edits(once)), once);
  EXPECT_THAT(once, HasSubstr("replant"));
  const auto error = [](const std::string& text) {
    try {
      parse_row_edits(text);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(error("{"), HasSubstr("no JSON"));
  EXPECT_THAT(error(R"([{"action": "bend"}])"), HasSubstr("edit 1"));
  EXPECT_THAT(error(R"([{"action": "move", "at": [1, 2]}])"), HasSubstr("without from"));
  EXPECT_THAT(error(R"([{"action": "delete", "at": [1, 2], "dbh_cm": 3}])"), HasSubstr("does not take"));
  EXPECT_THAT(error(R"([{"action": "add", "from": [1, 2], "to": [1, 2]}])"), HasSubstr("one place"));
  EXPECT_THAT(error(R"([{"action": "delete", "at": [1e99, 2]}])"), HasSubstr("number from"));
}

}  // namespace
}  // namespace bole::rows
