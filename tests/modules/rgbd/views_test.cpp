#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/statistics.h"
#include "rgbd/core/board/charuco_board.h"
#include "rgbd/core/features/depth_lookup.h"
#include "rgbd/core/features/extract_features.h"
#include "synthetic/board_print.h"
#include "synthetic/view_scene.h"

namespace bole::rgbd {
namespace {

using synthetic::SceneViews;

BoardFacts board_facts(bool black) {
  BoardFacts f;
  f.columns = 8;
  f.rows = 6;
  f.square = 0.03;
  f.marker = 0.022;
  f.first_square_black = black;
  return f;
}

// The four prints that versions of OpenCV make of the same words, with a box that hides the middle.
TEST(CharucoBoard, FindsEveryLayoutAndItsPose) {
  auto camera = synthetic::plain_camera(800, 600, 800);
  camera.camera.color.distortion = {0.1, -0.2, 0.001, -0.002, 0.05};
  camera.samples = 3;
  for (const bool black : {true, false})
    for (const bool upper : {true, false}) {
      synthetic::ViewScene scene;
      scene.boxes = {{{0.12, 0.09, 0.02}, {0.03, 0.025, 0.02}, 0.4, 1}};
      scene.print = synthetic::board_print(board_facts(black), {0, 0}, upper);
      const Pose truth = synthetic::look_at({0.25, -0.2, 0.35}, {0.12, 0.09, 0});
      const SceneViews views(scene, camera, {truth});
      View view;
      views.read(0, view, {});
      const auto found = CharucoBoard(board_facts(true)).find(view.color, camera.camera.color);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->layout, (BoardLayout{black, upper}));
      EXPECT_GE(found->corners.size(), 20U);
      double worst = 0;
      for (const auto& c : found->corners) {
        const auto pixel = camera.camera.color.project(truth.inverse() * c.point);
        worst = std::max(worst, (*pixel - c.pixel).norm());
      }
      EXPECT_LT(worst, 0.35);
      const auto pose = board_pose(found->corners, camera.camera.color);
      ASSERT_TRUE(pose);
      EXPECT_FALSE(pose->ambiguous);
      EXPECT_LT((pose->T_board_camera.translation() - truth.translation()).norm(), 0.5e-3);
    }
}

// With an odd number of columns a print that begins with the other colour is the same but for the ends of its rows. A
// lens that is not known yet bends markers away, and must not turn the board into that one from view to view.
TEST(CharucoBoard, AnUnknownLensDoesNotTurnThePrint) {
  auto facts = board_facts(true);
  facts.columns = 9;
  facts.rows = 7;
  auto camera = synthetic::plain_camera(800, 600, 700);
  const CameraModel unbent = camera.camera.color;
  camera.camera.color.distortion = {-0.3, 0.1, 0, 0, 0};
  synthetic::ViewScene scene;
  scene.print = synthetic::board_print(facts, {0, 0}, true);
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i)
    poses.push_back(synthetic::look_at({0.13 + 0.22 * std::cos(i), 0.1 + 0.22 * std::sin(i), 0.24 + 0.01 * i},
                                       {0.13 + 0.03 * std::sin(3 * i), 0.1, 0}));
  const SceneViews views(scene, camera, poses);
  const CharucoBoard board(facts);
  facts.first_square_black = false;
  const CharucoBoard stated_wrongly(facts);
  int sightings = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    View view;
    views.read(i, view, {});
    const auto found = board.find(view.color, unbent);
    if (!found) continue;
    ++sightings;
    EXPECT_EQ(found->layout, (BoardLayout{true, true})) << i;
    const auto again = stated_wrongly.find(view.color, unbent);
    ASSERT_TRUE(again) << i;
    EXPECT_EQ(again->layout, (BoardLayout{true, true})) << i;
  }
  EXPECT_GE(sightings, 8);
}

TEST(CharucoBoard, NothingIsFoundWhereThereIsNone) {
  const CharucoBoard board(board_facts(true));
  const auto camera = synthetic::plain_camera();
  EXPECT_FALSE(board.find(ColorImage(640, 480, 3, 0), camera.camera.color));
  EXPECT_FALSE(board.find(ColorImage(), camera.camera.color));
  EXPECT_FALSE(board_pose({}, camera.camera.color));
  std::vector<BoardCorner> line;
  for (int i = 0; i < 8; ++i) line.push_back({{0.03 * i, 0.03, 0}, {100 + 20.0 * i, 200}});
  EXPECT_FALSE(board_pose(line, camera.camera.color));
}

TEST(CharucoBoard, WrongFactsAreRefused) {
  auto facts = board_facts(true);
  facts.dictionary = "DICT_9X9";
  EXPECT_THROW(CharucoBoard{facts}, Error);
  facts = board_facts(true);
  facts.marker = 0.04;
  EXPECT_THROW(CharucoBoard{facts}, Error);
  facts = board_facts(true);
  facts.columns = 1;
  EXPECT_THROW(CharucoBoard{facts}, Error);
}

