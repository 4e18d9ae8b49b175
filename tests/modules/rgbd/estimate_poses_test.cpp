#include "rgbd/core/poses/estimate_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/verdict.h"
#include "synthetic/board_print.h"
#include "synthetic/trajectory_error.h"
#include "synthetic/view_scene.h"

namespace bole::rgbd {
namespace {

using synthetic::SceneViews;
using ::testing::HasSubstr;

// The lower left corner of the print is moved off the origin of the scene, so that axes cannot agree by chance.
const Eigen::Vector2d board_corner(-0.13, -0.11);

synthetic::ViewScene scene_with_board(bool from_upper_row = true, bool black = true) {
  auto scene = synthetic::box_scene();
  auto facts = synthetic::small_board();
  facts.first_square_black = black;
  scene.print = synthetic::board_print(facts, board_corner, from_upper_row);
  return scene;
}

Pose T_board_scene() {
  Pose T = Pose::Identity();
  T.translation() = Eigen::Vector3d(-board_corner.x(), -board_corner.y(), 0);
  return T;
}

std::vector<Pose> in_board_axes(const std::vector<Pose>& truth) {
  std::vector<Pose> out;
  for (const auto& T : truth) out.push_back(T_board_scene() * T);
  return out;
}

synthetic::SceneCamera camera_with_noise() {
  auto camera = synthetic::plain_camera();
  camera.depth_noise = 0.004;
  camera.image_noise = 2;
  return camera;
}

PoseOptions quick() {
  PoseOptions o;
  o.max_features = 800;
  o.neighbours = 3;
  return o;
}

EstimatedPoses estimate(const ViewSource& views, const PoseOptions& options = quick()) {
  return estimate_poses(views, nullptr, options, bole::Run{});
}

TEST(EstimatePoses, BoardGivesAxesAndScale) {
  SceneViews views(scene_with_board(), camera_with_noise(), synthetic::orbit(12, 0.42, 0.3, 0.04));
  views.board_facts = synthetic::small_board();
  const auto found = estimate(views);
  const auto pairs = synthetic::pose_pairs(found.poses, in_board_axes(views.truth()), views);
  ASSERT_EQ(pairs.found.size(), 12U);
  EXPECT_EQ(found.report.facts.at("world_axes"), "board");
  EXPECT_EQ(found.report.facts.at("scale_source"), "board");
  const double absolute = synthetic::place_rms(pairs.found, pairs.truth);
  RecordProperty("absolute_um", static_cast<int>(1e6 * absolute));
  std::printf("absolute %.4f mm, ate %.4f mm, residual %.3f px\n", 1e3 * absolute, 1e3 * synthetic::ate(pairs),
              found.report.metrics.at("residual_px").value);
  EXPECT_LT(absolute, 0.3e-3);
  // What is said of the errors is what they are, within a factor of three.
  double sum = 0;
  for (const double sd : found.tracking.numbers("place_sd_mm")) sum += sd * sd / 12;
  EXPECT_GT(std::sqrt(sum), absolute * 1e3 / 3);
  EXPECT_LT(std::sqrt(sum), absolute * 1e3 * 3);
}

TEST(EstimatePoses, DepthGivesTheScaleWithoutABoard) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(12, 0.42, 0.3, 0.04));
  const auto found = estimate(views);
  const auto pairs = synthetic::pose_pairs(found.poses, views.truth(), views);
  ASSERT_EQ(pairs.found.size(), 12U);
  EXPECT_EQ(found.report.facts.at("world_axes"), "first_view");
  EXPECT_EQ(found.report.facts.at("scale_source"), "depth");
  double scale = 0;
  const double error = synthetic::ate(pairs, &scale);
  std::printf("ate %.4f mm, scale %.5f\n", 1e3 * error, scale);
  EXPECT_LT(error, 0.6e-3);
  EXPECT_NEAR(scale, 1, 0.002);
}

