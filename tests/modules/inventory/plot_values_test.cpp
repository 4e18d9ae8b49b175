#include "inventory/core/plot_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "inventory/core/value_tables.h"

namespace bole::inventory {
namespace {

// Four stems that count on a plot of 20 m x 25 m (500 m2), one outside, one too thin, one rejected.
Table stems() {
  Table t;
  t.set("x_m", std::vector<double>{0, 5, -5, 9.9, 10.1, 1, 2});
  t.set("y_m", std::vector<double>{0, 12.5, 3, -4, 0, 1, 2});
  t.set("dbh_cm", std::vector<double>{10, 20, 30, 40, 50, 5, 35});
  t.set("height_m", std::vector<double>{10, 15, 20, 24, 30, 4, 22});
  t.set("state", std::vector<std::string>{"auto", "auto", "check", "edited", "auto", "auto", "rejected"});
  return t;
}

const CountingRule rectangle{rectangle_area({0, 0}, 20, 25), 7};

double value(const Table& plot_values, const std::string& measure, const char* column = "value") {
  const auto& measures = plot_values.texts("measure");
  const auto it = std::ranges::find(measures, measure);
  if (it == measures.end()) throw std::out_of_range(measure);
  return plot_values.numbers(column)[static_cast<std::size_t>(it - measures.begin())];
}

TEST(PlotValues, ByHand) {
  const auto m = plot_values(stems(), rectangle, {.class_width_cm = 10});
  EXPECT_EQ(m.stems, 4U);
  EXPECT_EQ(m.outside, 1U);
  EXPECT_EQ(m.too_thin, 1U);
  EXPECT_DOUBLE_EQ(m.area_m2, 500);
  EXPECT_DOUBLE_EQ(m.stems_per_ha, 80);
  // pi/4 (0.1^2 + 0.2^2 + 0.3^2 + 0.4^2) = 0.3 pi/4
  EXPECT_NEAR(m.basal_area_m2, 0.2356194, 1e-6);
  EXPECT_NEAR(m.basal_area_m2_per_ha, 4.712389, 1e-5);
  EXPECT_DOUBLE_EQ(m.mean_dbh_cm, 25);
  EXPECT_NEAR(m.sd_dbh_cm, std::sqrt(500.0 / 3), 1e-12);
  EXPECT_NEAR(m.quadratic_mean_dbh_cm, std::sqrt(750.0), 1e-12);
  EXPECT_EQ(m.tops_seen, 4U);
  EXPECT_TRUE(m.heights_known);
  EXPECT_DOUBLE_EQ(m.mean_height_m, 17.25);
  // (10 * 1 + 15 * 4 + 20 * 9 + 24 * 16) / 30
  EXPECT_NEAR(m.lorey_height_m, 634.0 / 30, 1e-12);
  // 100 per hectare are 5 on 500 m2: all four.
  EXPECT_EQ(m.dominant_stems, 4U);
  EXPECT_DOUBLE_EQ(m.dominant_height_m, 17.25);
}

// What lets all diameters be too large does not average away: the basal area can be too large by as much.
TEST(PlotValues, AnIntervalThatReachesFurtherDownIsSharedByAllStems) {
  auto even = stems(), down = stems();
  const auto dbh = even.numbers("dbh_cm");
  std::vector<double> low, lower, high;
  for (const double d : dbh) low.push_back(0.98 * d), lower.push_back(0.93 * d), high.push_back(1.02 * d);
  even.set("dbh_lo_cm", low), even.set("dbh_hi_cm", high);
  down.set("dbh_lo_cm", lower), down.set("dbh_hi_cm", high);
  const auto a = plot_values(even, rectangle), b = plot_values(down, rectangle);
  EXPECT_NEAR(b.stand.basal_area_m2.measured - a.stand.basal_area_m2.measured, 2 * 0.05 * a.basal_area_m2, 1e-9);
  EXPECT_NEAR(b.stand.quadratic_mean_dbh_half_cm - a.stand.quadratic_mean_dbh_half_cm, 0.05 * a.quadratic_mean_dbh_cm,
              1e-9);
}

// The check of the stand above is of 30 cm: 9 of the 30 squares of the basal area.
TEST(PlotValues, StemsToCheckStandApart) {
  const auto m = plot_values(stems(), rectangle);
  EXPECT_EQ(m.to_check, 1U);
  EXPECT_EQ(m.sound.stems, 3U);
  EXPECT_DOUBLE_EQ(m.sound.stems_per_ha, 60);
  EXPECT_NEAR(m.sound.basal_area_m2, m.basal_area_m2 * 21 / 30, 1e-12);
  EXPECT_NEAR(m.sound.quadratic_mean_dbh_cm, std::sqrt(2100.0 / 3), 1e-12);
  EXPECT_TRUE(many_to_check(m));
  EXPECT_FALSE(mostly_to_check(m));
  const auto table = plot_value_table(m, {});
  EXPECT_EQ(value(table, "stems"), 4);
  EXPECT_EQ(value(table, "stems_sound"), 3);
  EXPECT_EQ(value(table, "stems_to_check"), 1);
  EXPECT_NEAR(value(table, "basal_area_per_ha_sound"), m.basal_area_m2_per_ha * 0.7, 1e-9);
  auto accepted = stems();
  accepted.set("state", std::vector<std::string>{"auto", "auto", "accepted", "edited", "auto", "auto", "rejected"});
  EXPECT_FALSE(many_to_check(plot_values(accepted, rectangle)));
  auto doubtful = stems();
  doubtful.set("state", std::vector<std::string>(7, "check"));
  EXPECT_TRUE(mostly_to_check(plot_values(doubtful, rectangle)));
  // A poor stem counts as one to check unless a person decided.
  accepted.set("quality", std::vector<std::string>{"good", "poor", "poor", "poor", "good", "good", "good"});
  EXPECT_EQ(plot_values(accepted, rectangle).to_check, 1U);
}

TEST(PlotValues, EveryTreeHasItsHeightAndVolumeWithTheirSource) {
  auto t = stems();
  t.set("tree_id", std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7});
  t.set("dbh_lo_cm", std::vector<double>{9, 19, 29, 39, 49, 4, 34});
  t.set("dbh_hi_cm", std::vector<double>{11, 21, 31, 41, 51, 6, 36});
  t.set("volume_m3", std::vector<double>{std::nan(""), 0.25, std::nan(""), std::nan(""), 1, 1, 1});
  const auto m = plot_values(t, rectangle);
  const auto trees = tree_value_table(m, t);
  ASSERT_EQ(trees.rows(), 4U);
  EXPECT_THAT(trees.integers("tree_id"), testing::ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(trees.integers("to_check"), testing::ElementsAre(0, 0, 1, 0));
  EXPECT_EQ(trees.texts("height_source")[0], "top seen");
  EXPECT_EQ(trees.texts("volume_source")[1], "stem curve");
  EXPECT_EQ(trees.numbers("volume_m3")[1], 0.25);
  // Twice the relative half width of the diameter: 1 of 20 cm is 5 %, so 10 % of the volume.
  EXPECT_NEAR(trees.numbers("volume_hi_m3")[1] - 0.25, 0.025, 1e-6);
  // By form the 5 % of the form come on top: hypot(20 %, 1.96 * 5 %).
  const double v = trees.numbers("volume_m3")[0];
  EXPECT_NEAR(trees.numbers("volume_hi_m3")[0] / v - 1, std::hypot(0.2, 1.959964 * 0.05), 1e-6);
  EXPECT_NEAR(trees.numbers("volume_m3")[0] + 0.25 + trees.numbers("volume_m3")[2] + trees.numbers("volume_m3")[3],
              m.stand.volume_m3, 1e-9);
}

// `n` stems in a line, the k-th of (10 + k) cm and m height; the tops of the first `seen` are seen.
Table line_of_stems(int n, int seen) {
  std::vector<double> x, y, size;
  std::vector<std::int64_t> top;
  for (int k = 0; k < n; ++k) x.push_back(0.1 * k), y.push_back(0), size.push_back(10 + k), top.push_back(k < seen);
  Table t;
  t.set("x_m", x), t.set("y_m", y), t.set("dbh_cm", size), t.set("height_m", size), t.set("height_seen", top);
  return t;
}

TEST(PlotValues, HeightsComeFromSeenTopsAlone) {
  const auto m = plot_values(line_of_stems(20, 6), rectangle);
  EXPECT_EQ(m.tops_seen, 6U);
  EXPECT_DOUBLE_EQ(m.mean_height_m, 12.5);       // 10 to 15, none of the higher bounds
  EXPECT_TRUE(std::isnan(m.dominant_height_m));  // no top of the five thickest was seen
}

TEST(PlotValues, LoreysHeightIsAlsoGivenAtLeast) {
  auto t = line_of_stems(20, 6);
  EXPECT_TRUE(std::isnan(plot_values(t, rectangle).lorey_at_least_m));  // no lower bounds in the table
  t.set("height_lower_bound_m", std::vector<double>(20, 5));
  const auto m = plot_values(t, rectangle);
  double seen = 0, all = 0, weighted = 0;
  for (int k = 0; k < 20; ++k) {
    const double g = (10 + k) * (10 + k);
    all += g;
    if (k < 6) seen += g;
    weighted += g * (k < 6 ? 10 + k : 5);
  }
  EXPECT_NEAR(m.tops_basal_area_pct, 100 * seen / all, 1e-9);
  EXPECT_NEAR(m.lorey_at_least_m, weighted / all, 1e-9);
  EXPECT_LT(m.lorey_at_least_m, m.lorey_height_m);
  EXPECT_DOUBLE_EQ(value(plot_value_table(m, {}), "lorey_height_at_least"), m.lorey_at_least_m);
}

TEST(PlotValues, TooFewTopsAreWordsNotNumbers) {
  for (const auto& [n, seen] : {std::pair{10, 4}, {74, 3}, {40, 7}, {4, 0}, {74, 12}}) {
    const auto m = plot_values(line_of_stems(n, seen), rectangle);
    EXPECT_FALSE(m.heights_known);
    EXPECT_TRUE(std::isnan(m.mean_height_m) && std::isnan(m.lorey_height_m) && std::isnan(m.dominant_height_m));
    EXPECT_EQ(m.tops_seen, static_cast<std::size_t>(seen));
    const auto table = plot_value_table(m, {});
    for (const char* measure : {"mean_height", "lorey_height", "lorey_height_all", "volume", "volume_per_ha"})
      EXPECT_TRUE(std::isnan(value(table, measure))) << measure << ", " << seen << " of " << n;
    EXPECT_EQ(height_curve_table(m).rows(), 0U);
  }
  EXPECT_TRUE(plot_values(line_of_stems(40, 8), rectangle).heights_known);
  EXPECT_TRUE(plot_values(line_of_stems(3, 3), rectangle).heights_known);
}

TEST(PlotValues, TheHeightCurveBeginsAtTheBreastHeightOfTheTable) {
  auto table = line_of_stems(40, 40);
  EXPECT_EQ(height_curve_table(plot_values(table, rectangle)).numbers("breast_height_m"), std::vector<double>{1.3});
  set_breast_height_m(table, 1.37);
  EXPECT_EQ(height_curve_table(plot_values(table, rectangle)).numbers("breast_height_m"), std::vector<double>{1.37});
}

TEST(PlotValues, ACurveInTheTableGivesTheHeightsOfTheStruct) {
  const auto m = plot_values(line_of_stems(40, 40), rectangle);
  const auto t = height_curve_table(m);
  ASSERT_EQ(t.rows(), 1U);
  ASSERT_TRUE(m.stand.curve);
  const double d = 25, a = t.numbers("a")[0], b = t.numbers("b")[0];
  EXPECT_DOUBLE_EQ(t.numbers("breast_height_m")[0] + d * d / std::pow(a + b * d, 2), m.stand.curve->height_m(d));
  EXPECT_EQ(t.numbers("trees")[0], static_cast<double>(m.stand.curve->trees));
}

TEST(PlotValues, IntervalsInTheTableLieAroundTheirValues) {
  auto stems = line_of_stems(40, 40);
  auto low = stems.numbers("dbh_cm"), high = low;
  for (auto& v : low) v -= 0.5;
  for (auto& v : high) v += 0.5;
  stems.set("dbh_lo_cm", low);
  stems.set("dbh_hi_cm", high);
  const auto m = plot_values(stems, rectangle);
  const auto t = plot_value_table(m, {});
  for (const char* measure : {"basal_area", "basal_area_per_ha", "quadratic_mean_dbh", "volume", "volume_per_ha"}) {
    const double half = value(t, measure, "half");
    EXPECT_GT(half, 0) << measure;
    EXPECT_DOUBLE_EQ(value(t, measure, "lo"), value(t, measure) - half) << measure;
    EXPECT_DOUBLE_EQ(value(t, measure, "hi"), value(t, measure) + half) << measure;
  }
  EXPECT_DOUBLE_EQ(value(t, "basal_area", "half"), m.stand.basal_area_m2.measured);
  EXPECT_DOUBLE_EQ(value(t, "basal_area_per_ha", "half"), 10000 / m.area_m2 * m.stand.basal_area_m2.measured);
  EXPECT_DOUBLE_EQ(value(t, "stem_density", "sampled_half"), 10000 / m.area_m2 * m.stand.stems.sampled);
  EXPECT_TRUE(std::isnan(value(t, "stem_density", "half")));  // stems are counted without error
}

TEST(PlotValues, AnUnsureFormIsInTheTable) {
  const auto sure = plot_value_table(plot_values(line_of_stems(40, 40), rectangle, {.form_sd_pct = 0}), {});
  const auto unsure = plot_value_table(plot_values(line_of_stems(40, 40), rectangle, {.form_sd_pct = 7.5}), {});
  EXPECT_DOUBLE_EQ(value(unsure, "form_sd"), 7.5);
  EXPECT_DOUBLE_EQ(value(unsure, "volume"), value(sure, "volume"));
}

// A tape gives no interval; it must not take that of the plot away.
TEST(PlotValues, OneTapedStemLeavesThePlotItsIntervals) {
  auto t = line_of_stems(20, 20);
  auto low = t.numbers("dbh_cm"), high = low;
  for (auto& v : low) v *= 0.98;
  for (auto& v : high) v *= 1.02;
  t.set("dbh_lo_cm", low), t.set("dbh_hi_cm", high);
  const auto all = plot_values(t, rectangle);
  EXPECT_EQ(all.stand.no_interval, 0U);
  low[3] = high[3] = std::nan("");
  t.set("dbh_lo_cm", low), t.set("dbh_hi_cm", high);
  const auto one = plot_values(t, rectangle);
  EXPECT_EQ(one.stand.no_interval, 1U);
  // All have the same relative standard deviation, so the taped one gets just that.
  EXPECT_NEAR(one.stand.basal_area_m2.measured, all.stand.basal_area_m2.measured, 1e-12);
  EXPECT_NEAR(one.stand.quadratic_mean_dbh_half_cm, all.stand.quadratic_mean_dbh_half_cm, 1e-12);
  EXPECT_NEAR(one.stand.volume_m3_half.measured, all.stand.volume_m3_half.measured, 1e-12);
  t.set("dbh_lo_cm", std::vector<double>(20, std::nan("")));
  EXPECT_TRUE(std::isnan(value(plot_value_table(plot_values(t, rectangle), {}), "basal_area", "half")));
}

TEST(PlotValues, NoRuleCountsTheThin) {
  const auto m = plot_values(stems(), {});
  EXPECT_EQ(m.stems, 6U);  // all but the rejected one
  EXPECT_EQ(m.too_thin, 0U);
  EXPECT_EQ(value(plot_value_table(m, {}), "min_counted_dbh"), 0);
}

TEST(PlotValues, DominantHeightTakesTheThickest) {
  // 200 m2: two stems stand for 100 per hectare.
  const auto m = plot_values(stems(), {rectangle_area({0, 0}, 20, 10), 7});
  EXPECT_EQ(m.stems, 3U);  // the one at y = 12.5 is outside now
  EXPECT_EQ(m.dominant_stems, 2U);
  EXPECT_DOUBLE_EQ(m.dominant_height_m, 22);
}

TEST(PlotValues, Classes) {
  auto table = stems();
  table.set("height_seen", std::vector<std::int64_t>{1, 0, 1, 1, 1, 1, 1});
  const auto m = plot_values(table, rectangle, {.class_width_cm = 10});
  ASSERT_EQ(m.classes.size(), 4U);
  EXPECT_DOUBLE_EQ(m.classes[1].lo_cm, 20);
  EXPECT_DOUBLE_EQ(m.classes[1].hi_cm, 30);
  EXPECT_EQ(m.classes[1].stems, 1U);
  EXPECT_DOUBLE_EQ(m.classes[1].stems_per_ha, 20);
  EXPECT_TRUE(std::isnan(m.classes[1].mean_height_m));
  EXPECT_DOUBLE_EQ(m.classes[3].mean_height_m, 24);
  double basal_area = 0;
  for (const auto& c : m.classes) basal_area += c.basal_area_m2_per_ha;
  EXPECT_NEAR(basal_area, m.basal_area_m2_per_ha, 1e-12);
}

TEST(PlotValues, ClassesAddUpToThePlot) {
  const auto m = plot_values(line_of_stems(40, 40), rectangle, {.class_width_cm = 2.5});
  const auto t = class_table(m);
  double stems = 0, area = 0;
  for (const double n : t.numbers("stems")) stems += n;
  for (const double g : t.numbers("basal_area_m2")) area += g;
  EXPECT_EQ(stems, static_cast<double>(m.stems));
  EXPECT_NEAR(area, m.basal_area_m2, 1e-12);
  EXPECT_DOUBLE_EQ(t.numbers("max_dbh_cm")[0] - t.numbers("min_dbh_cm")[0], 2.5);
}

TEST(PlotValues, CircleAndItsArea) {
  const PlotArea circle = circle_area({0, 0}, 10);
  EXPECT_NEAR(circle.area_m2(), 314.159265, 1e-5);
  EXPECT_TRUE(circle.contains(10, 0));
  EXPECT_FALSE(circle.contains(7.2, 7.2));
}

TEST(PlotValues, ShiftedPlotGivesTheSameNumbers) {
  auto shifted = stems();
  auto x = shifted.numbers("x_m"), y = shifted.numbers("y_m");
  for (auto& v : x) v += 512345;
  for (auto& v : y) v += 5412345;
  shifted.set("x_m", x), shifted.set("y_m", y);
  const auto a = plot_values(stems(), rectangle),
             b = plot_values(shifted, {rectangle_area({512345, 5412345}, 20, 25), 7});
  EXPECT_EQ(a.stems, b.stems);
  EXPECT_DOUBLE_EQ(a.basal_area_m2_per_ha, b.basal_area_m2_per_ha);
  EXPECT_DOUBLE_EQ(a.lorey_height_m, b.lorey_height_m);
}

TEST(PlotValues, WithoutBoundaryNothingPerHectare) {
  const auto m = plot_values(stems(), {{}, 7});
  EXPECT_EQ(m.stems, 5U);
  EXPECT_TRUE(std::isnan(m.stems_per_ha));
  EXPECT_TRUE(std::isnan(m.dominant_height_m));
  EXPECT_FALSE(std::isnan(m.lorey_height_m));
}

TEST(PlotValues, EmptyTable) {
  Table t;
  for (const char* c : {"x_m", "y_m", "dbh_cm"}) t.set(c, std::vector<double>{});
  const auto m = plot_values(t, rectangle);
  EXPECT_EQ(m.stems, 0U);
  EXPECT_DOUBLE_EQ(m.stems_per_ha, 0);
  EXPECT_TRUE(std::isnan(m.mean_dbh_cm));
  const auto values = plot_value_table(m, {});
  EXPECT_EQ(value(values, "stems"), 0);
  for (const char* measure : {"mean_dbh", "lorey_height", "volume"})
    EXPECT_TRUE(std::isnan(value(values, measure))) << measure;
  EXPECT_TRUE(std::isnan(value(values, "stem_density", "sampled_half")));
  EXPECT_EQ(class_table(m).rows(), 0U);
}

}  // namespace
}  // namespace bole::inventory
