#include "report/core/plot_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace bole {
namespace {

// Four stems that count on a plot of 20 m x 25 m (500 m2), one outside, one too thin, one rejected.
Table stems() {
  const double nan = std::nan("");
  Table t;
  t.set("x_m", std::vector<double>{0, 5, -5, 9.9, 10.1, 1, 2});
  t.set("y_m", std::vector<double>{0, 12.5, 3, -4, 0, 1, 2});
  t.set("dbh_cm", std::vector<double>{10, 20, 30, 40, 50, 5, 35});
  t.set("height_m", std::vector<double>{10, nan, 20, 24, 30, 4, 22});
  t.set("state", std::vector<std::string>{"auto", "auto", "check", "edited", "auto", "auto", "rejected"});
  return t;
}

const PlotArea rectangle{PlotArea::Shape::rectangle, {0, 0}, 20, 25};

TEST(PlotMetrics, ByHand) {
  const auto m = plot_metrics(stems(), rectangle, 7, 10);
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
  EXPECT_EQ(m.heights, 3U);
  EXPECT_DOUBLE_EQ(m.mean_height_m, 18);
  // (10 * 1 + 20 * 9 + 24 * 16) / 26
  EXPECT_NEAR(m.lorey_height_m, 574.0 / 26, 1e-12);
  // 100 per hectare are 5 on 500 m2: all three with a height.
  EXPECT_EQ(m.dominant_stems, 3U);
  EXPECT_DOUBLE_EQ(m.dominant_height_m, 18);
}

TEST(PlotMetrics, DominantHeightTakesTheThickest) {
  // 200 m2: two stems stand for 100 per hectare.
  const auto m = plot_metrics(stems(), {PlotArea::Shape::rectangle, {0, 0}, 20, 10}, 7);
  EXPECT_EQ(m.stems, 3U);  // the one at y = 12.5 is outside now
  EXPECT_EQ(m.dominant_stems, 2U);
  EXPECT_DOUBLE_EQ(m.dominant_height_m, 22);
}

TEST(PlotMetrics, Classes) {
  const auto m = plot_metrics(stems(), rectangle, 7, 10);
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
  const PlotArea circle{PlotArea::Shape::circle, {0, 0}, 20, 0};
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
  const auto a = plot_metrics(stems(), rectangle, 7), b = plot_metrics(shifted, {PlotArea::Shape::rectangle, {512345, 5412345}, 20, 25}, 7);
  EXPECT_EQ(a.stems, b.stems);
  EXPECT_DOUBLE_EQ(a.basal_area_m2_per_ha, b.basal_area_m2_per_ha);
  EXPECT_DOUBLE_EQ(a.lorey_height_m, b.lorey_height_m);
}

TEST(PlotMetrics, WithoutBoundaryNothingPerHectare) {
  const auto m = plot_metrics(stems(), {}, 7);
  EXPECT_EQ(m.stems, 5U);
  EXPECT_TRUE(std::isnan(m.stems_per_ha));
  EXPECT_TRUE(std::isnan(m.dominant_height_m));
  EXPECT_FALSE(std::isnan(m.lorey_height_m));
}

TEST(PlotMetrics, EmptyTable) {
  Table t;
  for (const char* c : {"x_m", "y_m", "dbh_cm"}) t.set(c, std::vector<double>{});
  const auto m = plot_metrics(t, rectangle, 7);
  EXPECT_EQ(m.stems, 0U);
  EXPECT_DOUBLE_EQ(m.stems_per_ha, 0);
  EXPECT_TRUE(std::isnan(m.mean_dbh_cm));
  EXPECT_THAT(metric_rows(m, 7), testing::Not(testing::IsEmpty()));
}

}  // namespace
}  // namespace bole
