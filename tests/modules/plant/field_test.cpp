#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
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
  const auto given = region_from_text(options.region);
  const auto region = given ? *given : find_region(views, posed, options.min_share, bole::Run{}, out.report);
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
  settings.views = 12;
  const SceneViews views(settings);
  auto options = small_options();
  options.steps = 12;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
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

// The loss of a step as a function of the parameters.
struct Problem {
  std::vector<FieldView> views;
  FieldModel model;
  std::vector<std::size_t> training;
  std::vector<PixelWindow> windows;
  TrainSetting setting;
  TrainBatch batch;
};

Problem problem(EncoderKind kind) {
  SceneViews::Settings s;
  s.views = 10;
  s.width = 80;
  s.height = 60;
  s.focal = 75;
  const SceneViews views(s);
  FieldOptions options;
  options.voxel = 0.02;
  options.steps = 3;
  options.rays = 512;
  options.max_width = 80;
  options.encoder = kind;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  Report report;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  auto trained = train_field(views, posed, *region_from_text(options.region), options, bole::Run{}, report);
  Problem p;
  p.views = std::move(trained.views);
  p.model = std::move(trained.model);
  for (std::size_t i = 0; i < p.views.size(); ++i) {
    p.windows.push_back(window_of_region(*p.model.space, p.views[i]));
    p.training.push_back(i);
  }
  p.setting.rays = 512;
  return p;
}

class Gradients : public testing::TestWithParam<EncoderKind> {};

// Steps of float32 parameters change the loss by little, so derivatives are compared along directions that change many
// parameters at once, where rounding is far below the change. Activations with a kink leave a few per cent.
TEST_P(Gradients, AreThoseOfTheLoss) {
  auto p = problem(GetParam());
  const auto loss = [&] { return train_loss(p.model, p.views, p.training, p.windows, p.setting, 7, p.batch); };
  train_step(p.model, p.views, p.training, p.windows, p.setting, 7, p.batch);
  const auto gradient = p.model.encoder->gradients();
  ASSERT_EQ(gradient.size(), p.model.encoder->parameter_count());
  double norm = 0;
  for (const float g : gradient) norm += static_cast<double>(g) * g;
  ASSERT_GT(norm, 0);
  for (int trial = 0; trial < 6; ++trial) {
    // A random half of the parameters, along their own gradient.
    std::vector<float> direction(gradient.size());
    Random random(3, static_cast<std::uint64_t>(trial));
    double expected = 0, largest = 0;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      direction[i] = random.chance(0.5) ? gradient[i] : 0.0F;
      expected += static_cast<double>(gradient[i]) * direction[i];
      largest = std::max(largest, static_cast<double>(std::abs(direction[i])));
    }
    const float step = static_cast<float>(0.01 / largest);
    const auto move = [&](float by) {
      std::size_t at = 0;
      p.model.encoder->visit_parameters([&](std::span<float> values) {
        for (float& v : values) v += by * direction[at++];
      });
    };
    move(step);
    const double up = loss();
    move(-2 * step);
    const double down = loss();
    move(step);
    EXPECT_NEAR((up - down) / (2 * step) / expected, 1, 0.03) << trial;
  }
}

INSTANTIATE_TEST_SUITE_P(Encoders, Gradients, testing::Values(EncoderKind::grid, EncoderKind::hash),
                         [](const auto& p) { return std::string(choice_name(p.param)); });

}  // namespace
}  // namespace bole::plant