TEST(EstimatePoses, WrongDepthScaleIsNamedAndTheBoardDecides) {
  auto camera = camera_with_noise();
  camera.depth_factor = 1.05;
  SceneViews views(scene_with_board(), camera, synthetic::orbit(10, 0.42, 0.3, 0.04, 1.5));
  views.board_facts = synthetic::small_board();
  const auto found = estimate(views);
  EXPECT_TRUE(has_finding(found.report, "depth_scale"));
  EXPECT_NEAR(found.report.metrics.at("depth_scale").value, 1.05, 0.01);
  const auto pairs = synthetic::pose_pairs(found.poses, in_board_axes(views.truth()), views);
  EXPECT_LT(synthetic::place_rms(pairs.found, pairs.truth), 0.5e-3);
}

TEST(EstimatePoses, DepthInAnotherUnitThanTheBoardIsRefused) {
  auto camera = camera_with_noise();
  camera.depth_factor = 1000;
  SceneViews views(scene_with_board(), camera, synthetic::orbit(6, 0.42, 0.3, 0.04, 1));
  views.board_facts = synthetic::small_board();
  EXPECT_THROW(
      {
        try {
          estimate(views);
        } catch (const Error& e) {
          EXPECT_THAT(e.what(), testing::HasSubstr("times what the board says"));
          throw;
        }
      },
      Error);
}

TEST(EstimatePoses, BoardAloneIsEnough) {
  auto camera = camera_with_noise();
  camera.with_depth = false;
  SceneViews views(scene_with_board(), camera, synthetic::orbit(8, 0.42, 0.4, 0.02, 0.6));
  views.board_facts = synthetic::small_board();
  const auto found = estimate(views);
  const auto pairs = synthetic::pose_pairs(found.poses, in_board_axes(views.truth()), views);
  ASSERT_EQ(pairs.found.size(), 8U);
  EXPECT_LT(synthetic::place_rms(pairs.found, pairs.truth), 0.5e-3);
}

TEST(EstimatePoses, LostViewsAreNamedAndTheRestIsKept) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(8, 0.42, 0.3, 0.04, 1));
  views.black = {3, 7};
  const auto found = estimate(views);
  ASSERT_TRUE(has_finding(found.report, "tracking_lost"));
  EXPECT_THAT(found.report.findings.back().text, HasSubstr("3 (000003), 7 (000007)"));
  EXPECT_EQ(found.poses.poses.size(), 6U);
  EXPECT_EQ(found.tracking.texts("state")[3], "lost");
  EXPECT_EQ(found.tracking.texts("state")[4], "tracked");
  EXPECT_LT(synthetic::ate(synthetic::pose_pairs(found.poses, views.truth(), views)), 0.6e-3);
}

TEST(EstimatePoses, ViewsWithoutDepthAreTrackedByTheOthers) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(8, 0.42, 0.3, 0.04, 1));
  views.no_depth = {2, 5};
  const auto found = estimate(views);
  EXPECT_EQ(found.poses.poses.size(), 8U);
  EXPECT_LT(synthetic::ate(synthetic::pose_pairs(found.poses, views.truth(), views)), 0.6e-3);
}

TEST(EstimatePoses, GivenPosesOfAnotherScaleThanTheBoardAreTold) {
  auto camera = camera_with_noise();
  camera.with_depth = false;
  SceneViews views(scene_with_board(), camera, synthetic::orbit(5, 0.42, 0.4, 0.02, 0.8));
  views.board_facts = synthetic::small_board();
  auto large = views.truth();
  for (auto& T : large) T.translation() *= 1.1;
  for (std::size_t i = 0; i < large.size(); ++i) views.given.poses.push_back({views.time_s(i), large[i]});
  auto options = quick();
  options.source = PoseSource::given;
  const auto found = estimate(views, options);
  ASSERT_TRUE(has_finding(found.report, "given_scale"));
  EXPECT_NEAR(found.report.metrics.at("given_to_board").value, 1.1, 0.01);
}

