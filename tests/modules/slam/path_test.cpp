#include "slam/core/map/path.h"

#include <gtest/gtest.h>

#include <fstream>

#include "slam/core/map/passes.h"
#include "slam/core/map/tum_poses.h"
#include "synthetic/scan_world.h"

namespace bole::slam {
namespace {

Path sampled_walk(double spacing_s, double duration_s = 4) {
  std::vector<StampedPose> nodes;
  for (double t = 0; t <= duration_s + 1e-9; t += spacing_s) nodes.push_back({t, synthetic::walk_on_circle(t, 6, 1)});
  return Path(nodes);
}

TEST(Path, FollowsAGaitBetterThanStraightPieces) {
  const Path path = sampled_walk(0.1);
  Trajectory straight;
  straight.poses = path.nodes();
  double cubic = 0, linear = 0;
  for (double t = 0.5; t < 3.5; t += 0.013) {
    const Pose truth = synthetic::walk_on_circle(t, 6, 1);
    cubic = std::max(cubic, (path.at(t).translation() - truth.translation()).norm());
    linear = std::max(linear, (straight.at(t).translation() - truth.translation()).norm());
  }
  EXPECT_LT(cubic, 0.0015);
  EXPECT_GT(linear, 2.5 * cubic);
}

TEST(Path, MeetsItsNodesAndGoesOnBeyondTheEnds) {
  const Path path = sampled_walk(0.25);
  for (const auto& n : path.nodes()) EXPECT_LT((path.at(n.time_s).matrix() - n.T_target_sensor.matrix()).norm(), 1e-9);
  const auto& nodes = path.nodes();
  const Eigen::Vector3d step =
      nodes.back().T_target_sensor.translation() - nodes[nodes.size() - 2].T_target_sensor.translation();
  EXPECT_LT((path.at(path.end_s() + 0.25).translation() - nodes.back().T_target_sensor.translation() - step).norm(),
            1e-9);
}

TEST(Path, InfluenceIsTheDerivativeByTheNodes) {
  std::vector<StampedPose> nodes;
  for (const double t : {0.0, 0.1, 0.22, 0.3, 0.5, 0.61}) nodes.push_back({t, synthetic::walk_on_circle(t + 1, 6, 1)});
  Path path(nodes);
  for (const double t : {0.03, 0.15, 0.27, 0.4, 0.6}) {
    const auto influence = path.influence(t);
    double sum = 0;
    for (std::ptrdiff_t k = 0; k < 4; ++k) {
      const auto node = influence.first + k;
      const double weight = influence.weight[static_cast<std::size_t>(k)];
      sum += weight;
      if (node < 0 || node >= static_cast<std::ptrdiff_t>(nodes.size())) {
        EXPECT_EQ(weight, 0);
        continue;
      }
      const auto n = static_cast<std::size_t>(node);
      Pose moved = nodes[n].T_target_sensor;
      moved.translation().x() += 1;
      const double before = path.at(t).translation().x();
      path.set_pose(n, moved);
      path.update_velocities();
      EXPECT_NEAR(path.at(t).translation().x() - before, weight, 1e-9);
      path.set_pose(n, nodes[n].T_target_sensor);
      path.update_velocities();
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Path, NeedsRisingTimes) {
  const Pose T = Pose::Identity();
  EXPECT_THROW(Path({{0, T}}), Error);
  EXPECT_THROW(Path({{0, T}, {0, T}}), Error);
}

TEST(Passes, ANewOneBeginsWhereTheWalkComesBack) {
  // Once round a circle of 38 m: the walk is back after 30 m or so, and only then.
  std::vector<StampedPose> nodes;
  for (double t = 0; t < 60; t += 0.1) nodes.push_back({t, synthetic::walk_on_circle(t, 6, 1, 0, 0)});
  const auto marks = mark_path(Path(nodes), {}, 0.5, 4);
  EXPECT_EQ(mark_at(marks, 20).pass, 0);
  EXPECT_EQ(mark_at(marks, 40).pass, 1);
  EXPECT_EQ(mark_at(marks, -5).pass, 0);
  for (std::size_t i = 1; i < marks.size(); ++i) EXPECT_GE(marks[i].pass, marks[i - 1].pass);
  // Going straight on never comes back.
  for (auto& n : nodes) n.T_target_sensor.translation() = Eigen::Vector3d(n.time_s, 0, 0);
  EXPECT_EQ(mark_path(Path(nodes), {}, 0.5, 4).back().pass, 0);
}

TEST(TumPoses, AreReadAndBadLinesNamed) {
  const auto file = std::filesystem::path(testing::TempDir()) / "poses.tum";
  const auto write = [&](const char* text) { std::ofstream(file) << text; };
  write("# time x y z qx qy qz qw\n\n1.5 1 2 3 0 0 0 1\n1.6 1 2 4 0 0 0.7071068 0.7071068\n");
  const auto poses = read_tum_poses(file);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_NEAR((poses[1].T_target_sensor.linear() * Eigen::Vector3d::UnitX()).y(), 1, 1e-6);
  const auto error_of = [&](const char* text) -> std::string {
    write(text);
    try {
      read_tum_poses(file);
    } catch (const Error& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_NE(error_of("1 0 0 0 0 0 0 1\n2 0 0 zero 0 0 0 1\n").find(":2"), std::string::npos);
  EXPECT_NE(error_of("1 0 0 0 0 0 0 1\n2 0 0 nan 0 0 0 1\n").find("eight numbers"), std::string::npos);
  EXPECT_NE(error_of("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n").find("Sort"), std::string::npos);
  EXPECT_NE(error_of("1 0 0 0 0 0 0 0\n").find("quaternion"), std::string::npos);
  EXPECT_NE(error_of("1 0 0 0 0 0 0 1\n").find("at least 2"), std::string::npos);
}

}  // namespace
}  // namespace bole::slam
