#include "steering/core/plan/plan_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "checks.h"
#include "steering/core/field_test.h"
#include "steering/core/tracking_errors.h"

namespace bole::steering {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

Table points(const std::vector<Eigen::Vector2d>& at, double east = 500'000, double north = 2'500'000) {
  std::vector<double> x, y;
  for (const auto& p : at) {
    x.push_back(p.x() + east);
    y.push_back(p.y() + north);
  }
  Table t;
  t.set("x_m", x);
  t.set("y_m", y);
  return t;
}

PlanOptions wide(double width) {
  PlanOptions o;
  o.width = width;
  return o;
}

double length_of(const LinePlan& plan) {
  double sum = 0;
  for (const double l : plan.lines.numbers("length_m")) sum += l;
  return sum;
}

TEST(PlanLines, WithoutABoundaryTheyRunFromAToB) {
  auto o = wide(3);
  o.lines_left = 2;
  o.lines_right = 1;
  o.overlap = 0.2;
  o.headland_passes = 2;
  const auto plan = plan_lines(points({{0, 0}, {0, 100}}), nullptr, o, {});
  EXPECT_EQ(plan.lines.integers("line"), (std::vector<std::int64_t>{-1, 0, 1, 2}));
  EXPECT_NEAR(plan.lines.numbers("a_x_m")[2], 500'000 - 2.8, 1e-9);  // left of north is west
  EXPECT_NEAR(plan.lines.numbers("b_y_m")[2], 2'500'100, 1e-9);
  EXPECT_EQ(plan.lines.facts.at("row_width_m"), "2.8");
  ASSERT_EQ(plan.headlands.rows(), 8U);  // a rectangle at each end
  EXPECT_NEAR(plan.headlands.numbers("y_m")[0], 2'500'000 - 6, 1e-9);
  EXPECT_NEAR(plan.headlands.numbers("x_m")[0], 500'000 + 2.8 + 1.5, 1e-9);
}

TEST(PlanLines, WithoutAWidthThereIsOneLine) {
  const auto plan = plan_lines(points({{0, 0}, {30, 40}}), nullptr, {}, {});
  ASSERT_EQ(plan.lines.rows(), 1U);
  EXPECT_NEAR(length_of(plan), 50, 1e-9);
  EXPECT_FALSE(plan.lines.facts.contains("row_width_m"));
  EXPECT_EQ(plan.headlands.rows(), 0U);
}

TEST(PlanLines, FillASquareWithinItsHeadland) {
  const auto field = points({{0, 0}, {100, 0}, {100, 60}, {0, 60}});
  auto o = wide(4);
  o.headland_passes = 2;
  const auto plan = plan_lines(points({{5, 2}, {50, 2}}), &field, o, {});
  // Lines at 2, 6, 10, ... m from the southern side; those from 8 to 52 m lie within the headland.
  ASSERT_EQ(plan.lines.rows(), 11U);
  EXPECT_EQ(plan.lines.integers("line").front(), 2);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_NEAR(plan.lines.numbers("a_x_m")[i], 500'008, 1e-6);
    EXPECT_NEAR(plan.lines.numbers("b_x_m")[i], 500'092, 1e-6);
    EXPECT_NEAR(plan.lines.numbers("a_y_m")[i], 2'500'010 + 4.0 * static_cast<double>(i), 1e-6);
  }
  EXPECT_NEAR(plan.report.metrics.at("field_area").value, 6000, 1e-6);
  EXPECT_NEAR(plan.report.metrics.at("headland_area").value, 6000 - 84 * 44, 1e-6);
}

// Turned and shifted, a plan is the same plan.
TEST(PlanLines, TurnWithTheField) {
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {90, 0}, {90, 40}, {60, 40}, {60, 70}, {0, 70}};
  const auto turned = [&](double angle) {
    std::vector<Eigen::Vector2d> at, ab;
    const Eigen::Rotation2Dd R(angle);
    for (const auto& c : corners) at.push_back(R * c);
    ab = {R * Eigen::Vector2d(10, 3.5), R * Eigen::Vector2d(80, 3.5)};
    const auto field = points(at);
    return plan_lines(points(ab), &field, wide(3), {});
  };
  const auto straight = turned(0), other = turned(2.2);
  ASSERT_EQ(straight.lines.rows(), other.lines.rows());
  EXPECT_NEAR(length_of(straight), length_of(other), 1e-4);
  EXPECT_NEAR(straight.report.metrics.at("headland_area").value, other.report.metrics.at("headland_area").value, 1e-3);
}

// A field with a bay: lines across it come in two parts.
TEST(PlanLines, ABayCutsLinesInTwo) {
  const auto field = points({{0, 0}, {100, 0}, {100, 50}, {70, 50}, {70, 20}, {30, 20}, {30, 50}, {0, 50}});
  auto o = wide(5);
  o.headland_passes = 0;
  const auto plan = plan_lines(points({{0, 2.5}, {100, 2.5}}), &field, o, {});
  const auto line = plan.lines.integers("line"), part = plan.lines.integers("part");
  const auto length = plan.lines.numbers("length_m");
  EXPECT_EQ(plan.lines.rows(), 4U + 2 * 6U);
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(length[i], line[i] < 4 ? 100 : 30, 1e-6);
  EXPECT_EQ(part.back(), 2);
}

TEST(PlanLines, RefusesWithTheReason) {
  const auto ab = points({{5, 2}, {50, 2}});
  const auto error = [&](const Table& a, const Table* field, const PlanOptions& o) {
    return refusal_of([&] { plan_lines(a, field, o, {}); });
  };
  EXPECT_THAT(error(points({{5, 2}}), nullptr, wide(3)), HasSubstr("does not hold A and B"));
  EXPECT_THAT(error(points({{5, 2}, {5, 2}}), nullptr, wide(3)), HasSubstr("0.1 m apart"));
  auto field = points({{0, 0}, {100, 60}, {100, 0}, {0, 60}});
  EXPECT_THAT(error(ab, &field, wide(3)), HasSubstr("crosses itself"));
  field = points({{0, 0}, {100, 0}});
  EXPECT_THAT(error(ab, &field, wide(3)), HasSubstr("corners"));
  field = points({{0, 0}, {100, 0}, {100, 60}, {0, 60}});
  EXPECT_THAT(error(ab, &field, wide(20)), HasSubstr("covers the whole field"));
  const auto millimetres = points({{0, 0}, {1e5, 0}, {1e5, 6e4}, {0, 6e4}});
  EXPECT_THAT(error(ab, &millimetres, wide(0.5)), HasSubstr("at most"));
  auto here = ab, there = field;
  here.facts["crs"] = "zone 38";
  there.facts["crs"] = "zone 39";
  EXPECT_THAT(error(here, &there, wide(3)), HasSubstr("different planes"));
  Table geodetic;
  geodetic.set("latitude_deg", std::vector<double>{50, 50});
  geodetic.set("longitude_deg", std::vector<double>{8, 8});
  EXPECT_THAT(error(geodetic, nullptr, wide(3)), HasSubstr("geo.project"));
}

// Rows named A and B in any order, and a drive measured against the lines that were planned for it.
TEST(PlanLines, MeasureTheDriveThatFollowedThem) {
  auto ab = points({{160, 0}, {0, 0}}, 0, 0);
  ab.set("name", std::vector<std::string>{"B", "A"});
  FieldTestOptions o;
  o.speeds = "5";
  const auto drive = simulate_field_test(o, {});
  const auto field = points({{-30, 1}, {200, 1}, {200, 40}, {-30, 40}}, 0, 0);
  auto options = wide(o.row_width);
  options.headland_passes = 0;
  const auto plan = plan_lines(ab, &field, options, {});
  ASSERT_EQ(plan.lines.integers("line").front(), 1);  // that through A and B lies outside the field
  auto log = drive.log;
  log.facts.clear();
  const auto by_plan = tracking_errors(log, &plan.lines, nullptr, {}, {});
  const auto by_drive = tracking_errors(drive.log, &drive.lines, nullptr, {}, {});
  ASSERT_EQ(by_plan.passes.rows(), by_drive.passes.rows());
  for (std::size_t i = 0; i < by_plan.passes.rows(); ++i) {
    EXPECT_EQ(by_plan.passes.integers("row")[i], by_drive.passes.integers("row")[i]);
    EXPECT_NEAR(by_plan.passes.numbers("line_mean_m")[i], by_drive.passes.numbers("line_mean_m")[i], 1e-6);
  }
}

}  // namespace
}  // namespace bole::steering