TEST(EstimatePoses, LensAndDepthCameraOfTheirOwn) {
  auto camera = camera_with_noise();
  camera.camera.color.distortion = {0.12, -0.25, 0.001, -0.002, 0.08};
  camera.camera.depth = synthetic::plain_camera(424, 320, 330).camera.color;
  camera.camera.T_color_depth.translation() = Eigen::Vector3d(-0.03, 0.002, 0.004);
  camera.camera.T_color_depth.linear() = so3_exp({0.01, 0.02, -0.01}).toRotationMatrix();
  SceneViews views(synthetic::box_scene(), camera, synthetic::orbit(8, 0.42, 0.3, 0.04, 1));
  const auto found = estimate(views);
  const auto pairs = synthetic::pose_pairs(found.poses, views.truth(), views);
  ASSERT_EQ(pairs.found.size(), 8U);
  double scale = 0;
  const double error = synthetic::ate(pairs, &scale);
  EXPECT_LT(error, 0.6e-3);
  EXPECT_NEAR(scale, 1, 0.005);
}

TEST(EstimatePoses, RaysAloneGiveTheShapeOfTheWay) {
  auto camera = camera_with_noise();
  camera.with_depth = false;
  SceneViews views(synthetic::box_scene(), camera, synthetic::orbit(10, 0.42, 0.3, 0.04, 1.2));
  auto options = quick();
  options.allow_unscaled = true;
  const auto found = estimate(views, options);
  EXPECT_EQ(found.report.facts.at("scale_source"), "none");
  EXPECT_TRUE(has_finding(found.report, "no_scale"));
  auto pairs = synthetic::pose_pairs(found.poses, views.truth(), views);
  ASSERT_EQ(pairs.found.size(), 10U);
  double scale = 0;
  synthetic::ate(pairs, &scale);
  for (auto& T : pairs.found) T.translation() *= scale;
  EXPECT_LT(synthetic::ate(pairs), 0.6e-3);
}

TEST(EstimatePoses, StillBackgroundOfATurntableIsLeftOut) {
  auto scene = synthetic::box_scene();
  scene.floor_half = 0.12;
  scene.wall = 0.85;
  SceneViews views(scene, camera_with_noise(), synthetic::orbit(8, 0.42, 0.3, 0.04, 0.8));
  const auto found = estimate(views);
  EXPECT_EQ(found.report.facts.at("turntable"), "yes");
  const auto pairs = synthetic::pose_pairs(found.poses, views.truth(), views);
  ASSERT_EQ(pairs.found.size(), 8U);
  EXPECT_LT(synthetic::ate(pairs), 1e-3);
}

TEST(EstimatePoses, TablesTellEveryView) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(4, 0.42, 0.3, 0.04, 0.3));
  const auto found = estimate(views);
  EXPECT_EQ(found.tracking.rows(), 4U);
  EXPECT_EQ(found.tracking.texts("name")[1], "000001");
  for (const double r : found.tracking.numbers("residual_px")) EXPECT_LT(r, 1.5);
  // 4 mm at 1 m are 1 mm at half a metre.
  for (const double r : found.tracking.numbers("residual_depth_mm")) EXPECT_LT(r, 1.5);
  ASSERT_GT(found.matches.rows(), 100U);
  const auto state = found.matches.texts("state"), reason = found.matches.texts("reason");
  for (std::size_t i = 0; i < state.size(); ++i) EXPECT_EQ(state[i] == "kept", reason[i] == "kept");
  ASSERT_GT(found.points.size(), 200U);
  EXPECT_TRUE(found.points.has(arrays::red));
  const auto again = estimate(views);
  for (std::size_t i = 0; i < found.poses.poses.size(); ++i)
    EXPECT_EQ(found.poses.poses[i].T_target_sensor.matrix(), again.poses.poses[i].T_target_sensor.matrix());
}

TEST(EstimatePoses, StopsWhenItIsCancelled) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(4, 0.42, 0.3, 0.04, 0.3));
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  run.progress = [&](double fraction, std::string_view) {
    if (fraction > 0.5) stop.request_stop();
  };
  try {
    estimate_poses(views, nullptr, quick(), run);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::cancelled);
  }
}

