#include "survey/core/plot_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bole::survey {
namespace {

using Shape = PlotArea::Shape;

TEST(PlotOptions, AutoTakesNoPlotOutsidePlotAxes) {
  const PlotOptions o;
  EXPECT_EQ(counting_rule_for(o, Axes::plot, nullptr).area.area_m2(), 32.0 * 32.0);
  for (const auto axes : {Axes::unknown, Axes::global, Axes::map})
    EXPECT_EQ(counting_rule_for(o, axes, nullptr).area.shape, Shape::none);
}

TEST(PlotOptions, WhatIsAskedForHoldsInAllAxes) {
  PlotOptions o;
  o.shape = PlotShape::rectangle, o.width = 10, o.length = 20, o.x = 100, o.bearing_deg = 90, o.min_dbh_cm = 5;
  const auto rule = counting_rule_for(o, Axes::global, nullptr);
  EXPECT_TRUE(rule.counts({109, 4}, 5));
  EXPECT_FALSE(rule.counts({109, 4}, 4.9));
  EXPECT_FALSE(rule.counts({104, 9}, 5));
  o.shape = PlotShape::circle, o.radius = 12;
  EXPECT_NEAR(counting_rule_for(o, Axes::map, nullptr).area.width_m, 24, 1e-12);
  o.shape = PlotShape::none;
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

}  // namespace
}  // namespace bole::survey
