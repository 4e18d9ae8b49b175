#include "cloud/plot_area.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.h"
#include "synthetic/comma_locale.h"

namespace bole {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

const std::vector<Vector2d> ell{{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 30}, {0, 30}};

TEST(PlotArea, RectangleFollowsItsBearing) {
  const auto upright = rectangle_area({5, 5}, 10, 40), turned = rectangle_area({5, 5}, 10, 40, std::numbers::pi / 2);
  EXPECT_TRUE(upright.contains(5, 24));
  EXPECT_FALSE(upright.contains(24, 5));
  EXPECT_TRUE(turned.contains(24, 5));
  EXPECT_FALSE(turned.contains(5, 24));
  const auto north_east = rectangle_area({0, 0}, 2, 40, std::numbers::pi / 4);
  EXPECT_TRUE(north_east.contains(13, 13));
  EXPECT_FALSE(north_east.contains(-13, 13));
  for (const auto& p : north_east.outline()) EXPECT_TRUE(north_east.contains(p * (1 - 1e-9)));
  EXPECT_NEAR(north_east.area_m2(), polygon_area(north_east.outline()).area_m2(), 1e-9);
}

TEST(PlotArea, TheBoundaryCountsAsInside) {
  EXPECT_TRUE(rectangle_area({0, 0}, 32, 32).contains(16, -16));
  EXPECT_TRUE(circle_area({0, 0}, 15).contains(0, 15));
  EXPECT_FALSE(circle_area({0, 0}, 15).contains(0, 15.001));
  const auto polygon = polygon_area(ell);
  for (const auto& p : {Vector2d(0, 0), Vector2d(10, 20), Vector2d(15, 10), Vector2d(10, 10)})
    EXPECT_TRUE(polygon.contains(p)) << p.transpose();
}

TEST(PlotArea, PolygonMayBeHollowAndLieAnywhere) {
  for (const Vector2d& shift : {Vector2d(0, 0), Vector2d(512345.25, 5412345.5)}) {
    auto vertices = ell;
    for (auto& v : vertices) v += shift;
    const auto area = polygon_area(vertices);
    EXPECT_NEAR(area.area_m2(), 400, 1e-6);
    EXPECT_TRUE(area.contains(shift + Vector2d(5, 25)));
    EXPECT_TRUE(area.contains(shift + Vector2d(15, 5)));
    EXPECT_FALSE(area.contains(shift + Vector2d(15, 20)));
    EXPECT_FALSE(area.contains(shift + Vector2d(-1, 5)));
    EXPECT_NEAR(area.centre.x() - shift.x(), (200 * 10 + 200 * 5) / 400.0, 1e-6);
    EXPECT_NEAR(area.centre.y() - shift.y(), (200 * 5 + 200 * 20) / 400.0, 1e-6);
  }
}

TEST(PlotArea, PolygonsThatEncloseNothingAreRefused) {
  const auto text_of = [](std::vector<Vector2d> v) -> std::string {
    try {
      polygon_area(std::move(v));
    } catch (const Error& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(text_of({}), HasSubstr("encloses nothing"));
  EXPECT_THAT(text_of({{0, 0}, {1, 1}, {2, 2}}), HasSubstr("encloses nothing"));
  EXPECT_THAT(text_of({{0, 0}, {1, 0}, {NAN, 1}}), HasSubstr("vertex 3"));
  EXPECT_THAT(text_of({{0, 0}, {4, 4}, {4, 0}, {0, 1}}), HasSubstr("crosses itself"));
  EXPECT_EQ(text_of({{0, 0}, {4, 0}, {4, 4}, {0, 0}}), "accepted");  // closed by hand
}

TEST(CountingRule, TravelsAsATable) {
  for (const auto& area :
       {PlotArea{}, rectangle_area({0.1, 512345.678}, 20, 25, 0.3), circle_area({1, 2}, 12.62), polygon_area(ell)}) {
    const auto back = counting_rule(to_table({area, 5.5}));
    EXPECT_EQ(back.min_dbh_cm, 5.5);
    EXPECT_EQ(back.area.shape, area.shape);
    EXPECT_EQ(back.area.centre, area.centre);
    EXPECT_EQ(back.area.bearing_rad, area.bearing_rad);
    EXPECT_EQ(back.area.vertices, area.vertices);
    EXPECT_EQ(back.area.outline(), area.outline());
  }
  EXPECT_THROW(counting_rule(Table{}), Error);
}

TEST(CountingRule, NoRuleMeansEveryTree) {
  EXPECT_TRUE(CountingRule{}.counts({512345, 5412345}, 5));
  EXPECT_TRUE(CountingRule{}.counts({0, 0}, NAN));
  const CountingRule thick{{}, 7.5};
  EXPECT_FALSE(thick.counts({0, 0}, 7.4));
  EXPECT_TRUE(thick.counts({0, 0}, 7.5));
  EXPECT_FALSE(thick.counts({0, 0}, NAN));
}

TEST(CountingRule, SpeaksNoLanguage) {
  const CommaLocale comma;
  ASSERT_TRUE(comma) << "localedef of glibc is needed";
  CountingRule rule{rectangle_area({0.25, -1.5}, 12.5, 40.75, 0.5), 7.5};
  const auto back = counting_rule(to_table(rule));
  EXPECT_EQ(back.min_dbh_cm, 7.5);
  EXPECT_EQ(back.area.centre, Vector2d(0.25, -1.5));
  EXPECT_EQ(back.area.width_m, 12.5);
  Table table;
  table.set("dbh_cm", std::vector<double>{12.345, -0.5});
  EXPECT_EQ(table.text("dbh_cm", 0, 2), "12.35");
  EXPECT_EQ(table.text("dbh_cm", 1, 0), "-0");
}

TEST(CountingRule, AFactThatIsNoNumberIsRefused) {
  Table table = to_table({circle_area({0, 0}, 15), 7});
  table.facts["width_m"] = "12,5";
  try {
    counting_rule(table);
    FAIL() << "taken";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("the fact 'width_m' of the plot is '12,5'"));
  }
}

}  // namespace
}  // namespace bole