std::string error_of(const ViewSource& views, const PoseOptions& options = quick()) {
  try {
    estimate(views, options);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
  }
  return "no error";
}

TEST(EstimatePoses, UnusableViewsAreRefusedWithAReason) {
  const auto poses = synthetic::orbit(3, 0.42, 0.3, 0.04, 0.2);
  EXPECT_THAT(error_of(SceneViews(synthetic::box_scene(), camera_with_noise(), {})), HasSubstr("no views"));
  EXPECT_THAT(error_of(SceneViews(synthetic::box_scene(), camera_with_noise(), {poses[0]})), HasSubstr("one view"));
  SceneViews black(synthetic::box_scene(), camera_with_noise(), poses);
  black.black = {0, 1, 2};
  EXPECT_THAT(error_of(black), HasSubstr("no view has any feature"));
  auto camera = camera_with_noise();
  camera.with_depth = false;
  EXPECT_THAT(error_of(SceneViews(synthetic::box_scene(), camera, poses)), HasSubstr("no depth and no board"));
  SceneViews empty_depth(synthetic::box_scene(), camera_with_noise(), poses);
  empty_depth.no_depth = {0, 1, 2};
  EXPECT_THAT(error_of(empty_depth), HasSubstr("no feature of any view has depth"));
  auto apart = synthetic::box_scene();
  apart.floor_half = 3;
  const std::vector<Pose> elsewhere{synthetic::look_at({0.3, 0, 0.3}, {0, 0, 0}),
                                    synthetic::look_at({2.3, 1, 0.3}, {2, 1, 0}),
                                    synthetic::look_at({-2, 2, 0.3}, {-2, 1.7, 0})};
  EXPECT_THAT(error_of(SceneViews(apart, camera_with_noise(), elsewhere)), HasSubstr("no two of the views"));
}

Trajectory as_trajectory(const std::vector<Pose>& poses, const ViewSource& views) {
  Trajectory t;
  for (std::size_t i = 0; i < poses.size(); ++i) t.poses.push_back({views.time_s(i), poses[i]});
  return t;
}

TEST(EstimatePoses, GivenPosesAreHandedOnAndChecked) {
  SceneViews views(synthetic::box_scene(), camera_with_noise(), synthetic::orbit(6, 0.42, 0.3, 0.04, 0.6));
  PoseOptions options = quick();
  options.source = PoseSource::given;
  EXPECT_THAT(error_of(views, options), HasSubstr("came without poses"));

  views.given = as_trajectory(views.truth(), views);
  const auto good = estimate(views, options);
  EXPECT_TRUE(good.report.findings.empty());
  ASSERT_EQ(good.poses.poses.size(), 6U);
  EXPECT_TRUE(good.poses.poses[4].T_target_sensor.isApprox(views.truth()[4], 1e-12));
  EXPECT_EQ(good.report.facts.at("world_axes"), "given");
  EXPECT_LT(good.report.metrics.at("given_error_px").value, 1);

  auto inverse = views.truth();
  for (auto& T : inverse) T = T.inverse();
  views.given = as_trajectory(inverse, views);
  const auto wrong = estimate(views, options);
  ASSERT_TRUE(has_finding(wrong.report, "given_poses_disagree"));
  EXPECT_THAT(wrong.report.findings.back().text, HasSubstr("world to camera"));

  auto large = views.truth();
  for (auto& T : large) T.translation() *= 1000;
  views.given = as_trajectory(large, views);
  EXPECT_THAT(estimate(views, options).report.findings.back().text, HasSubstr("lengths times 0.001"));

  auto skewed = views.truth();
  skewed[2].linear() *= 1.1;
  views.given = as_trajectory(skewed, views);
  EXPECT_THAT(error_of(views, options), HasSubstr("view 2 (000002) is no rigid motion"));
}

}  // namespace
}  // namespace bole::rgbd
