#include "rows/core/frame/trunk_face.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/error.h"
#include "rows/core/frame/frame_filters.h"
#include "rows/core/frame/mean_shift.h"
#include "rows/core/frame/trunk_centres.h"

namespace bole::rows {
namespace {

// What a sensor at the origin sees of a leaning cylinder: directions even over its width, ranges with noise.
std::vector<Eigen::Vector3d> face_of(const Eigen::Vector2d& centre, double radius, double sigma, double lean, int n,
                                     unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, sigma);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Eigen::Vector3d> points;
  const Eigen::Vector2d ahead = centre.normalized(), left(-ahead.y(), ahead.x());
  for (int i = 0; i < n; ++i) {
    const double h = 0.5 * unit(random), u = 0.999 * radius * unit(random), depth = std::sqrt(radius * radius - u * u);
    const Eigen::Vector2d p = centre + (u + lean * h) * left - depth * ahead;
    const Eigen::Vector2d q = p * (1 + noise(random) / p.norm());
    points.emplace_back(q.x(), q.y(), h);
  }
  return points;
}

TEST(TrunkFace, TheAxisLiesBehindTheFace) {
  for (const auto& [radius, widest] : {std::pair{0.0125, 0.12}, {0.025, 0.12}, {0.1, 0.5}, {0.2, 0.5}})
    for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0.6, 3), Eigen::Vector2d(-1.4, 8)})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        const auto points = face_of(centre, radius, 0.02, 0.01, 300, seed);
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const auto& p : points) mean += p.head<2>() / static_cast<double>(points.size());
        const auto fit = fit_trunk_face(points, mean, widest, 0.02);
        ASSERT_TRUE(fit);
        EXPECT_LT((fit->centre - centre).norm(), 0.004 + 0.05 * radius) << radius << " seed " << seed;
        EXPECT_NEAR(fit->radius_m, radius, 0.15 * radius);
        EXPECT_GT((mean - centre).norm(), 0.5 * radius);  // what the mean is off by
      }
}

TEST(TrunkFace, LeavesDoNotMoveIt) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> off(0, 0.03);
  const Eigen::Vector2d centre(0.5, 3);
  auto points = face_of(centre, 0.02, 0.02, 0, 300, 1);
  for (int i = 0; i < 60; ++i) points.emplace_back(0.56 + off(random), 2.95 + off(random), 0.3 + off(random));
  const auto fit = fit_trunk_face(points, centre, 0.12, 0.02);
  ASSERT_TRUE(fit);
  EXPECT_LT((fit->centre - centre).norm(), 0.008);
}

TEST(TrunkFace, AnUprightStripIsFoundBesideACloudOfLeaves) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> off(0, 0.05);
  const Eigen::Vector2d centre(0.5, 3);
  auto points = face_of(centre, 0.02, 0.02, 0, 60, 1);
  for (int i = 0; i < 500; ++i) points.emplace_back(0.7 + off(random), 3.05 + off(random), 0.2 + 0.7 * off(random));
  const auto strip = find_upright(points, 0.12, 0.02, 0.05);
  EXPECT_LT((strip.at - centre).norm(), 0.05);
  EXPECT_GT(strip.high_m - strip.low_m, 0.85);
  EXPECT_GT(strip.filled, 0.9);
  EXPECT_EQ(find_upright({}, 0.1, 0.02, 0.05).layers, 0);
  EXPECT_FALSE(fit_trunk_face({}, centre, 0.1, 0.02));
}

TEST(Frame, EveryPointIsLevelledByTheAttitudeOfItsTime) {
  PointCloud frame(PointCloud::Positions{{0, 5, 0}, {0, 5, 0}, {0, 5, 0}});
  frame.set_column("time", std::vector<double>{0, 0.5, 1});
  Table attitude;
  attitude.set("time_s", std::vector<double>{0, 1});
  attitude.set("roll_deg", std::vector<double>{0, 10});
  attitude.set("pitch_deg", std::vector<double>{0, 0});
  attitude.set("yaw_deg", std::vector<double>{179, -179});
  const auto out = level(frame, {}, &attitude);
  const double deg = std::numbers::pi / 180;
  EXPECT_NEAR(out.position(1).z(), 5 * std::sin(5 * deg), 1e-5);
  EXPECT_NEAR(out.position(2).z(), 5 * std::sin(10 * deg), 1e-5);
  EXPECT_NEAR(out.position(1).y(), -5 * std::cos(5 * deg), 1e-5);  // half way from 179 to 181
  frame.set_column("time", std::vector<double>{0, 0.5, 9});
  EXPECT_THROW(level(frame, {}, &attitude), Error);
  EXPECT_THROW(level(PointCloud(PointCloud::Positions{{0, 5, 0}}), {}, &attitude), Error);
  attitude.set("time_s", std::vector<double>{1, 1});
  EXPECT_THROW(level(frame, {}, &attitude), Error);
}

TEST(Frame, TheFaceNeedsTheDenseFrame) {
  PointCloud plants(PointCloud::Positions{{0, 5, 0}});
  plants.set_column(plant_column, std::vector<std::int32_t>{1});
  TrunkOptions o;
  o.centre = TrunkCentre::face;
  Report report;
  EXPECT_THROW(trunk_centres(plants, nullptr, o, report), Error);
  EXPECT_EQ(trunk_centres(plants, &plants, o, report).stems.rows(), 0U);
}

}  // namespace
}  // namespace bole::rows
