#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "base/random.h"
#include "rgbd/core/matching/gms.h"
#include "rgbd/core/matching/ray_motion.h"
#include "rgbd/core/matching/rigid_motion.h"
#include "rgbd/core/matching/view_graph.h"
#include "synthetic/view_scene.h"

namespace bole::rgbd {
namespace {

constexpr double focal = 600;

Pose some_motion() {
  Pose T = Pose::Identity();
  T.linear() = so3_exp({0.1, -0.2, 0.05}).toRotationMatrix();
  T.translation() = Eigen::Vector3d(0.08, -0.03, 0.02);
  return T;
}

struct Sample {
  std::vector<RayMatch> matches;
  std::vector<char> right;
};

// Points in a box half a metre away, seen by both cameras with noise; a share of the matches is wrong.
Sample sample(const Pose& T_b_a, int count, double wrong, double pixel_noise, double depth_noise) {
  Sample out;
  Random random(3, 7);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p(random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15), random.uniform(0.4, 0.7));
    Eigen::Vector3d q = T_b_a * p;
    const bool bad = random.chance(wrong);
    if (bad) q = {random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15), random.uniform(0.4, 0.7)};
    const auto noisy = [&](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(x.x() / x.z() + random.normal(0, pixel_noise) / focal,
                             x.y() / x.z() + random.normal(0, pixel_noise) / focal, 1);
    };
    out.matches.push_back(
        {noisy(p), noisy(q), 1 / p.z() + random.normal(0, depth_noise), 1 / q.z() + random.normal(0, depth_noise)});
    out.right.push_back(bad ? 0 : 1);
  }
  return out;
}

MotionOptions options_of(double depth_noise) {
  MotionOptions o;
  o.max_error = 4 / focal;
  o.sigma = 1 / focal;
  o.inverse_depth_sigma = depth_noise;
  return o;
}

double turn_between(const Pose& a, const Pose& b) {
  return so3_log(Eigen::Quaterniond(a.linear().transpose() * b.linear())).norm();
}

TEST(RigidMotion, ExactMatchesGiveTheExactMotion) {
  const auto s = sample(some_motion(), 60, 0, 0, 0);
  const auto found = find_motion(s.matches, options_of(0.01));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inliers, 60);
  EXPECT_TRUE(found->T_b_a.isApprox(some_motion(), 1e-9));
}

TEST(RigidMotion, HalfOfTheMatchesMayBeWrong) {
  const auto s = sample(some_motion(), 300, 0.5, 0.5, 0.005);
  const auto found = find_motion(s.matches, options_of(0.005));
  ASSERT_TRUE(found);
  // 150 matches with 0.5 px at 600 px and half a metre: about 0.05 mm and 0.1 mrad from pixels alone.
  EXPECT_LT((found->T_b_a.translation() - some_motion().translation()).norm(), 0.8e-3);
  EXPECT_LT(turn_between(found->T_b_a, some_motion()), 1.5e-3);
  int kept_wrong = 0, lost_right = 0, right = 0;
  for (std::size_t i = 0; i < s.right.size(); ++i) {
    kept_wrong += !s.right[i] && found->inlier[i];
    lost_right += s.right[i] && !found->inlier[i];
    right += s.right[i];
  }
  EXPECT_LE(kept_wrong, 2);
  EXPECT_LE(lost_right, right / 20);
}

TEST(RigidMotion, DepthOnOneSideIsEnough) {
  for (const bool in_a : {true, false}) {
    auto s = sample(some_motion(), 200, 0.3, 0.3, 0.002);
    for (auto& m : s.matches) (in_a ? m.inverse_depth_b : m.inverse_depth_a) = 0;
    const auto found = find_motion(s.matches, options_of(0.002));
    ASSERT_TRUE(found);
    EXPECT_LT((found->T_b_a.translation() - some_motion().translation()).norm(), 1e-3);
  }
}

TEST(RigidMotion, NothingIsFoundAmongRandomMatches) {
  const auto s = sample(some_motion(), 200, 1, 0, 0);
  EXPECT_FALSE(find_motion(s.matches, options_of(0.005)));
  EXPECT_FALSE(find_motion({}, options_of(0.005)));
  EXPECT_FALSE(find_motion_of_rays({}, options_of(0.005)));
}

