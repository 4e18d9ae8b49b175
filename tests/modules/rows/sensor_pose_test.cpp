#include "rows/core/frame/sensor_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/angles.h"
#include "base/transform.h"
#include "checks.h"
#include "rows/core/frame/place_stems.h"
#include "rows/core/rows/find_rows.h"

namespace bole::rows {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

const Eigen::Vector3d robot(512'345.6, 2'560'120.3, 30.2);
const double yaw_deg = -35;
const std::vector<Eigen::Vector3d> places{{-3.2, 7.5, 0.9}, {2.8, 6.0, 1.3}, {0.4, 4.0, 0.4}};
const std::vector<Eigen::Vector3d> around{{5, 3, 1.3}, {-4, 6, -0.3}, {6, -5, 0.5}, {-3, -4, 2.4}};

Table marks_table(const std::vector<Eigen::Vector3d>& seen) {
  std::vector<std::string> name;
  std::vector<double> x, y, z, sx, sy, sz;
  for (const auto& s : seen) {
    const Eigen::Vector3d p = robot + rotation_from_rpy(0, 0, radians(yaw_deg)) * s;
    name.emplace_back(1, static_cast<char>('E' + name.size()));
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    sx.push_back(s.x());
    sy.push_back(s.y());
    sz.push_back(s.z());
  }
  Table t;
  t.set("name", name);
  t.set("x_m", x);
  t.set("y_m", y);
  t.set("z_m", z);
  t.set("seen_x_m", sx);
  t.set("seen_y_m", sy);
  t.set("seen_z_m", sz);
  return t;
}

void add_to(Table& t, const char* column, std::size_t row, double by) {
  auto values = t.numbers(column);
  values[row] += by;
  t.set(column, values);
}

double value(const Table& t, const char* column) { return t.numbers(column)[0]; }

TEST(SensorPose, IsFoundFromVectorsAndFromRanges) {
  for (const auto method : {ResectMethod::vectors, ResectMethod::ranges}) {
    ResectOptions o;
    o.method = method;
    const auto found = sensor_pose(marks_table(around), o);
    EXPECT_NEAR(value(found.pose, "x_m"), robot.x(), 1e-6);
    EXPECT_NEAR(value(found.pose, "y_m"), robot.y(), 1e-6);
    EXPECT_NEAR(value(found.pose, "z_m"), robot.z(), 1e-6);
    EXPECT_NEAR(value(found.pose, "yaw_deg"), yaw_deg, 1e-6);
    EXPECT_NEAR(value(found.pose, "bearing_deg"), 35, 1e-6);  // the y axis turned clockwise from north
    EXPECT_NEAR(value(found.pose, "cov_x_x_m2"), std::pow(value(found.pose, "x_se_m"), 2), 1e-12);
    EXPECT_NEAR(value(found.pose, "cov_yaw_yaw_rad2"), std::pow(radians(value(found.pose, "yaw_se_deg")), 2), 1e-12);
    EXPECT_EQ(found.residuals.rows(), around.size());
    EXPECT_TRUE(found.report.findings.empty());
  }
}

// With marks before the robot only, ranges leave the height open: the vectors do not.
TEST(SensorPose, MarksAheadAloneCarryNoHeightByRanges) {
  ResectOptions o;
  const double height_se = value(sensor_pose(marks_table(places), o).pose, "z_se_m");
  const std::vector<Eigen::Vector3d> level{{-3, 7, 0}, {3, 6, 0}, {0.4, 4, 0}};
  EXPECT_LT(value(sensor_pose(marks_table(level), o).pose, "x_se_m"), 0.03);
  o.method = ResectMethod::ranges;
  EXPECT_GT(value(sensor_pose(marks_table(places), o).pose, "z_se_m"), 5 * height_se);
  EXPECT_THAT(refusal_of([&] { sensor_pose(marks_table(level), o); }), HasSubstr("method=vectors"));
}

TEST(SensorPose, TurnsTheFrameLevelFirst) {
  auto t = marks_table(around);
  const auto tilt = rotation_from_rpy(radians(5), radians(-3), 0);
  std::vector<double> x, y, z;
  for (const auto& s : around) {
    const Eigen::Vector3d raw = tilt.transpose() * s;
    x.push_back(raw.x());
    y.push_back(raw.y());
    z.push_back(raw.z());
  }
  t.set("seen_x_m", x);
  t.set("seen_y_m", y);
  t.set("seen_z_m", z);
  ResectOptions o;
  EXPECT_THROW(sensor_pose(t, o), Error);
  o.roll_deg = 5;
  o.pitch_deg = -3;
  EXPECT_NEAR(value(sensor_pose(t, o).pose, "yaw_deg"), yaw_deg, 1e-6);
}

TEST(SensorPose, ToldWhichMarkIsWrong) {
  auto t = marks_table(around);
  add_to(t, "x_m", 2, 0.5);
  const auto error = refusal_of([&] { sensor_pose(t, {}); });
  EXPECT_THAT(error, HasSubstr("apart as seen"));
  EXPECT_THAT(error, HasSubstr("without mark G the others agree"));
  t = marks_table(around);
  add_to(t, "x_m", 2, 0.15);  // within the limit of distances
  const auto found = sensor_pose(t, {});
  ASSERT_EQ(found.report.findings.size(), 1U);
  EXPECT_EQ(found.report.findings[0].code, "marks_disagree");
  EXPECT_THAT(found.report.findings[0].text, HasSubstr("without mark G"));
  EXPECT_GT(value(found.pose, "x_se_m"), value(sensor_pose(marks_table(around), {}).pose, "x_se_m"));
}

TEST(SensorPose, RefusesWithTheReason) {
  auto t = marks_table(around);
  const auto x = t.numbers("x_m"), y = t.numbers("y_m");
  t.set("x_m", y);
  t.set("y_m", x);
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("swapped"));
  t = marks_table(around);
  t.remove("seen_x_m");
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("seen_x_m"));
  t = marks_table({around[0]});
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("1 marks"));
  t = marks_table(around);
  t.set("range_m", std::vector<double>{5, 7, 8, 5});
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("mark E has the range"));
  t = marks_table({{0, 5, 0}, {0.05, 5.02, 1}});
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("standard error"));
  t = marks_table(around);
  t.remove("x_m");
  t.set("latitude_deg", y);
  EXPECT_THAT(refusal_of([&] { sensor_pose(t, {}); }), HasSubstr("geo.project"));
}

