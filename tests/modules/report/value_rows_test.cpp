#include "report/core/value_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "inventory/core/value_tables.h"

namespace bole::report {
namespace {

using testing::HasSubstr;
using testing::Not;

const CountingRule rectangle{rectangle_area({0, 0}, 20, 25), 7};

// `n` stems in a line, the k-th of (10 + k) cm and m height; the tops of the first `seen` are seen.
Table line_of_stems(int n, int seen) {
  std::vector<double> x, y, size;
  std::vector<std::int64_t> top;
  for (int k = 0; k < n; ++k) {
    x.push_back(0.1 * k);
    y.push_back(0);
    size.push_back(10 + k);
    top.push_back(k < seen);
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("dbh_cm", size);
  t.set("height_m", size);
  t.set("height_seen", top);
  return t;
}

std::string told(const Table& stems, const CountingRule& rule = rectangle,
                 const inventory::PlotValueOptions& options = {}) {
  const auto values = inventory::plot_values(stems, rule, options);
  const Table table = inventory::plot_value_table(values, options), curve = inventory::height_curve_table(values);
  std::string text;
  for (const auto& row : value_rows(PlotValues(table), &curve))
    text += row.name + "|" + row.value + "|" + row.unit + "|" + row.how + "\n";
  return text;
}

TEST(ValueRows, TopsSeenAreNamed) {
  EXPECT_THAT(told(line_of_stems(20, 6)), HasSubstr("tops seen on 6 of 20 stems; these alone count"));
}

TEST(ValueRows, TheHeightOfFewTopsIsNamedSo) {
  auto t = line_of_stems(20, 6);
  t.set("height_lower_bound_m", std::vector<double>(20, 5));
  EXPECT_THAT(told(t), HasSubstr("Lorey's height of these tops|"));
  EXPECT_THAT(told(t), HasSubstr("with 12 % of the basal area"));
  EXPECT_THAT(told(t), HasSubstr("Lorey's height, at least|5.9|m|"));
  auto most = line_of_stems(20, 18);
  most.set("height_lower_bound_m", std::vector<double>(20, 5));
  EXPECT_THAT(told(most), Not(HasSubstr("at least|")));
}

TEST(ValueRows, TooFewTopsAreWordsNotNumbers) {
  for (const auto& [n, seen] : {std::pair{10, 4}, {74, 3}, {40, 7}, {4, 0}, {74, 12}}) {
    const auto text = told(line_of_stems(n, seen));
    EXPECT_THAT(text, HasSubstr("tops seen on " + std::to_string(seen) + " of " + std::to_string(n) +
                                " stems: heights are lower bounds"));
    for (const char* word : {"Lorey", "Height curve", "Stem volume per hectare"})
      EXPECT_THAT(text, Not(HasSubstr(word))) << seen << " of " << n;
    EXPECT_THAT(text, HasSubstr("Stem volume|not given||heights are lacking"));
  }
}

TEST(ValueRows, TheHeightCurveNamesItsBreastHeight) {
  auto stems = line_of_stems(40, 40);
  EXPECT_THAT(told(stems), HasSubstr("h = 1.3 + d²"));
  set_breast_height_m(stems, 1.37);
  EXPECT_THAT(told(stems), HasSubstr("h = 1.37 + d²"));
}

TEST(ValueRows, HowUnsureTheFormIsTakenIsNamed) {
  EXPECT_THAT(told(line_of_stems(40, 40), rectangle, {.form_sd_pct = 7.5}),
              HasSubstr("their form unsure by 7.5 % (standard deviation)"));
}

TEST(ValueRows, IntervalsAndStemsWithoutOne) {
  auto t = line_of_stems(20, 20);
  auto low = t.numbers("dbh_cm"), high = low;
  for (auto& v : low) v *= 0.98;
  for (auto& v : high) v *= 1.02;
  t.set("dbh_lo_cm", low);
  t.set("dbh_hi_cm", high);
  EXPECT_THAT(told(t), HasSubstr("as measured"));
  EXPECT_THAT(told(t), HasSubstr("as a sample of a stand"));
  EXPECT_THAT(told(t), Not(HasSubstr("without an interval")));
  low[3] = std::nan("");
  t.set("dbh_lo_cm", low);
  EXPECT_THAT(told(t), HasSubstr("1 stem without an interval taken as unsure as the others"));
  t.set("dbh_lo_cm", std::vector<double>(20, std::nan("")));
  EXPECT_THAT(told(t), Not(HasSubstr("as measured")));
}

TEST(ValueRows, WithoutARuleEveryDiameterCounts) {
  EXPECT_THAT(told(line_of_stems(20, 20), {}), HasSubstr("of every DBH; 0 thinner"));
  EXPECT_THAT(told(line_of_stems(20, 20), {}), Not(HasSubstr("1/ha")));
  EXPECT_THAT(told(line_of_stems(20, 20)), HasSubstr("DBH of at least 7.0 cm and centre at breast height inside"));
}

TEST(ValueRows, AnEmptyPlotHasRowsAndNoIntervals) {
  const auto text = told(line_of_stems(0, 0));
  EXPECT_THAT(text, HasSubstr("Heights|not given||no stems"));
  EXPECT_THAT(text, Not(HasSubstr("±")));
}

TEST(ValueRows, AForeignTableIsRefused) {
  Table t;
  t.set("measure", std::vector<std::string>{"stems"});
  for (const char* c : {"value", "half", "sampled_half"}) t.set(c, std::vector<double>{1});
  t.set("unit", std::vector<std::string>{""});
  EXPECT_THROW(value_rows(PlotValues(t), nullptr), Error);
}

TEST(ValueRows, UnitsAreTypeset) {
  EXPECT_EQ(unit_text("m2/ha"), "m²/ha");
  EXPECT_EQ(unit_text("m3"), "m³");
  EXPECT_EQ(unit_text("m"), "m");
  EXPECT_EQ(unit_text("deg"), "°");
}

}  // namespace
}  // namespace bole::report
