#include "sim/core/walk/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/resources.h"
#include "modules/sim/plots.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/walk/route.h"

namespace bole::sim {
namespace {

TEST(SurveyPattern, goes_from_the_centre_over_the_north_west_to_the_south_east_and_back) {
  for (const double size : {16.0, 32.0}) {
    const auto p = walk_pattern(size, 6);
    const double end = 0.5 * size - 1;
    EXPECT_LT(p.front().norm(), 1.5);
    EXPECT_LT(p.back().norm(), 1.5);
    EXPECT_EQ(p[2].x(), -end);  // after a rounded turn
    EXPECT_GT(p[2].y(), 0.5 * size - 6);
    EXPECT_EQ(p[p.size() - 3].x(), end);
    EXPECT_EQ(p[p.size() - 3].y(), -p[2].y());
    for (std::size_t i = 3; i + 3 < p.size(); i += 2) EXPECT_NEAR(p[i].y() - p[i + 1].y(), 6, 1e-9);  // next line
  }
}

struct PlotWalk {
  Forest forest;
  std::vector<Eigen::Vector2d> route;
  explicit PlotWalk(const char* plot, std::uint64_t seed = 1)
      : forest(make_forest(read_recipe(resource_path(std::string("plots/") + plot + ".json")), seed)) {
    const PlotScene scene = build_scene(forest, seed);
    route = plan_route(walk_pattern(forest.recipe.size_m, 6), forest, scene.vegetation.obstacles, Walk::step_m);
  }
  Walk walk(const WalkParameters& parameters = {}) const { return Walk(route, forest.terrain, parameters, 1); }
};

TEST(Route, keeps_clear_of_stems) {
  const PlotWalk plot("plot1");
  const Walk walk = plot.walk();
  for (double t = 0; t < walk.duration_s(); t += 0.1)
    for (const auto& tree : plot.forest.trees) {
      const Eigen::Vector3d p = walk.pose(t).translation();
      EXPECT_GT((p - tree.stem.axis(1.0)).head<2>().norm() - tree.stem.mean_radius(1.0), 0.42)
          << "tree " << tree.id << " at " << t;
    }
}

TEST(Walk, stands_still_then_moves_smoothly_and_comes_back) {
  const PlotWalk plot("demo");
  const Walk walk = plot.walk();
  EXPECT_GT(walk.duration_s(), 60);
  EXPECT_LT(walk.duration_s(), 110);
  const Pose start = walk.pose(0);
  for (double t = 0; t < 2.4; t += 0.1) {
    EXPECT_LT((walk.pose(t).translation() - start.translation()).norm(), 0.004);
    EXPECT_LT(so3_log(Eigen::Quaterniond(start.linear().transpose() * walk.pose(t).linear())).norm(), 0.012);
  }
  EXPECT_LT((walk.pose(walk.duration_s()).translation() - start.translation()).norm(), 0.3);
  // No jump of velocity: a person's accelerations stay below 1.5 g.
  const double d = 0.01;
  for (double t = d; t < walk.duration_s() - d; t += 0.037) {
    const Eigen::Vector3d a =
        (walk.pose(t + d).translation() - 2 * walk.pose(t).translation() + walk.pose(t - d).translation()) / (d * d);
    EXPECT_LT(a.norm(), 15) << t;
    const Eigen::Vector3d v = (walk.pose(t + d).translation() - walk.pose(t - d).translation()) / (2 * d);
    EXPECT_LT(v.norm(), 1.8) << t;
  }
}

TEST(Walk, keeps_its_speed_and_height) {
  const PlotWalk plot("demo");
  WalkParameters parameters;
  parameters.gait = 0;
  parameters.speed_m_s = 1.4;
  const Walk walk = plot.walk(parameters);
  std::vector<double> speeds;
  for (double t = 6; t < walk.duration_s() - 6; t += 0.25) {
    const Pose before = walk.pose(t - 0.05), here = walk.pose(t), after = walk.pose(t + 0.05);
    speeds.push_back((after.translation() - before.translation()).head<2>().norm() / 0.1);
    EXPECT_LT(speeds.back(), 1.5) << t;
    EXPECT_GT(speeds.back(), 0.5) << t;  // sharp turns are taken slowly
    EXPECT_LT(so3_log(Eigen::Quaterniond(before.linear().transpose() * after.linear())).norm() / 0.1, 3.0) << t;
    const Eigen::Vector3d p = here.translation();
    EXPECT_NEAR(p.z() - plot.forest.terrain.height(p.x(), p.y()), parameters.sensor_height_m, 0.15);
    EXPECT_NEAR(here.linear()(2, 2), 1, 1e-9);  // a glide stays upright
  }
  std::ranges::sort(speeds);
  EXPECT_NEAR(speeds[speeds.size() / 2], 1.4, 0.05);
}

TEST(Walk, a_backpack_steps_without_a_wandering_hand) {
  const PlotWalk plot("demo");
  WalkParameters parameters;
  const Walk hand = plot.walk();
  parameters.carrier = Carrier::backpack;
  const Walk back = plot.walk(parameters);
  const auto tilt = [](const Walk& walk) {
    double squares = 0;
    for (double t = 5; t < 40; t += 0.02) squares += std::pow(std::acos(std::min(1.0, walk.pose(t).linear()(2, 2))), 2);
    return std::sqrt(squares / 1750);
  };
  EXPECT_LT(tilt(back), 0.9 * tilt(hand));
  EXPECT_GT(tilt(back), 0.01);
  EXPECT_NEAR((back.pose(20).translation() - hand.pose(20).translation()).norm(), 0, 0.05);
}

TEST(Walk, the_sensor_may_be_mounted_upside_down) {
  const PlotWalk plot("demo");
  WalkParameters parameters;
  parameters.mount_tilt_rad = std::numbers::pi;
  for (const Carrier carrier : {Carrier::person, Carrier::robot}) {
    parameters.carrier = carrier;
    const Walk walk = plot.walk(parameters);
    EXPECT_LT(walk.pose(10).linear()(2, 2), -0.9);
    const Eigen::Vector3d p = walk.pose(10).translation();
    EXPECT_NEAR(p.z() - plot.forest.terrain.height(p.x(), p.y()), parameters.sensor_height_m, 0.2);
  }
}

TEST(Walk, gait_bobs_and_tilts) {
  const PlotWalk plot("demo");
  const Walk walk = plot.walk();
  double max_tilt = 0;
  for (double t = 5; t < 20; t += 0.02)
    max_tilt = std::max(max_tilt, std::acos(std::min(1.0, walk.pose(t).linear()(2, 2))));
  EXPECT_GT(max_tilt, 0.02);
  EXPECT_LT(max_tilt, 0.15);
}

TEST(Walk, trajectory_samples_the_pose_function) {
  const PlotWalk plot("demo");
  const Walk walk = plot.walk();
  const Trajectory trajectory = walk.trajectory(100, 1000);
  EXPECT_GE(trajectory.poses.back().time_s, 1000 + walk.duration_s());
  EXPECT_LT((trajectory.at(1012.3456).translation() - walk.pose(12.3456).translation()).norm(), 1e-4);
}

}  // namespace
}  // namespace bole::sim
