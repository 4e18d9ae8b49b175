#include "io/core/tables/table_file.h"

#include <gmock/gmock.h>

#include <cmath>

#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::ElementsAre;
using testing::HasSubstr;

Table read_table_text(const std::string& text) { return read_table(bytes_of(text), "t.csv"); }

TEST(TableFile, TypesFollowTheCells) {
  const auto t = read_table_text(
      "tree_id,dbh_cm,state,note,height_m\n1,20.5,auto,\"said \"\"big\"\", twice\",\n2,,edited,\"two\nlines\",\n");
  EXPECT_EQ(t.rows(), 2U);
  EXPECT_THAT(t.integers("tree_id"), ElementsAre(1, 2));
  EXPECT_EQ(t.numbers("dbh_cm")[0], 20.5);
  EXPECT_TRUE(std::isnan(t.numbers("dbh_cm")[1]));
  EXPECT_THAT(t.texts("note"), ElementsAre("said \"big\", twice", "two\nlines"));
  EXPECT_TRUE(std::isnan(t.numbers("height_m")[0]));
}

TEST(TableFile, OtherDelimitersFactsAndLineEnds) {
  const auto t = read_table_text("\xEF\xBB\xBF# axes: plot\n# crs: EPSG:25832\nx_m;name\r\n1,5;a\r\n2;b\r\n\r\n");
  EXPECT_EQ(t.facts.at("axes"), "plot");
  EXPECT_EQ(t.facts.at("crs"), "EPSG:25832");
  EXPECT_THAT(t.numbers("x_m"), ElementsAre(1.5, 2));
  EXPECT_THAT(read_table_text("a\tb\n1\tx, y\n").texts("b"), ElementsAre("x, y"));
  EXPECT_EQ(read_table_text("a,b\n").rows(), 0U);
  EXPECT_THAT(read_table_text("a,b\n1,").texts("b"), ElementsAre(""));
}

TEST(TableFile, ErrorsNameTheLine) {
  EXPECT_THAT(error_of([] { read_table_text("a,b\n1,2\n3\n"); }), HasSubstr("'t.csv' line 3 has 1 cell"));
  EXPECT_THAT(error_of([] { read_table_text("a,b\n1,2,3\n"); }), HasSubstr("line 2 has 3 cells"));
  EXPECT_THAT(error_of([] { read_table_text("a,a\n1,2\n"); }), HasSubstr("'a' twice"));
  EXPECT_THAT(error_of([] { read_table_text("a,\n1,2\n"); }), HasSubstr("without a name"));
  EXPECT_THAT(error_of([] { read_table_text("a,b\n\"1,2\n"); }), HasSubstr("line 2 opens a quote"));
  EXPECT_THAT(error_of([] { read_table_text(""); }), HasSubstr("empty"));
  EXPECT_THAT(error_of([] { read_table_text(std::string("a,b\n\0,2\n", 8)); }), HasSubstr("not text"));
  EXPECT_THAT(error_of([] { read_table(std::filesystem::path{}); }), HasSubstr("no table"));
}

TEST(TableFile, WhatIsWrittenIsReadBack) {
  Table t;
  t.set("tree_id", std::vector<std::int64_t>{3, -4});
  t.set("dbh_cm", std::vector<double>{1.0 / 3, std::nan("")});
  t.set("x_m", std::vector<double>{1.23456, 2});
  t.set("note", std::vector<std::string>{"a, \"b\"\n c", "# not a fact"});
  t.set("empty", std::vector<std::string>{"", ""});
  const TempDir dir;
  write_table(dir / "sub/t.csv", t, {{"x_m", 3}});
  EXPECT_THAT(file_text(dir / "sub/t.csv"), HasSubstr("3,0.3333333333333333,1.235,"));
  const auto back = read_table(dir / "sub/t.csv");
  EXPECT_EQ(back.integers("tree_id"), t.integers("tree_id"));
  EXPECT_EQ(back.numbers("dbh_cm")[0], 1.0 / 3);
  EXPECT_TRUE(std::isnan(back.numbers("dbh_cm")[1]));
  EXPECT_EQ(back.numbers("x_m")[0], 1.235);
  EXPECT_EQ(back.texts("note"), t.texts("note"));
  EXPECT_EQ(back.texts("empty"), t.texts("empty"));
  Table odd;
  odd.set("a;b;c", std::vector<std::string>{"\vx\t"});
  EXPECT_EQ(read_table_text(table_text(odd)).texts("a;b;c"), odd.texts("a;b;c"));
  Table marked;  // what many programs put before UTF-8, here a name
  marked.set("\xEF\xBB\xBF", std::vector<std::string>{"a"});
  EXPECT_EQ(read_table_text(table_text(marked)).columns()[0].name, "\xEF\xBB\xBF");
  Table one;
  one.set("note", std::vector<std::string>{"a", "", "b"});
  EXPECT_EQ(read_table_text(table_text(one)).texts("note"), one.texts("note"));
}

// A spreadsheet runs a text that begins like a formula.
TEST(TableFile, TextsThatLookLikeFormulasGetAnApostropheAndComeBack) {
  Table table;
  const std::vector<std::string> texts{
      "=cmd|' /C calc'!A0", "+1 cm", "-5 cm", "@SUM(A1)", "'=x", "plain", "-5", "O'Neill"};
  table.set("author", texts);
  table.set("x_m", std::vector<double>(texts.size(), -1.5));
  const auto text = table_text(table);
  EXPECT_THAT(text,
              testing::AllOf(testing::HasSubstr("'=cmd|"), testing::HasSubstr("'+1 cm"), testing::HasSubstr("'@SUM"),
                             testing::HasSubstr("-1.5"), testing::Not(testing::HasSubstr("'-1.5"))));
  const auto bytes = Bytes{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  EXPECT_EQ(read_table(bytes, "a.csv").texts("author"), texts);
}

}  // namespace
}  // namespace bole::io
