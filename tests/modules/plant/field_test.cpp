#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/field_cloud.h"
#include "plant/core/field/grid_encoder.h"
#include "plant/core/field/train_field.h"
#include "plant/core/field/train_step.h"
#include "synthetic/plant_scene.h"

namespace bole::plant {
namespace {

using synthetic::SceneViews;

FieldOptions small_options() {
  FieldOptions o;
  o.voxel = 0.003;
  o.steps = 150;
  o.rays = 1024;
  o.max_seconds = 1000;
  o.cloud_spacing = 0.001;
  return o;
}

struct Trained {
  Report report;
  TrainedField field;
};

Trained train(const SceneViews& views, const FieldOptions& options) {
  Trained out;
  const auto posed = posed_views(views, views.given_poses(), 3, out.report);
  const auto region = find_region(views, posed, options.min_share, bole::Run{}, out.report);
  out.field = train_field(views, posed, region, options, bole::Run{}, out.report);
  return out;
}

TEST(Field, ShowsViewsThatWereKeptBack) {
  const SceneViews views({});
  const auto t = train(views, small_options());
  EXPECT_GT(t.field.psnr, 25);
  EXPECT_EQ(t.field.held_out.rows(), 3U);
  const auto psnr = t.field.progress.numbers("psnr_db");
  EXPECT_GT(psnr.back(), psnr.front() + 1);
}

TEST(Field, CloudLiesOnTheSurface) {
  const SceneViews views({});
  auto t = train(views, small_options());
  const auto cloud = field_cloud(t.field, small_options(), bole::Run{}, t.report);
  ASSERT_GT(cloud.size(), 5000U);
  std::vector<double> errors;
  for (std::size_t i = 0; i < cloud.size(); ++i) errors.push_back(views.scene().distance(cloud.position(i)));
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 0.0008);
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.003);
  EXPECT_GE(*std::ranges::min_element(cloud.values<std::int32_t>("views")), 3);
}

TEST(Field, SameResultWithOneThreadAndWithTwo) {
  SceneViews::Settings settings;
  settings.views = 8;
  settings.width = 80;
  settings.height = 60;
  settings.focal = 75;
  const SceneViews views(settings);
  auto options = small_options();
  options.steps = 12;
  std::vector<double> psnr;
  std::vector<float> first, second;
  for (auto* parameters : {&first, &second}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, parameters == &first ? 1 : 2);
    auto t = train(views, options);
    t.field.model.encoder->visit_parameters(
        [&](std::span<float> values) { parameters->insert(parameters->end(), values.begin(), values.end()); });
  }
  EXPECT_EQ(first, second);
}

TEST(Field, FinishKeepsTheBestSoFar) {
  SceneViews::Settings settings;
  settings.views = 8;
  const SceneViews views(settings);
  Report report;
  const auto options = small_options();
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  const auto region = find_region(views, posed, options.min_share, bole::Run{}, report);
  std::stop_source finish;
  finish.request_stop();
  bole::Run run;
  run.finish = finish.get_token();
  const auto field = train_field(views, posed, region, options, run, report);
  EXPECT_EQ(report.status, Status::finished_early);
  EXPECT_EQ(report.counts.at("steps"), 0);
  EXPECT_TRUE(std::isfinite(field.psnr));
}

}  // namespace
}  // namespace bole::plant
