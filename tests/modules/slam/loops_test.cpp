// What stands between a candidate and a loop: where it lies on the earlier stretch, whether it agrees with the rest,
// and what the local map leaves to loops.
#include "slam/core/loops/loops.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

#include "slam/core/loops/context_index.h"
#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/place_guess.h"
#include "slam/core/loops/pose_graph.h"

namespace bole::slam {
namespace {

Pose pose_at(double x, double y, double heading_rad = 0) {
  Pose T = Pose::Identity();
  T.linear() = Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(x, y, 0);
  return T;
}

// Posts at random places, on whose height the seed decides too.
std::vector<Eigen::Vector3d> low_posts(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-20, 20), top(0.5, 3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 60; ++i) {
    const double x = at(random), y = at(random), height = top(random);
    for (double z = -1; z < height; z += 0.2) points.emplace_back(x, y, z);
  }
  return points;
}

Keyframe seen_from(const std::vector<Eigen::Vector3d>& world, const Pose& T_world_sensor, const Pose& T_map_keyframe,
                   double travelled) {
  Keyframe k;
  k.T_map_keyframe = T_map_keyframe;
  k.travelled = travelled;
  k.time_s = travelled;
  for (const auto& p : world) k.edges.push_back((T_world_sensor.inverse() * p).cast<float>());
  return k;
}

TEST(PlaceGuess, AWrongGuessIsPutRightToAThirdOfAMetre) {
  const auto world = low_posts(3);
  std::vector<Keyframe> keyframes;
  for (int i = 0; i < 5; ++i) keyframes.push_back(seen_from(world, pose_at(i, 0), pose_at(i, 0), i));
  // Driven the other way, 20 m later; the guess is 2 m short along the way, 0.5 m aside and turned by 4 deg.
  const Pose truth = pose_at(2, 0.4, std::numbers::pi), guess = pose_at(4, -0.1, std::numbers::pi + 0.07);
  const auto back = seen_from(world, truth, guess, 25);
  const auto placed = place_on_stretch(keyframes, 0, 4, back, guess);
  EXPECT_LT((placed.T_map_keyframe.translation() - truth.translation()).norm(), 0.45);
  EXPECT_LT(Eigen::AngleAxisd(placed.T_map_keyframe.linear().transpose() * truth.linear()).angle(), 0.04);
  EXPECT_GT(placed.score, 0.25);  // posts without thickness often fall beside the cell that they have taken
  // Another place never fits as well.
  const auto elsewhere = seen_from(low_posts(4), truth, guess, 25);
  EXPECT_LT(place_on_stretch(keyframes, 0, 4, elsewhere, guess).score, 0.6 * placed.score);
}

TEST(PlaceGuess, NothingSeenLeavesTheGuess) {
  std::vector<Keyframe> keyframes{seen_from({}, pose_at(0, 0), pose_at(0, 0), 0)};
  const auto placed = place_on_stretch(keyframes, 0, 0, keyframes.front(), pose_at(1, 2, 0.3));
  EXPECT_EQ(placed.score, 0);
  EXPECT_LT((placed.T_map_keyframe.translation() - Eigen::Vector3d(1, 2, 0)).norm(), 5);
}

TEST(PoseGraph, ALoopThatContradictsTheRestIsRefused) {
  // Out and back over 30 m with a drift of 0.3 m; three loops say where the way back is, one that it is a lane beside.
  std::vector<Keyframe> keyframes;
  std::vector<Pose> truth;
  for (int i = 0; i <= 60; ++i) {
    const double x = i <= 30 ? i : 60 - i;
    truth.push_back(pose_at(x, i <= 30 ? 0 : 0.5));
    keyframes.push_back(seen_from({}, truth.back(), pose_at(x, (i <= 30 ? 0 : 0.5) + 0.005 * i), i));
  }
  std::vector<Loop> loops;
  for (const std::size_t to : {50u, 55u, 60u}) {
    Loop l;
    l.from = 60 - to;
    l.to = to;
    l.T_from_to = truth[l.from].inverse() * truth[to];
    loops.push_back(l);
  }
  auto wrong = loops.front();
  wrong.from = 15;
  wrong.to = 45;
  wrong.T_from_to = pose_at(0, 0.5 - 2.75);
  loops.push_back(wrong);
  const auto graph = optimise_pose_graph(keyframes, loops, {});
  EXPECT_EQ(graph.refused, (std::vector<std::uint8_t>{0, 0, 0, 1}));
  EXPECT_EQ(kept_loops(loops, graph).size(), 3u);
  EXPECT_LT((graph.T_map_keyframe.back().translation() - truth.back().translation()).norm(), 0.05);
  // Without the wrong one the outcome is the same.
  loops.pop_back();
  const auto without = optimise_pose_graph(keyframes, loops, {});
  EXPECT_LT((without.T_map_keyframe[45].translation() - graph.T_map_keyframe[45].translation()).norm(), 1e-9);
}

TEST(PoseGraph, WithoutASolutionTheKeyFramesStayAndItIsTold) {
  std::vector<Keyframe> keyframes;
  for (int i = 0; i <= 10; ++i) keyframes.push_back(seen_from({}, pose_at(i, 0), pose_at(i, 0), i));
  Loop l;
  l.from = 0;
  l.to = 10;
  l.T_from_to = pose_at(std::numeric_limits<double>::quiet_NaN(), 0);
  const auto graph = optimise_pose_graph(keyframes, {l}, {});
  EXPECT_FALSE(graph.solved);
  ASSERT_EQ(graph.warnings.size(), 1u);
  EXPECT_NE(graph.warnings[0].find("the loop closures could not be adjusted and none is used"), std::string::npos);
  EXPECT_TRUE(kept_loops({l}, graph).empty());
  ASSERT_EQ(graph.T_map_keyframe.size(), keyframes.size());
  for (std::size_t k = 0; k < keyframes.size(); ++k)
    EXPECT_TRUE(graph.T_map_keyframe[k].isApprox(keyframes[k].T_map_keyframe));
}

TEST(PoseGraph, ManyLoopsThatAgreePrevailOverAnOdometryThatSlipped) {
  // Out and back over 40 m; on the way back the odometry slips by a tenth and drifts aside: 4 m at the end.
  std::vector<Keyframe> keyframes;
  std::vector<Pose> truth;
  for (int i = 0; i <= 160; ++i) {
    const double x = i <= 80 ? 0.5 * i : 80 - 0.5 * i, back = std::max(0, i - 80);
    truth.push_back(pose_at(x, i <= 80 ? 0 : 0.5));
    keyframes.push_back(
        seen_from({}, truth.back(), pose_at(x + 0.05 * back, truth.back().translation().y() + 0.01 * back), 0.5 * i));
  }
  std::vector<Loop> loops;
  const auto add = [&](std::size_t from, std::size_t to, const Pose& error) {
    Loop l;
    l.from = from;
    l.to = to;
    l.T_from_to = truth[from].inverse() * truth[to] * error;
    loops.push_back(l);
  };
  for (std::size_t to = 100; to <= 160; to += 4) add(160 - to, to, Pose::Identity());
  add(20, 140, pose_at(0, 2.75));
  add(50, 110, pose_at(-3, 0));
  const auto graph = optimise_pose_graph(keyframes, loops, {});
  std::vector<std::uint8_t> expected(loops.size(), 0);
  expected[expected.size() - 2] = expected.back() = 1;
  EXPECT_EQ(graph.refused, expected);
  EXPECT_LT((graph.T_map_keyframe.back().translation() - truth.back().translation()).norm(), 0.05);
  // Out and back share the slip, but lie on one another.
  const Pose T_from_to = graph.T_map_keyframe[40].inverse() * graph.T_map_keyframe[120];
  EXPECT_LT((T_from_to.translation() - (truth[40].inverse() * truth[120]).translation()).norm(), 0.05);
}

// Keyframes along an alley of posts at x0 and back, 0.5 m apart; `at` puts a true pose where the odometry has it.
template <class At>
void walk_alley(const std::vector<Eigen::Vector3d>& world, bool back, double& travelled, const At& at,
                std::vector<Keyframe>& keyframes, std::vector<Pose>& truth) {
  for (int i = 0; i <= 60; ++i) {
    const Pose T = back ? pose_at(15 - 0.5 * i, 0.3, std::numbers::pi) : pose_at(0.5 * i - 15, 0);
    keyframes.push_back(seen_from(world, T, at(T), travelled += 0.5));
    keyframes.back().context = make_scan_context(keyframes.back().edges, context_shape(resolved({})));
    truth.push_back(T);
  }
}

TEST(LoopCandidates, AlongTheWayAPlaceIsFoundAmongPlacesThatLookTheSame) {
  // The same posts twice, 300 m apart: by look alone either may be meant. Then back through the second with a slip of
  // 4 m and 6 deg.
  const auto world = low_posts(7);
  std::vector<Keyframe> keyframes;
  std::vector<Pose> truth;
  double travelled = 0;
  const Pose decoy = pose_at(0, 300), slip = pose_at(4, 0.5, 0.1);
  walk_alley(
      world, false, travelled, [&](const Pose& T) { return decoy * T; }, keyframes, truth);
  travelled += 300;
  walk_alley(
      world, false, travelled, [](const Pose& T) { return T; }, keyframes, truth);
  const std::size_t begin_back = keyframes.size();
  walk_alley(
      world, true, travelled, [&](const Pose& T) { return slip * T; }, keyframes, truth);

  SlamOptions options;
  options.preset = Preset::orchard;
  const auto settings = resolved(options);
  ASSERT_EQ(settings.context_search, ContextSearchKind::sequence);
  const auto candidates = find_loop_candidates(keyframes, settings, {});
  EXPECT_GE(candidates.size(), 10u);
  int right = 0;
  for (const auto& c : candidates) {
    EXPECT_GE(c.from, 61u) << "the decoy is too far off";
    EXPECT_GE(c.to, begin_back);
    const Pose guess = keyframes[c.from].T_map_keyframe.inverse() * c.T_map_to,
               T_from_to = truth[c.from].inverse() * truth[c.to];
    right += (guess.translation() - T_from_to.translation()).norm() < 0.6;
  }
  EXPECT_GE(right, static_cast<int>(0.9 * static_cast<double>(candidates.size())));
}

TEST(LocalMap, OfTheLastKeyFramesForgetsAPlace) {
  const auto world = low_posts(5);
  std::vector<Keyframe> keyframes;
  LocalMap nearest(0.1, 4), last(0.1, 4, LocalMapKind::last);
  const auto knows = [&](const LocalMap& map) { return map.maps().edges.surface(world.front(), 1, 1).has_value(); };
  for (int i = 0; i < 12; ++i) {
    // Only the first four keyframes see anything; the path comes back to them at the end.
    const Pose T = pose_at(i < 6 ? i : 11 - i, 0);
    keyframes.push_back(seen_from(i < 4 ? world : std::vector<Eigen::Vector3d>{}, T, T, i));
    nearest.update(keyframes, T.translation());
    last.update(keyframes, T.translation());
    EXPECT_TRUE(i != 3 || (knows(nearest) && knows(last)));
  }
  EXPECT_TRUE(knows(nearest));
  EXPECT_FALSE(knows(last));
}

}  // namespace
}  // namespace bole::slam
