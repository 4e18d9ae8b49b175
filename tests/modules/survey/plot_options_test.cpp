#include "survey/core/plot_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "survey/core/plot_cover.h"

namespace bole::survey {
namespace {

using Shape = PlotArea::Shape;

TEST(PlotOptions, AutoTakesNoPlotOutsidePlotAxes) {
  const PlotOptions o;
  EXPECT_EQ(counting_rule_for(o, Axes::plot, nullptr).area.area_m2(), 32.0 * 32.0);
  for (const auto axes : {Axes::unknown, Axes::global, Axes::map})
    EXPECT_EQ(counting_rule_for(o, axes, nullptr).area.shape, Shape::none);
}

TEST(PlotOptions, ASizeThatNobodyGaveIsAssumed) {
  PlotOptions o;
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr).assumed_size, "32 m x 32 m");
  o.shape = PlotShape::circle;
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr).assumed_size, "a radius of 15 m");
  o.radius = 15;
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr).assumed_size, "");
  o = {};
  o.length = 20;
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr).assumed_size, "");
  EXPECT_EQ(placed_plot({}, Axes::map, nullptr).assumed_size, "");
}

TEST(PlotOptions, ContradictionsAreFoundBeforeARun) {
  OptionSet options(option_table(static_cast<const PlotOptions*>(nullptr)));
  options.set_text("radius", "4");
  options.check_all();
  options.set_text("width", "3");
  EXPECT_THROW(options.check_all(), Error);
}

TEST(PlotOptions, WhatIsAskedForHoldsInAllAxes) {
  PlotOptions o;
  o.shape = PlotShape::rectangle, o.width = 10, o.length = 20, o.x = 100, o.bearing_deg = 90, o.min_dbh_cm = 5;
  const auto rule = counting_rule_for(o, Axes::global, nullptr);
  EXPECT_TRUE(rule.counts({109, 4}, 5));
  EXPECT_FALSE(rule.counts({109, 4}, 4.9));
  EXPECT_FALSE(rule.counts({104, 9}, 5));
  o = {}, o.shape = PlotShape::circle, o.radius = 12;
  EXPECT_NEAR(counting_rule_for(o, Axes::map, nullptr).area.width_m, 24, 1e-12);
  o = {}, o.shape = PlotShape::none;
  EXPECT_EQ(counting_rule_for(o, Axes::plot, nullptr).area.shape, Shape::none);
}

TEST(PlotOptions, PolygonNeedsVertices) {
  PlotOptions o;
  Table corners;
  corners.set("x_m", std::vector<double>{0, 10, 0}), corners.set("y_m", std::vector<double>{0, 0, 10});
  EXPECT_NEAR(counting_rule_for(o, Axes::unknown, &corners).area.area_m2(), 50, 1e-12);
  o.shape = PlotShape::polygon;
  try {
    counting_rule_for(o, Axes::plot, nullptr);
    FAIL() << "accepted";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("no vertices"));
  }
}

// Every option that is given decides the shape, without the word for it.
TEST(PlotOptions, SizesImplyTheirShape) {
  PlotOptions o;
  o.width = 20, o.length = 10;
  EXPECT_EQ(counting_rule_for(o, Axes::unknown, nullptr).area.shape, Shape::rectangle);
  EXPECT_NEAR(counting_rule_for(o, Axes::unknown, nullptr).area.area_m2(), 200, 1e-12);
  o = {}, o.width = 20;
  EXPECT_NEAR(counting_rule_for(o, Axes::unknown, nullptr).area.area_m2(), 400, 1e-12) << "a square";
  o = {}, o.radius = 10;
  for (const auto axes : {Axes::unknown, Axes::plot, Axes::global})
    EXPECT_EQ(counting_rule_for(o, axes, nullptr).area.shape, Shape::circle);
  EXPECT_NEAR(counting_rule_for(o, Axes::plot, nullptr).area.width_m, 20, 1e-12);
}

