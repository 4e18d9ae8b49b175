#include "geo/core/resection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "base/angles.h"
#include "base/error.h"
#include "checks.h"
#include "geo/core/attitude.h"

namespace bole::geo {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

// Marks about a robot at several heights; the sensor stands at `sensor`.
const Eigen::Vector3d sensor(1.2, -0.7, 0.6);
const std::vector<Eigen::Vector3d> marks{{5, 3, 1.9}, {-4, 6, 0.3}, {6, -5, 1.1}, {-3, -4, 3.0}};
const std::vector<Eigen::Vector3d> raised{{5, 3, 2.4}, {-4, 6, 2.0}, {6, -5, 2.6}};  // clearly above the sensor

std::vector<RangeToMark> ranges_to(const std::vector<Eigen::Vector3d>& at, const Eigen::Vector3d& from) {
  std::vector<RangeToMark> ranges;
  for (const auto& m : at) ranges.push_back({m, (m - from).norm(), 0.02});
  return ranges;
}

TEST(Resection, FindsTheSensorFromThreeAndFourMarks) {
  const auto four = resect(ranges_to(marks, sensor));
  EXPECT_LT((four.position_nav - sensor).norm(), 1e-8);
  EXPECT_EQ(four.redundancy, 1);
  ResectionOptions options;
  options.near_nav = Eigen::Vector3d(0, 0, 0);
  const auto r = resect(ranges_to(raised, sensor), options);
  EXPECT_LT((r.position_nav - sensor).norm(), 1e-8);
  EXPECT_EQ(r.redundancy, 0);
  EXPECT_TRUE(std::isnan(r.sigma0));
}

TEST(Resection, ItsCovarianceIsThatOfRepeatedTrials) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  const auto clean = ranges_to(marks, sensor);
  const auto predicted = resect(clean).covariance;
  Eigen::Matrix3d sample = Eigen::Matrix3d::Zero();
  constexpr int trials = 2000;
  double sigma0_square = 0;
  for (int i = 0; i < trials; ++i) {
    auto ranges = clean;
    for (auto& r : ranges) r.range_m += noise(random);
    const auto result = resect(ranges);
    const Eigen::Vector3d e = result.position_nav - sensor;
    sample += e * e.transpose() / trials;
    sigma0_square += result.sigma0 * result.sigma0 / trials;
  }
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(sample(i, i) / predicted(i, i), 1, 0.12);
  EXPECT_NEAR(sigma0_square, 1, 0.12);
}

TEST(Resection, RefusesGeometryThatDoesNotCarryAPosition) {
  const std::vector<Eigen::Vector3d> line{{0, 0, 1}, {3, 0, 1}, {7, 0, 1}};
  EXPECT_THAT(refusal_of([&] { resect(ranges_to(line, sensor)); }), HasSubstr("on a line"));
  EXPECT_THAT(refusal_of([&] { resect(ranges_to({marks[0], marks[1]}, sensor)); }), HasSubstr("at least 3"));
  EXPECT_THAT(refusal_of([&] { resect(ranges_to(raised, sensor)); }), HasSubstr("two positions alike"));
  const std::vector<Eigen::Vector3d> flat{{5, 3, 1}, {-4, 6, 1}, {6, -5, 1}};
  const Eigen::Vector3d in_plane(1, 1, 1);
  EXPECT_THAT(refusal_of([&] { resect(ranges_to(flat, in_plane)); }), HasSubstr("in the plane of the marks"));
  auto wrong = ranges_to(marks, sensor);
  std::swap(wrong[0].range_m, wrong[1].range_m);
  EXPECT_THAT(refusal_of([&] { resect(wrong); }), HasSubstr("meet nowhere"));
  auto negative = ranges_to(marks, sensor);
  negative[2].range_m = -1;
  EXPECT_THAT(refusal_of([&] { resect(negative); }), HasSubstr("mark 3"));
}

TEST(Resection, AKnownHeightServesMarksAtTheSensorsHeight) {
  const std::vector<Eigen::Vector3d> flat{{5, 3, 1}, {-4, 6, 1}, {6, -5, 1}};
  const Eigen::Vector3d in_plane(1, 1, 1);
  ResectionOptions options;
  options.height_m = 1;
  const auto r = resect(ranges_to(flat, in_plane), options);
  EXPECT_LT((r.position_nav - in_plane).norm(), 1e-8);
  EXPECT_EQ(r.redundancy, 1);
  EXPECT_EQ(r.covariance(2, 2), 0);
}

// A shift by projected coordinates changes nothing but the position.
TEST(Resection, WorksInProjectedCoordinates) {
  const Eigen::Vector3d shift(434'000.25, 2'562'000.5, 21);
  auto shifted = marks;
  for (auto& m : shifted) m += shift;
  EXPECT_LT((resect(ranges_to(shifted, sensor + shift)).position_nav - sensor - shift).norm(), 1e-6);
}

TEST(Heading, IsTheTurnBetweenSeenAndKnownDirections) {
  const double yaw = 2.8;
  std::vector<DirectionPair> pairs;
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
    const Eigen::Vector2d known = (marks[static_cast<std::size_t>(a)] - marks[static_cast<std::size_t>(b)]).head<2>();
    pairs.push_back({Eigen::Rotation2Dd(-yaw) * known, known});
  }
  const auto heading = heading_from_directions(pairs);
  EXPECT_NEAR(heading.yaw_rad, yaw, 1e-12);
  EXPECT_LT(heading.worst_residual_rad, 1e-12);
  EXPECT_LT(heading.se_rad, 0.2 * rad_per_deg);
  pairs[1].seen *= 1.1;
  EXPECT_THAT(refusal_of([&] { heading_from_directions(pairs); }), HasSubstr("direction 2"));
  EXPECT_THAT(refusal_of([&] { heading_from_directions({}); }), HasSubstr("0 directions"));
}

TEST(Attitude, LeverArmAndBearings) {
  // Driving north (yaw 90 deg), antenna 1 m ahead of and 2.5 m above the rear axle.
  const Eigen::Vector3d lever(1, 0, 2.5), antenna(100, 200, 30);
  EXPECT_LT((control_point(antenna, {0, 0, 90 * rad_per_deg}, lever) - Eigen::Vector3d(100, 199, 27.5)).norm(), 1e-12);
  // A roll of 5 deg lowers the right side: the antenna swings to the right, which is east, so the point lies west of
  // it.
  const auto rolled = control_point(antenna, {5 * rad_per_deg, 0, 90 * rad_per_deg}, lever);
  EXPECT_NEAR(rolled.x() - antenna.x(), -2.5 * std::sin(5 * rad_per_deg), 1e-12);
  EXPECT_NEAR(bearing_from_yaw_rad(90 * rad_per_deg), 0, 1e-12);
  EXPECT_NEAR(bearing_from_yaw_rad(180 * rad_per_deg), 270 * rad_per_deg, 1e-12);
  for (double bearing = 0.05; bearing < 2 * std::numbers::pi; bearing += 0.3)
    EXPECT_NEAR(bearing_from_yaw_rad(yaw_from_bearing_rad(bearing)), bearing, 1e-12);
}

}  // namespace
}  // namespace bole::geo
