#include "report/core/plot_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace bole::report {
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

TEST(PlotMetrics, ByHand) {
  const auto m = plot_metrics(stems(), rectangle, 10);
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

std::string told(const PlotMetrics& m, double min_dbh_cm = 7) {
  std::string text;
  for (const auto& row : metric_rows(m, min_dbh_cm)) text += row.name + "|" + row.value + "|" + row.how + "\n";
  return text;
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

TEST(PlotMetrics, HeightsComeFromSeenTopsAlone) {
  const auto m = plot_metrics(line_of_stems(20, 6), rectangle);
  EXPECT_EQ(m.tops_seen, 6U);
  EXPECT_DOUBLE_EQ(m.mean_height_m, 12.5);       // 10 to 15, none of the higher bounds
  EXPECT_TRUE(std::isnan(m.dominant_height_m));  // no top of the five thickest was seen
  EXPECT_THAT(told(m), testing::HasSubstr("tops seen on 6 of 20 stems"));
}

TEST(PlotMetrics, TooFewTopsAreWordsNotNumbers) {
  for (const auto& [n, seen] : {std::pair{10, 4}, {74, 3}, {40, 7}, {4, 0}, {74, 12}}) {
    const auto m = plot_metrics(line_of_stems(n, seen), rectangle);
    EXPECT_FALSE(m.heights_known);
    EXPECT_TRUE(std::isnan(m.mean_height_m) && std::isnan(m.lorey_height_m) && std::isnan(m.dominant_height_m));
    EXPECT_THAT(told(m), testing::HasSubstr("tops seen on " + std::to_string(seen) + " of " + std::to_string(n) +
                                            " stems: heights are lower bounds"));
    for (const char* word : {"Lorey", "Height curve", "Stem volume per hectare"})
      EXPECT_THAT(told(m), testing::Not(testing::HasSubstr(word))) << seen << " of " << n;
    EXPECT_THAT(told(m), testing::HasSubstr("Stem volume|not given|heights are lacking"));
  }
  EXPECT_TRUE(plot_metrics(line_of_stems(40, 8), rectangle).heights_known);
  EXPECT_TRUE(plot_metrics(line_of_stems(3, 3), rectangle).heights_known);
}

TEST(PlotMetrics, TheHeightCurveBeginsAtTheBreastHeightOfTheTable) {
  auto table = line_of_stems(40, 40);
  EXPECT_THAT(told(plot_metrics(table, rectangle)), testing::HasSubstr("h = 1.3 + d²"));
  set_breast_height_m(table, 1.37);
  EXPECT_THAT(told(plot_metrics(table, rectangle)), testing::HasSubstr("h = 1.37 + d²"));
}

TEST(PlotMetrics, HowUnsureTheFormIsTakenIsTold) {
  EXPECT_THAT(told(plot_metrics(line_of_stems(40, 40), rectangle, 4, 7.5)),
              testing::HasSubstr("their form unsure by 7.5 % (standard deviation)"));
}

// A tape gives no interval; it must not take that of the plot away.
TEST(PlotMetrics, OneTapedStemLeavesThePlotItsIntervals) {
  auto t = line_of_stems(20, 20);
  auto low = t.numbers("dbh_cm"), high = low;
  for (auto& v : low) v *= 0.98;
  for (auto& v : high) v *= 1.02;
  t.set("dbh_lo_cm", low), t.set("dbh_hi_cm", high);
  const auto all = plot_metrics(t, rectangle);
  EXPECT_THAT(told(all), testing::Not(testing::HasSubstr("without an interval")));
  low[3] = high[3] = std::nan("");
  t.set("dbh_lo_cm", low), t.set("dbh_hi_cm", high);
  const auto one = plot_metrics(t, rectangle);
  EXPECT_EQ(one.stand.no_interval, 1U);
  // All have the same relative standard deviation, so the taped one gets just that.
  EXPECT_NEAR(one.stand.basal_area_m2.measured, all.stand.basal_area_m2.measured, 1e-12);
  EXPECT_NEAR(one.stand.quadratic_mean_dbh_half_cm, all.stand.quadratic_mean_dbh_half_cm, 1e-12);
  EXPECT_NEAR(one.stand.volume_m3_half.measured, all.stand.volume_m3_half.measured, 1e-12);
  EXPECT_THAT(told(one), testing::HasSubstr("1 stem without an interval taken as unsure as the others"));
  EXPECT_THAT(told(one), testing::HasSubstr("as measured"));
  t.set("dbh_lo_cm", std::vector<double>(20, std::nan("")));
  EXPECT_THAT(told(plot_metrics(t, rectangle)), testing::Not(testing::HasSubstr("as measured")));
}

TEST(PlotMetrics, NoRuleCountsTheThin) {
  const auto m = plot_metrics(stems(), {});
  EXPECT_EQ(m.stems, 6U);  // all but the rejected one
  EXPECT_EQ(m.too_thin, 0U);
  EXPECT_THAT(told(m, 0), testing::HasSubstr("of every DBH"));
}

TEST(PlotMetrics, DominantHeightTakesTheThickest) {
  // 200 m2: two stems stand for 100 per hectare.
  const auto m = plot_metrics(stems(), {rectangle_area({0, 0}, 20, 10), 7});
  EXPECT_EQ(m.stems, 3U);  // the one at y = 12.5 is outside now
  EXPECT_EQ(m.dominant_stems, 2U);
  EXPECT_DOUBLE_EQ(m.dominant_height_m, 22);
}

TEST(PlotMetrics, Classes) {
  auto table = stems();
  table.set("height_seen", std::vector<std::int64_t>{1, 0, 1, 1, 1, 1, 1});
  const auto m = plot_metrics(table, rectangle, 10);
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

TEST(PlotMetrics, CircleAndItsArea) {
  const PlotArea circle = circle_area({0, 0}, 10);
  EXPECT_NEAR(circle.area_m2(), 314.159265, 1e-5);
  EXPECT_TRUE(circle.contains(10, 0));
  EXPECT_FALSE(circle.contains(7.2, 7.2));
}

TEST(PlotMetrics, ShiftedPlotGivesTheSameNumbers) {
  auto shifted = stems();
  auto x = shifted.numbers("x_m"), y = shifted.numbers("y_m");
  for (auto& v : x) v += 512345;
  for (auto& v : y) v += 5412345;
  shifted.set("x_m", x), shifted.set("y_m", y);
  const auto a = plot_metrics(stems(), rectangle),
             b = plot_metrics(shifted, {rectangle_area({512345, 5412345}, 20, 25), 7});
  EXPECT_EQ(a.stems, b.stems);
  EXPECT_DOUBLE_EQ(a.basal_area_m2_per_ha, b.basal_area_m2_per_ha);
  EXPECT_DOUBLE_EQ(a.lorey_height_m, b.lorey_height_m);
}

TEST(PlotMetrics, WithoutBoundaryNothingPerHectare) {
  const auto m = plot_metrics(stems(), {{}, 7});
  EXPECT_EQ(m.stems, 5U);
  EXPECT_TRUE(std::isnan(m.stems_per_ha));
  EXPECT_TRUE(std::isnan(m.dominant_height_m));
  EXPECT_FALSE(std::isnan(m.lorey_height_m));
}

TEST(PlotMetrics, EmptyTable) {
  Table t;
  for (const char* c : {"x_m", "y_m", "dbh_cm"}) t.set(c, std::vector<double>{});
  const auto m = plot_metrics(t, rectangle);
  EXPECT_EQ(m.stems, 0U);
  EXPECT_DOUBLE_EQ(m.stems_per_ha, 0);
  EXPECT_TRUE(std::isnan(m.mean_dbh_cm));
  EXPECT_THAT(metric_rows(m, 7), testing::Not(testing::IsEmpty()));
}

}  // namespace
}  // namespace bole::report
