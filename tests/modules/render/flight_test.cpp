// Courses of a camera, and the file of bookmarked views.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "render/scene/flight.h"

namespace bole::render {
namespace {

ViewPoint view(double x, double y, double z) { return {{x, y, z}, {x, y + 5, z}}; }

Trajectory l_shaped_walk() {
  Trajectory walk;
  for (int i = 0; i <= 40; ++i) {
    StampedPose pose;
    pose.time_s = i;
    pose.T_target_sensor.translation() = Eigen::Vector3d(std::min(i, 20), std::max(0, i - 20), 1.5 + 0.05 * (i % 2));
    walk.poses.push_back(pose);
  }
  return walk;
}

double step_m(const std::vector<ViewPoint>& flight, std::size_t k) {
  return (flight[k + 1].eye - flight[k].eye).norm();
}

TEST(Flight, PassesThroughItsStopsAndRestsAtTheEnds) {
  const std::vector<ViewPoint> stops{view(0, 0, 2), view(10, 0, 4), view(10, 10, 2)};
  const auto flight = flight_through(stops, 201);
  ASSERT_EQ(flight.size(), 201U);
  EXPECT_NEAR((flight.front().eye - stops.front().eye).norm(), 0, 1e-9);
  EXPECT_NEAR((flight.back().centre - stops.back().centre).norm(), 0, 1e-9);
  double nearest = 1e9, longest = 0;
  for (std::size_t k = 0; k + 1 < flight.size(); ++k) {
    nearest = std::min(nearest, (flight[k].eye - stops[1].eye).norm());
    longest = std::max(longest, step_m(flight, k));
    EXPECT_NEAR(flight[k].up.norm(), 1, 1e-9);
  }
  EXPECT_LT(nearest, 0.1);
  EXPECT_LT(longest, 0.3);  // no jumps
  EXPECT_LT(step_m(flight, 0), 0.1 * longest);
  EXPECT_LT(step_m(flight, 199), 0.1 * longest);
}

TEST(Flight, OfParallelViewsShowsAsMuch) {
  ViewPoint above{{0, 0, 1000}, {0, 0, 0}, Eigen::Vector3d::UnitY(), true, 10};
  const auto flight = flight_through({above, view(5, 5, 5)}, 2);
  EXPECT_FALSE(flight[0].parallel);
  EXPECT_NEAR(flight[0].eye.z() * std::tan(15 * M_PI / 180), 10, 1e-6);
}

TEST(Flight, NeedsTwoDifferentViews) {
  EXPECT_THROW(flight_through({}, 10), Error);
  EXPECT_THROW(flight_through({view(1, 1, 1), view(1, 1, 1)}, 10), Error);
}

TEST(Flight, AlongAWalkIsEvenAndLooksAhead) {
  const auto walk = l_shaped_walk();
  const WalkFlight options{0.5, 4, 3};
  const auto flight = flight_along(walk, options, 101);
  ASSERT_EQ(flight.size(), 101U);
  double lowest = 1e9, highest = 0;
  for (std::size_t k = 0; k + 1 < flight.size(); ++k) {
    lowest = std::min(lowest, step_m(flight, k));
    highest = std::max(highest, step_m(flight, k));
  }
  EXPECT_LT(highest, 1.5 * lowest);
  EXPECT_NEAR(flight[50].eye.z(), 2.03, 0.03);  // 0.5 m above a walk that bobs by 5 cm
  const Eigen::Vector3d first = flight[20].centre - flight[20].eye, last = flight.back().centre - flight.back().eye;
  EXPECT_GT(first.normalized().x(), 0.99);
  EXPECT_GT(last.normalized().y(), 0.99);  // goes on looking where nothing is ahead
  EXPECT_THROW(flight_along(Trajectory(), options, 10), Error);
}

TEST(Views, AreReadAsTheyWereWritten) {
  ViewPoint plan = view(1.25, 2, 3);
  plan.parallel = true;
  plan.half_height_m = 7.5;
  const auto views = parse_views(views_json({{"Corner", view(1, 2, 3)}, {"Plan", plan}}));
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].name, "Corner");
  EXPECT_EQ(views[1].view.eye, plan.eye);
  EXPECT_TRUE(views[1].view.parallel);
  EXPECT_EQ(views[1].view.half_height_m, 7.5);
  EXPECT_TRUE(parse_views(R"([{"name": "a", "eye": [1, 1, 1], "centre": [1, 1, 1], "up": [0, 0, 1]}])").empty());
  EXPECT_THROW(parse_views("{"), Error);
  EXPECT_THROW(parse_views("{}"), Error);
  EXPECT_THROW(parse_views(R"([{"name": "a", "eye": [1, 1]}])"), Error);
}

}  // namespace
}  // namespace bole::render
