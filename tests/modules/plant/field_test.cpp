#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "modules/io/io_test_tools.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/field_cloud.h"
#include "plant/core/field/field_store.h"
#include "plant/core/field/grid_encoder.h"
#include "plant/core/training/held_out.h"
#include "plant/core/training/train_field.h"
#include "plant/core/training/train_step.h"
#include "plant/core/training/training_state.h"
#include "synthetic/plant_scene.h"

namespace bole::plant {
namespace {

using synthetic::PlantSceneViews;

FieldOptions small_options() {
  FieldOptions o;
  o.voxel = 0.003;
  o.steps = 150;
  o.rays = 1024;
  o.max_seconds = 1000;
  o.cloud_spacing = 0.001;
  return o;
}

// Views of the scene in pictures of `width` pixels, for tests that need no detail.
PlantSceneViews::Settings small_pictures(int views, int width) {
  PlantSceneViews::Settings settings;
  settings.views = views;
  settings.width = width;
  settings.height = 3 * width / 4;
  settings.focal = 0.9375 * width;
  return settings;
}

struct Trained {
  Report report;
  TrainedField field;
};

Trained train(const PlantSceneViews& views, const FieldOptions& options) {
  Trained out;
  const auto posed = posed_views(views, views.given_poses(), 3, out.report);
  const auto region = field_region(views, posed, options, bole::Run{}, out.report);
  out.field = train_field(views, posed, region, options, bole::Run{}, out.report);
  return out;
}

TEST(Field, ShowsViewsThatWereKeptBack) {
  const PlantSceneViews views({});
  auto options = small_options();
  options.steps = 400;
  options.rays = 2048;
  options.extent = FieldExtent::common;  // the table too
  const auto t = train(views, options);
  // Voxels and pixels are 3 mm here and the table has sharp edges, so the limit is far below that of real pictures.
  EXPECT_GT(t.field.psnr, 22.5);
  EXPECT_EQ(t.field.held_out.rows(), 3U);
  const auto psnr = t.field.progress.numbers("psnr_db");
  EXPECT_GT(psnr.back(), psnr.front() + 3);
}

TEST(Field, CloudLiesOnTheSurface) {
  const PlantSceneViews views({});
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

// A stem of 6 pixels is an edge all over: its depth is not trusted, and it must not be trained away for that.
TEST(Field, KeepsAStemThatIsAllEdge) {
  PlantSceneViews::Settings settings;
  settings.width = 320, settings.height = 240, settings.focal = 450;
  const PlantSceneViews views(settings);
  auto options = small_options();
  options.voxel = 0.002;
  options.steps = 100;
  options.region = "-0.03 -0.03 0.05 0.03 0.03 0.18";
  auto t = train(views, options);
  const auto cloud = field_cloud(t.field, options, bole::Run{}, t.report);
  std::array<int, 4> by_height{};  // of the stem's bare part, 66 to 106 mm
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto p = cloud.position(i);
    const auto step = static_cast<int>(std::floor((p.z() - 0.066) / 0.01));
    if (p.head<2>().norm() < 0.005 && step >= 0 && step < 4) ++by_height[static_cast<std::size_t>(step)];
  }
  for (const int count : by_height) EXPECT_GT(count, 60);
}

TEST(Field, SameResultWithOneThreadAndWithTwo) {
  const PlantSceneViews views(small_pictures(12, 80));
  auto options = small_options();
  options.steps = 12;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  for (const auto kind : {EncoderKind::grid, EncoderKind::hash, EncoderKind::paper}) {
    options.encoder = kind;
    std::vector<float> first, second;
    for (auto* parameters : {&first, &second}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, parameters == &first ? 1 : 2);
      auto t = train(views, options);
      t.field.model.encoder->visit_parameters(
          [&](std::span<float> values) { parameters->insert(parameters->end(), values.begin(), values.end()); });
    }
    EXPECT_EQ(first, second) << choice_name(kind);
  }
}

TEST(Field, FinishKeepsTheBestSoFar) {
  PlantSceneViews::Settings settings;
  settings.views = 8;
  const PlantSceneViews views(settings);
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

// The parameters of a field and the poses of its views, one after another.
std::vector<float> learnt(const TrainedField& field) {
  std::vector<float> out;
  field.model.encoder->visit_parameters(
      [&](std::span<float> values) { out.insert(out.end(), values.begin(), values.end()); });
  for (const auto& p : field.poses.poses)
    for (int k = 0; k < 3; ++k) out.push_back(static_cast<float>(p.T_target_sensor.translation()(k)));
  return out;
}

// Stops the training by `finish` once it has told of this step.
Trained train_up_to(const PlantSceneViews& views, const FieldOptions& options, int step) {
  Trained out;
  std::stop_source finish;
  bole::Run run;
  run.finish = finish.get_token();
  run.progress = [&](double, std::string_view what) {
    if (what.starts_with("step " + std::to_string(step) + ",")) finish.request_stop();
  };
  const auto posed = posed_views(views, views.given_poses(), 3, out.report);
  out.field = train_field(views, posed, *region_from_text(options.region), options, run, out.report);
  return out;
}

class Checkpoint : public testing::TestWithParam<EncoderKind> {};

TEST_P(Checkpoint, AnInterruptedTrainingEndsAsIfItHadNotBeen) {
  const PlantSceneViews views(small_pictures(12, 80));
  const testing_io::TempDir folder;
  auto options = small_options();
  options.encoder = GetParam();
  options.steps = 60;
  options.rays = 512;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  const auto whole = train(views, options);
  options.checkpoint = (folder.path() / "training").string();
  for (const int step : {10, 40}) {  // before and after the space is reshaped and the poses begin to move
    const auto part = train_up_to(views, options, step);
    EXPECT_EQ(part.report.status, Status::finished_early);
    EXPECT_EQ(part.report.counts.at("steps"), step);
    EXPECT_TRUE(std::filesystem::exists(options.checkpoint));
  }
  const auto rest = train(views, options);
  EXPECT_EQ(learnt(rest.field), learnt(whole.field));
  EXPECT_EQ(rest.field.psnr, whole.field.psnr);
  EXPECT_EQ(rest.field.progress.numbers("psnr_db"), whole.field.progress.numbers("psnr_db"));
  EXPECT_FALSE(std::filesystem::exists(options.checkpoint));  // nothing is left to go on with
}

INSTANTIATE_TEST_SUITE_P(Encoders, Checkpoint,
                         testing::Values(EncoderKind::grid, EncoderKind::hash, EncoderKind::paper),
                         [](const auto& p) { return std::string(choice_name(p.param)); });

TEST(Field, CheckpointsOfOthersAndDamagedOnesAreRefused) {
  const PlantSceneViews views(small_pictures(10, 40));
  const testing_io::TempDir folder;
  auto options = small_options();
  options.voxel = 0.02;
  options.steps = 30;
  options.rays = 64;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  options.checkpoint = (folder.path() / "training").string();
  train_up_to(views, options, 10);
  const auto refusal = [&](const FieldOptions& o) -> std::string {
    try {
      train_up_to(views, o, 20);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  auto other = options;
  other.depth_weight = 0.5;
  EXPECT_THAT(refusal(other), testing::HasSubstr("belongs to another training"));
  const auto size = std::filesystem::file_size(options.checkpoint);
  std::filesystem::resize_file(options.checkpoint, size - 1000);
  EXPECT_THAT(refusal(options), testing::HasSubstr("is damaged"));
  std::filesystem::resize_file(options.checkpoint, 0);
  EXPECT_THAT(refusal(options), testing::HasSubstr("it has 0 bytes"));
}

// A field that gets worse while it is trained: the best one is kept when the training is ended by hand.
TEST(Field, BestFieldIsRestored) {
  const PlantSceneViews views(small_pictures(10, 80));
  auto options = small_options();
  options.steps = 40;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  auto trained = train(views, options);
  TrainingState state(std::move(trained.field.model), std::move(trained.field.views));
  BestField best;
  const double good = quick_psnr(state.model, state.views, bole::Run{});
  best.offer(state, good);
  state.model.encoder->visit_parameters([](std::span<float> values) {
    for (float& v : values) v = 0;
  });
  const double bad = quick_psnr(state.model, state.views, bole::Run{});
  ASSERT_LT(bad, good - 3);
  best.offer(state, bad);  // is no better
  best.restore(state, options, true);
  EXPECT_EQ(quick_psnr(state.model, state.views, bole::Run{}), good);
}

TEST(Field, KeptFieldRendersTheSame) {
  const PlantSceneViews views(small_pictures(10, 80));
  for (const auto kind : {EncoderKind::grid, EncoderKind::hash, EncoderKind::paper}) {
    auto options = small_options();
    options.encoder = kind;
    options.steps = 40;
    options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
    const auto t = train(views, options);
    const auto& first = t.field.views.front();
    const auto stored = load_field(store_field(t.field.model, first));
    const auto one = Eigen::Array3f::Ones();
    const auto before =
        render_field(t.field.model, first.camera, *first.directions, first.T_world_camera, one, bole::Run{});
    const auto after =
        render_field(stored.model, stored.camera, *first.directions, stored.T_world_camera, one, bole::Run{});
    double square = 0;
    for (std::size_t i = 0; i < before.color.values.size(); ++i)
      square += std::pow(before.color.values[i] - after.color.values[i], 2);
    EXPECT_LT(std::sqrt(square / static_cast<double>(before.color.values.size())), 0.01) << choice_name(kind);
  }
}

TEST(Field, DamagedFieldsAreRefused) {
  const PlantSceneViews views(small_pictures(10, 40));
  auto options = small_options();
  options.voxel = 0.02;
  options.steps = 1;
  options.region = "-0.2 -0.2 -0.02 0.2 0.2 0.2";
  const auto t = train(views, options);
  const auto table = store_field(t.field.model, t.field.views.front());
  EXPECT_NO_THROW(load_field(table));
  EXPECT_THROW(load_field(Table{}), Error);
  auto values = table.numbers("value");
  values.resize(values.size() / 2);
  Table cut;
  cut.facts = table.facts;
  cut.set("value", values);
  EXPECT_THROW(load_field(cut), Error);
  Table wild = table;
  values = table.numbers("value");
  values[1] = 1e30;
  wild.set("value", values);
  EXPECT_THROW(load_field(wild), Error);
  Table torn = table;
  torn.facts["field"] = "{\"background\": 3";
  EXPECT_THROW(load_field(torn), Error);
}

// Poses that are off by a few millimetres come closer to the truth, and the scale stays.
TEST(Field, PosesAreRefined) {
  const PlantSceneViews views({});
  Report report;
  auto poses = views.given_poses();
  Random random(5, 5);
  const auto noise = [&] { return Eigen::Vector3d(random.normal(), random.normal(), random.normal()); };
  for (auto& p : poses.poses) {
    p.T_target_sensor.linear() = so3_exp(0.004 * noise()).toRotationMatrix() * p.T_target_sensor.linear();
    p.T_target_sensor.translation() += 0.002 * noise();
  }
  auto options = small_options();
  options.hold_out = 0;
  options.steps = 300;
  const auto posed = posed_views(views, poses, 3, report);
  const auto region = find_region(views, posed, options.min_share, bole::Run{}, report);
  const auto field = train_field(views, posed, region, options, bole::Run{}, report);
  // Where a camera sees the middle of the plant: shift and turn together.
  double before = 0, after = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector3d truth = views.given_poses().poses[i].T_target_sensor.inverse() * Eigen::Vector3d(0, 0, 0.1);
    before += (poses.poses[i].T_target_sensor * truth - Eigen::Vector3d(0, 0, 0.1)).squaredNorm();
    after += (field.poses.poses[i].T_target_sensor * truth - Eigen::Vector3d(0, 0, 0.1)).squaredNorm();
  }
  EXPECT_LT(std::sqrt(after), 0.7 * std::sqrt(before));
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
  const PlantSceneViews views(small_pictures(10, 80));
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

// A small motion of one view changes the loss as the gradients of the samples say.
TEST_P(Gradients, OfPositionsAreThoseOfTheLoss) {
  auto p = problem(GetParam());
  PoseRefinement poses(p.views);
  p.setting.poses = &poses;
  train_step(p.model, p.views, p.training, p.windows, p.setting, 7, p.batch);
  // Rays march through cells, so a motion also changes which samples there are: that is no part of the gradient. Here
  // the same samples are moved.
  double expected = 0, change = 0;
  const Eigen::Vector3f shift(3e-5F, -2e-5F, 4e-5F);
  for (auto& chunk : p.batch.chunks) {
    RayChunk moved[2];
    for (int side = 0; side < 2; ++side) {
      moved[side] = chunk;
      for (auto& s : moved[side].samples) {
        const Eigen::Vector3f by = (side == 0 ? 1.0F : -1.0F) * shift;
        s.place.position += by;
        s.place.within += by / p.model.space->boxes[s.place.box].voxel;
      }
      p.model.encoder->forward(moved[side], 0, moved[side].samples.size());
    }
    // d_density and d_color have become derivatives by raw values, so the loss here is a fixed mix of the outputs.
    RayChunk probe = chunk;
    p.model.encoder->forward(probe, 0, probe.samples.size());
    Random random(9, 9);
    for (std::size_t i = 0; i < probe.samples.size(); ++i) {
      probe.d_density[i] = 0.003F * static_cast<float>(random.uniform(-1, 1));
      probe.d_color[i] =
          Eigen::Vector3f(static_cast<float>(random.uniform(-1, 1)), static_cast<float>(random.uniform(-1, 1)),
                          static_cast<float>(random.uniform(-1, 1)));
    }
    const RayChunk mix = probe;
    probe.wants_d_position = true;
    p.model.encoder->backward(probe);
    for (std::size_t i = 0; i < probe.samples.size(); ++i) {
      // Samples next to a wall of a voxel have a kink there.
      const auto& w = chunk.samples[i].place.within;
      if ((w.array() < 0.01F).any() || (w.array() > 0.99F).any()) continue;
      const double by = 2.0 * shift.dot(probe.d_position[i]);
      const double now = mix.d_density[i] * (static_cast<double>(moved[0].density[i]) - moved[1].density[i]) +
                         mix.d_color[i].dot(moved[0].color[i] - moved[1].color[i]);
      expected += by * by;
      change += by * now;
    }
  }
  ASSERT_GT(expected, 0);
  EXPECT_NEAR(change / expected, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Encoders, Gradients, testing::Values(EncoderKind::grid, EncoderKind::hash, EncoderKind::paper),
                         [](const auto& p) { return std::string(choice_name(p.param)); });

}  // namespace
}  // namespace bole::plant
