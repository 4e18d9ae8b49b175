#include "slam/core/odometry/registration.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "slam/core/odometry/keyframes.h"
#include "synthetic/scan_world.h"

namespace bole::slam {
namespace {

using synthetic::SpinningSensor;
using synthetic::SyntheticScan;

SlamSettings best_settings() {
  SlamOptions o;
  o.preset = Preset::best;
  return resolved(o);
}

Features features_of(const SyntheticScan& source, std::size_t frame_index) {
  ScanFrame frame;
  source.read(frame_index, frame);
  Scan scan;
  prepare_scan(frame, {0.5, 60, source.rings()}, scan);
  Features features;
  FeatureExtractor(best_settings()).extract(scan, features);
  return features;
}

FrameMotion truth_of(const SyntheticScan& source, std::size_t frame_index, double begin_shift_s = 0) {
  const double t = source.frame_time_s(frame_index) + begin_shift_s;
  return {source.truth(t), source.truth(t + 0.1)};
}

// A map of frames with their true motion.
void fill(FeatureMaps& maps, const SyntheticScan& source, std::size_t first, std::size_t last) {
  for (std::size_t k = first; k <= last; ++k)
    insert_keyframe(make_keyframe(k, 0, features_of(source, k).map, truth_of(source, k)), maps);
}

SyntheticScan walk(std::size_t frames, double gait = 1) {
  return {synthetic::trunks(10, 3.5), SpinningSensor::even(32, -25, 15, 450),
          [gait](double t) { return synthetic::walk_on_circle(t, 5, 1, gait, 0); }, frames};
}

double distance(const Pose& a, const Pose& b) { return (a.translation() - b.translation()).norm(); }
double angle(const Pose& a, const Pose& b) { return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle(); }

TEST(Registration, PoseEquationsAreTheDerivativesOfTheCost) {
  const Eigen::Vector3d p(3, -2, 0.7);
  const Pose T = se3_exp((Vector6d() << 0.2, -0.4, 0.9, 1, 5, -2).finished());
  for (const auto kind : {Target::Kind::plane, Target::Kind::line}) {
    Target target;
    target.mean = T * p + Eigen::Vector3d(0.02, -0.03, 0.01);
    target.axis = Eigen::Vector3d(0.4, -0.3, 0.9).normalized();
    target.variance = 0.0009;
    target.kind = kind;
    const double kernel = 1e6;  // so wide that the weight does not change
    const auto cost = [&](const Vector6d& d) {
      Pose moved = T;
      moved.linear() = so3_exp(d.head<3>()).toRotationMatrix() * T.linear();
      moved.translation() += d.tail<3>();
      return 0.5 * pose_equations(target, moved * p, moved.linear() * p, kernel).squared_error / target.variance;
    };
    const auto e = pose_equations(target, T * p, T.linear() * p, kernel);
    const double h = 1e-6;
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(e.g[i], (cost(h * Vector6d::Unit(i)) - cost(-h * Vector6d::Unit(i))) / (2 * h), 1e-5 * e.g.norm());
    EXPECT_LT((e.H - e.H.transpose()).norm(), 1e-9 * e.H.norm());
    EXPECT_GE(e.H.eigenvalues().real().minCoeff(), -1e-9 * e.H.norm());
  }
}

TEST(Registration, TheKernelTakesWeightFromFarPoints) {
  Target target;
  target.axis = Eigen::Vector3d::UnitZ();
  target.variance = 0.0004;
  target.kind = Target::Kind::plane;
  const Eigen::Vector3d lever(4, 1, 0);
  const auto near = pose_equations(target, {4, 1, 0.02}, lever, 3), far = pose_equations(target, {4, 1, 0.6}, lever, 3);
  EXPECT_TRUE(near.inlier);
  EXPECT_FALSE(far.inlier);
  EXPECT_LT(far.H.norm(), 0.02 * near.H.norm());
}

// Whatever was looked for before, and wherever: what is remembered is what a search would find.
TEST(Registration, WhatAPointMetIsWhatASearchFinds) {
  const auto source = walk(4);
  FeatureMaps maps(best_settings().cell_size);
  fill(maps, source, 0, 2);
  const auto features = features_of(source, 3).query;
  const PoseGrid poses(truth_of(source, 3));
  std::mt19937 random(4);
  std::normal_distribution<double> step(0, 0.02);
  std::uniform_int_distribution<int> first_level(0, 3), min_lines(0, 4);
  std::size_t found = 0, remembered = 0;
  for (const auto& p : features.planes) {
    MetSurface met;
    Eigen::Vector3d x = poses.in_map(p.position, p.s);
    HalfCell before = HalfCell::Zero();
    for (int look = 0; look < 12; ++look) {
      x += Eigen::Vector3d(step(random), step(random), step(random));
      const HalfCell place = maps.planes.half_cell(x);
      const int level = first_level(random), lines = min_lines(random);
      const auto searched = find_surface(maps.planes, place, false, level, lines);
      const auto& remembers = met.find(maps.planes, place, false, level, lines);
      ASSERT_EQ(searched.has_value(), remembers.has_value());
      remembered += place == before;
      before = place;
      if (!searched) continue;
      ++found;
      EXPECT_EQ(searched->level, remembers->level);
      EXPECT_EQ(searched->points, remembers->points);
      EXPECT_EQ(searched->mean, remembers->mean);
      EXPECT_EQ(searched->axes, remembers->axes);
    }
  }
  EXPECT_GT(found, 1000u);
  EXPECT_GT(remembered, 1000u);
}

TEST(Registration, ARigidShiftOfSixteenCentimetresIsFoundToOne) {
  const auto source = walk(6, 0);
  FeatureMaps maps(0.1);
  fill(maps, source, 0, 4);
  const auto truth = truth_of(source, 5);
  const Pose off = se3_exp((Vector6d() << 0.01, -0.015, 0.03, 0.12, -0.1, 0.05).finished());
  RegistrationSettings settings;
  settings.iterations = 25;
  const auto r = register_frame(features_of(source, 5).query, maps, {off * truth.T_map_begin, off * truth.T_map_end},
                                settings, {});
  EXPECT_LT(distance(r.motion.T_map_end, truth.T_map_end), 0.01);
  EXPECT_LT(angle(r.motion.T_map_end, truth.T_map_end), 0.004);
  EXPECT_GT(r.overlap, 0.5);
}

TEST(Registration, ElasticFramesFindTheMotionWithinTheFrame) {
  const auto source = walk(6);
  FeatureMaps maps(0.1);
  fill(maps, source, 0, 4);
  const auto truth = truth_of(source, 5);
  // The guess stands still at the true begin: constant velocity is wrong by a whole step.
  const FrameMotion guess{truth.T_map_begin, truth.T_map_begin};
  const auto query = features_of(source, 5).query;
  RegistrationSettings settings;
  settings.iterations = 25;
  settings.motion_sigma = 0.2;
  settings.motion_sigma_rad = 0.05;
  const auto rigid = register_frame(query, maps, guess, settings, {});
  settings.model = MotionModel::elastic;
  const auto elastic = register_frame(query, maps, guess, settings, {});
  EXPECT_LT(distance(elastic.motion.T_map_end, truth.T_map_end), 0.012);
  EXPECT_LT(distance(elastic.motion.T_map_begin, truth.T_map_begin), 0.012);
  EXPECT_LT(distance(elastic.motion.T_map_end, truth.T_map_end),
            0.5 * distance(rigid.motion.T_map_end, truth.T_map_end));
  EXPECT_LT(elastic.rms, rigid.rms);
}

// A frame of 0.2 s with half of a sway of 4 cm in it and a turn of the head, and a map of the place.
struct BentFrame {
  SyntheticScan source{synthetic::trunks(18, 3.5), sensor(450, 0.2), swaying, 1};
  FeatureMaps maps{0.1};
  FeatureSet query = features_of(source, 0).query;
  FrameMotion truth{source.truth(0), source.truth(0.2)};