TEST(DepthLookup, APlaneIsReadExactly) {
  RgbdCamera camera;
  camera.color = synthetic::plain_camera(80, 60, 100).camera.color;
  DepthImage depth(80, 60);
  // z = 1 / (1 + 0.2 x + 0.1 y): a plane.
  const auto inverse = [&](const Eigen::Vector3d& d) { return 1 + 0.2 * d.x() + 0.1 * d.y(); };
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x)
      depth.at(x, y) = static_cast<float>(1 / inverse(camera.color.direction(Eigen::Vector2d(x, y))));
  const DepthLookup lookup(depth, camera);
  const Eigen::Vector2d pixel(33.3, 21.7);
  const auto direction = camera.color.direction(pixel);
  EXPECT_NEAR(*lookup.inverse_depth(pixel, direction), inverse(direction), 1e-6);
  EXPECT_FALSE(lookup.inverse_depth({-5, 3}, direction));
  for (int y = 0; y < 60; ++y) depth.at(33, y) = 2;  // an edge
  EXPECT_FALSE(DepthLookup(depth, camera).inverse_depth(pixel, direction));
  EXPECT_THROW(DepthLookup(DepthImage(10, 10), camera), Error);
}

TEST(DepthLookup, AnotherDepthCameraGivesTheDepthOfTheColourPixel) {
  auto camera = synthetic::plain_camera();
  camera.camera.depth = synthetic::plain_camera(424, 240, 210).camera.color;
  camera.camera.T_color_depth.translation() = Eigen::Vector3d(-0.05, 0.002, 0.003);
  camera.camera.T_color_depth.linear() = so3_exp({0.01, 0.02, -0.01}).toRotationMatrix();
  const auto scene = synthetic::box_scene();
  const SceneViews views(scene, camera, {synthetic::look_at({0.4, 0.1, 0.35}, {0, 0, 0.03})});
  View view;
  views.read(0, view, {});
  const DepthLookup lookup(view.depth, camera.camera);
  int wrong = 0;
  std::vector<double> errors;
  for (int y = 20; y < 460; y += 7)
    for (int x = 20; x < 620; x += 7) {
      const auto direction = camera.camera.color.direction(Eigen::Vector2d(x, y));
      const auto w = lookup.inverse_depth(Eigen::Vector2d(x, y), direction);
      if (!w) continue;
      const auto& T = views.truth()[0];
      const double z = scene.cast(T.translation(), T.linear() * direction).t;
      errors.push_back(std::abs(1 / *w - z));
      wrong += errors.back() > 0.0005;
    }
  ASSERT_GT(errors.size(), 2000U);
  // Where two faces meet without a step one plane is laid through both; beside a step one camera sees what the other
  // does not.
  EXPECT_LT(wrong, static_cast<int>(errors.size()) / 20);
  EXPECT_LT(median(std::move(errors)), 1e-5);
}

TEST(Features, LieWhereTheImageHasThem) {
  // A camera moved by whole pixels moves every feature by as much, and blobs are found at their centres.
  ColorImage image(320, 240, 3, 60);
  const std::vector<Eigen::Vector2d> centres{{80, 60}, {200.5, 90.25}, {150.25, 180.75}};
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x)
      for (const auto& c : centres) {
        const double r2 = (Eigen::Vector2d(x, y) - c).squaredNorm();
        for (int k = 0; k < 3; ++k)
          image.at(x, y, k) = static_cast<std::uint8_t>(image.at(x, y, k) + 150 * std::exp(-r2 / (2 * 3.0 * 3.0)));
      }
  View view;
  view.color = image;
  const auto camera = synthetic::plain_camera(320, 240, 300);
  const auto found = extract_features(view, camera.camera, {}, false);
  for (const auto& c : centres) {
    double nearest = 1e9;
    for (const auto& f : found.features) nearest = std::min(nearest, (f.pixel - c).norm());
    EXPECT_LT(nearest, 0.06);
  }
}

TEST(Features, AreSpreadAndBounded) {
  const SceneViews views(synthetic::box_scene(), synthetic::plain_camera(),
                         {synthetic::look_at({0.4, 0.1, 0.35}, {0, 0, 0.03})});
  View view;
  views.read(0, view, {});
  for (const auto kind : {FeatureKind::sift, FeatureKind::orb}) {
    const auto found = extract_features(view, views.camera(0), {kind, 300, 1280}, false);
    EXPECT_EQ(found.size(), 300U);
    EXPECT_EQ(found.descriptors.size(), 300U * static_cast<std::size_t>(found.descriptor_bytes));
    EXPECT_EQ(extract_features(view, views.camera(0), {kind, 300, 1280}, false).descriptors, found.descriptors);
  }
  EXPECT_EQ(extract_features(View{}, views.camera(0), {}, false).size(), 0U);
}

}  // namespace
}  // namespace bole::rgbd
