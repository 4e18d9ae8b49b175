#include "plant/core/mvs/match_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "synthetic/plant_scene.h"

namespace bole::plant {
namespace {

TEST(MatchViews, PointsLieOnTheScene) {
  synthetic::PlantSceneViews::Settings settings;
  settings.views = 30;
  settings.width = 120;
  settings.height = 90;
  settings.focal = 115;
  settings.depth = false;
  const synthetic::PlantSceneViews views(settings);
  MatchOptions options;
  options.region = "-0.12 -0.12 -0.01 0.12 0.12 0.2";
  options.iterations = 2;
  options.tolerance = 0.006;
  options.spacing = 0.001;
  Report report;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  const auto cloud = match_views(views, posed, options, bole::Run{}, report);
  ASSERT_GT(cloud.size(), 1000U);
  std::vector<double> errors;
  for (std::size_t i = 0; i < cloud.size(); ++i) errors.push_back(views.scene().distance(cloud.position(i)));
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.003);
}

}  // namespace
}  // namespace bole::plant