  BentFrame() { fill(maps, SyntheticScan(synthetic::trunks(18, 3.5), sensor(900, 0.1), straight, 5), 0, 4); }
  static SpinningSensor sensor(int columns, double period_s) {
    auto out = SpinningSensor::even(32, -25, 15, columns);
    out.period_s = period_s;
    return out;
  }
  static Pose straight(double t) { return synthetic::walk_on_circle(t, 5, 1, 0, 0); }
  static Pose swaying(double t) {
    const double sway = bend_share(t / 0.2);
    Pose T = straight(t);
    T.translate(Eigen::Vector3d(0.01, 0.04, -0.02) * sway);
    T.rotate(Eigen::AngleAxisd(0.02 * sway, Eigen::Vector3d::UnitZ()));
    return T;
  }
  static RegistrationSettings settings() {
    RegistrationSettings settings;
    settings.model = MotionModel::elastic;
    settings.iterations = 30;
    return settings;
  }
};

TEST(Registration, LongFramesFindTheBendOfTheirMotion) {
  const BentFrame frame;
  auto settings = BentFrame::settings();
  const auto straight = register_frame(frame.query, frame.maps, frame.truth, settings, {});
  settings.bend = BendPrior{};
  const auto bent = register_frame(frame.query, frame.maps, frame.truth, settings, {});
  const Pose middle = frame.source.truth(0.1);
  EXPECT_TRUE(bent.converged);
  EXPECT_GT(distance(straight.motion.at(0.5), middle), 0.015);
  EXPECT_LT(distance(bent.motion.at(0.5), middle), 0.006);
  EXPECT_LT(angle(bent.motion.at(0.5), middle), 0.5 * angle(straight.motion.at(0.5), middle));
  EXPECT_LT(distance(bent.motion.T_map_begin, frame.truth.T_map_begin), 0.01);
  EXPECT_LT(bent.rms, straight.rms);
}

// Held to a begin that is 4 cm off, a frame bends to go through it, and hands the error on by its end.
TEST(Registration, LongFramesDoNotPassOnWhatIsKnownToBeVague) {
  const BentFrame frame;
  FrameMotion guess = frame.truth;
  for (Pose* T : {&guess.T_map_begin, &guess.T_map_end}) T->pretranslate(Eigen::Vector3d(0.02, 0.03, 0.02));
  auto settings = BentFrame::settings();
  settings.motion_sigma = 0.16;
  settings.motion_sigma_rad = 0.08;
  settings.bend = BendPrior{};
  const auto held = register_frame(frame.query, frame.maps, guess, settings, {});
  settings.begin_covariance.diagonal() << Eigen::Vector3d::Constant(1e-4), Eigen::Vector3d::Constant(1.6e-3);
  const auto loose = register_frame(frame.query, frame.maps, guess, settings, {});
  EXPECT_GT(distance(held.motion.T_map_end, frame.truth.T_map_end), 0.04);
  EXPECT_LT(distance(loose.motion.T_map_end, frame.truth.T_map_end), 0.02);
  // What it says of its end is what it is off by, and much more than what it would say of a rigid pose.
  const double end_sd = std::sqrt(loose.end_covariance.bottomRightCorner<3, 3>().trace());
  EXPECT_GT(end_sd, 3 * std::sqrt(loose.covariance.bottomRightCorner<3, 3>().trace()));
  EXPECT_LT(distance(loose.motion.T_map_end, frame.truth.T_map_end), 3 * end_sd);
}

TEST(Registration, TheResultDoesNotDependOnTheNumberOfThreads) {
  const auto source = walk(3);
  FeatureMaps maps(0.1);
  fill(maps, source, 0, 1);
  const auto query = features_of(source, 2).query;
  const auto truth = truth_of(source, 2);
  RegistrationSettings settings;
  settings.model = MotionModel::elastic;
  const auto solve = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return register_frame(query, maps, {truth.T_map_begin, truth.T_map_begin}, settings, {})
        .motion.T_map_end.matrix()
        .eval();
  };
  EXPECT_EQ(solve(1), solve(4));
}

TEST(Registration, AgainstNothingThereIsNoOverlap) {
  const auto source = walk(1);
  const auto r = register_frame(features_of(source, 0).query, FeatureMaps(0.1), {}, {}, {});
  EXPECT_EQ(r.matched, 0u);
  EXPECT_EQ(r.overlap, 0);
  EXPECT_TRUE(r.motion.T_map_end.isApprox(Pose::Identity()));
}

}  // namespace
}  // namespace bole::slam