// Points on a patch 30 mm wide with depths of 2 mm noise: their place is known, their turn to about 0.05 rad.
TEST(RigidMotion, MatchesInOneSpotLeaveTheTurnOpen) {
  constexpr double depth_noise = 0.008;
  Random random(5, 1);
  std::vector<RayMatch> spot;
  for (int i = 0; i < 14; ++i) {
    const Eigen::Vector3d p(random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015), 0.5);
    const Eigen::Vector3d q = some_motion() * p;
    spot.push_back({p / p.z(), q / q.z(), 1 / p.z(), 1 / q.z()});
  }
  auto options = options_of(depth_noise);
  options.min_inliers = 8;
  EXPECT_FALSE(find_motion(spot, options));
  options.inverse_depth_sigma = 0.0001;  // the same points, known to 0.025 mm
  options.sigma = 0.05 / focal;
  EXPECT_TRUE(find_motion(spot, options));
}

TEST(RayMotion, RaysGiveTurnAndDirection) {
  auto s = sample(some_motion(), 300, 0.3, 0.3, 0);
  for (auto& m : s.matches) m.inverse_depth_a = m.inverse_depth_b = 0;
  const auto found = find_motion_of_rays(s.matches, options_of(0));
  ASSERT_TRUE(found);
  EXPECT_LT(turn_between(found->T_b_a, some_motion()), 0.02);
  EXPECT_GT(found->T_b_a.translation().normalized().dot(some_motion().translation().normalized()), 0.99);
}

TEST(RayMotion, AViewIsFoundByPointsThatItSees) {
  const auto s = sample(some_motion(), 200, 0.4, 0.3, 0);
  std::vector<PointRay> sights;
  for (const auto& m : s.matches) sights.push_back({m.ray_a / m.inverse_depth_a, m.ray_b});
  const auto found = find_view(sights, options_of(0));
  ASSERT_TRUE(found);
  EXPECT_LT((found->T_world_camera.inverse().translation() - some_motion().translation()).norm(), 0.5e-3);
}

TEST(Gms, KeepsWhatMovesTogether) {
  Random random(1, 2);
  const Eigen::Rotation2Dd turn(0.5);
  std::vector<PixelPair> pairs;
  std::vector<char> right;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector2d a(random.uniform(100, 540), random.uniform(100, 380));
    const bool good = i % 2 == 0;
    const Eigen::Vector2d b = good ? Eigen::Vector2d(turn * (a - Eigen::Vector2d(320, 240)) + Eigen::Vector2d(330, 250))
                                   : Eigen::Vector2d(random.uniform(0, 640), random.uniform(0, 480));
    pairs.push_back({a, b});
    right.push_back(good ? 1 : 0);
  }
  const auto kept = supported_by_neighbours(pairs, {640, 480}, {640, 480});
  int kept_right = 0, kept_wrong = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) (right[i] ? kept_right : kept_wrong) += kept[i];
  EXPECT_GT(kept_right, 270);
  EXPECT_LT(kept_wrong, 60);
  EXPECT_TRUE(supported_by_neighbours({}, {640, 480}, {640, 480}).empty());
}

TEST(ViewGraph, SpansTheLargestPartAlongTheStrongestEdges) {
  const auto poses = synthetic::orbit(6, 0.4, 0.3, 0);
  const auto edge = [&](int a, int b, double weight) {
    return GraphEdge{a, b, poses[static_cast<std::size_t>(b)].inverse() * poses[static_cast<std::size_t>(a)], weight};
  };
  std::vector<GraphEdge> edges{edge(0, 1, 10), edge(1, 2, 10), edge(2, 3, 10), edge(0, 3, 10), edge(4, 5, 99)};
  edges.push_back({0, 2, Pose::Identity(), 5});  // wrong and weak
  const auto spanned = span_poses(6, edges, 1);
  EXPECT_EQ(spanned.root, 1);
  EXPECT_EQ(spanned.nodes, 4);
  EXPECT_FALSE(spanned.T_root_node[4]);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(spanned.T_root_node[i]->isApprox(poses[1].inverse() * poses[i], 1e-9)) << i;
  EXPECT_EQ(span_poses(6, edges, 5).root, 0);  // outside of the largest part
  EXPECT_EQ(span_poses(0, {}, 0).nodes, 0);
}

TEST(ViewGraph, AnEdgeThatTrianglesContradictIsNamed) {
  const auto poses = synthetic::orbit(5, 0.4, 0.3, 0);
  std::vector<GraphEdge> edges;
  for (int a = 0; a < 5; ++a)
    for (int b = a + 1; b < 5; ++b)
      edges.push_back({a, b, poses[static_cast<std::size_t>(b)].inverse() * poses[static_cast<std::size_t>(a)], 1});
  edges[3].T_b_a = some_motion();
  const auto wrong = contradicted(5, edges, 0.05, 0.02);
  for (std::size_t i = 0; i < wrong.size(); ++i) EXPECT_EQ(wrong[i] != 0, i == 3) << i;
}

}  // namespace
}  // namespace bole::rgbd