TEST(PlotOptions, TheCentreIsGivenOrTheTargetOrTheMiddleOfTheScan) {
  PlotOptions o;
  o.radius = 10;
  PlotSite site;
  site.middle = [] { return std::optional(Eigen::Vector2d(10, 12)); };
  auto plot = placed_plot(o, Axes::unknown, nullptr, site);
  EXPECT_EQ(plot.rule.area.centre, Eigen::Vector2d(10, 12));
  EXPECT_THAT(plot.centre, testing::HasSubstr("middle"));
  site.target = Eigen::Vector2d(3, 4);
  EXPECT_EQ(placed_plot(o, Axes::map, nullptr, site).rule.area.centre, Eigen::Vector2d(3, 4));
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr, site).rule.area.centre, Eigen::Vector2d(0, 0));
  o.x = 5, o.y = 6;
  EXPECT_EQ(placed_plot(o, Axes::plot, nullptr, site).rule.area.centre, Eigen::Vector2d(5, 6));
}

// Nothing that is given is ignored without a word.
TEST(PlotOptions, ContradictionsAreRefusedByName) {
  Table corners;
  corners.set("x_m", std::vector<double>{0, 10, 0}), corners.set("y_m", std::vector<double>{0, 0, 10});
  struct Case {
    PlotOptions options;
    const Table* vertices;
    std::vector<std::string> named;
  };
  std::vector<Case> cases(6);
  cases[0].options.radius = 10, cases[0].options.width = 20, cases[0].named = {"radius", "width"};
  cases[1].options.shape = PlotShape::rectangle, cases[1].options.radius = 10, cases[1].named = {"radius", "rectangle"};
  cases[2].options.shape = PlotShape::circle, cases[2].options.length = 10, cases[2].named = {"length", "circle"};
  cases[3].options.shape = PlotShape::none, cases[3].options.width = 10, cases[3].named = {"width", "none"};
  cases[4].options.radius = 10, cases[4].vertices = &corners, cases[4].named = {"radius", "polygon"};
  cases[5].options.x = 10, cases[5].named = {"option x", "no size"};
  for (const auto& c : cases) try {
      counting_rule_for(c.options, Axes::map, c.vertices);
      FAIL() << "accepted: " << c.named.front();
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::bad_input);
      for (const auto& name : c.named) EXPECT_THAT(e.what(), testing::HasSubstr(name));
    }
}

PointCloud square_cloud(double from, double to) {
  PointCloud::Positions positions;
  for (double x = from; x <= to; x += 0.2)
    for (double y = from; y <= to; y += 0.2) positions.emplace_back(static_cast<float>(x), static_cast<float>(y), 1.0F);
  return PointCloud(std::move(positions), {500000, 5300000, 0});
}

TEST(PlotCover, TheMiddleIsThatOfTheScanAndNotOfStrayPoints) {
  auto cloud = square_cloud(0, 20);
  auto positions = cloud.positions();
  positions.emplace_back(180.0F, 40.0F, 3.0F);
  cloud.set_positions(std::move(positions));
  const auto middle = middle_of(cloud, {});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x(), 500010, 0.6);
  EXPECT_NEAR(middle->y(), 5300010, 0.6);
  EXPECT_FALSE(middle_of(PointCloud(), {}));
}

TEST(PlotCover, ThreeQuartersOfACircleAboutTheCornerAreEmpty) {
  const auto cloud = square_cloud(0, 20);
  EXPECT_NEAR(empty_share(circle_area({500000, 5300000}, 10), cloud, {}), 0.75, 0.03);
  EXPECT_NEAR(empty_share(circle_area({500010, 5300010}, 9.5), cloud, {}), 0, 0.001);
  EXPECT_TRUE(std::isnan(empty_share(PlotArea(), cloud, {})));
}

}  // namespace
}  // namespace bole::survey