TEST(SensorPose, PlacesStemsAndWidensTheirDirections) {
  auto marks = marks_table(places);
  marks.facts["crs"] = "PROJCS[...]";
  const auto found = sensor_pose(marks, {});
  Table stems;  // two rows ahead in the axes of the frame
  stems.set("x_m", std::vector<double>{-1, -1, -1, -1, 1, 1, 1, 1});
  stems.set("y_m", std::vector<double>{4, 5, 6, 7, 4, 5, 6, 7});
  const auto placed = place_stems(stems, {}, &found.pose);
  const Eigen::Vector3d expected = robot + rotation_from_rpy(0, 0, radians(yaw_deg)) * Eigen::Vector3d(-1, 4, 0);
  EXPECT_NEAR(placed.numbers("x_m")[0], expected.x(), 1e-6);
  EXPECT_NEAR(placed.numbers("y_m")[0], expected.y(), 1e-6);
  EXPECT_EQ(placed.facts.at("axes"), "global");
  EXPECT_EQ(placed.facts.at("crs"), "PROJCS[...]");
  RowOptions rows;
  rows.min_plants = 3;
  const auto in_rows = find_rows(placed, rows, {});
  ASSERT_EQ(in_rows.rows.rows(), 2U);
  EXPECT_NEAR(in_rows.rows.numbers("angle_deg")[0], 90 + yaw_deg, 1e-6);
  EXPECT_NEAR(in_rows.rows.numbers("angle_se_deg")[0], value(found.pose, "yaw_se_deg"), 1e-6);  // nothing else is off
  const double half = in_rows.rows.numbers("angle_hi_deg")[0] - in_rows.rows.numbers("angle_deg")[0];
  EXPECT_NEAR(half, 1.96 * value(found.pose, "yaw_se_deg"), 1e-4);
  PlaceOptions by_hand;
  by_hand.x = 3;
  EXPECT_THAT(refusal_of([&] { place_stems(stems, by_hand, &found.pose); }), HasSubstr("given twice"));
}

}  // namespace
}  // namespace bole::rows
