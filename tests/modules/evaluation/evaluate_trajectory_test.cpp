#include "evaluation/core/evaluate_trajectory.h"
#include "summary_value.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace bole::evaluation {
namespace {

// A bent walk of 20 s at 1 m/s.
Trajectory walk(double start = 0, double step = 0.1) {
  Trajectory t;
  for (double s = 0; s <= 20 + 1e-9; s += step) {
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(s, s < 10 ? 0 : 0.5 * (s - 10), 0.1 * s);
    T.linear() = rotation_from_rpy(0, 0, 0.05 * s);
    t.poses.push_back({start + s, T});
  }
  return t;
}

Trajectory moved(Trajectory t, const Pose& by) {
  for (auto& p : t.poses) p.T_target_sensor = by * p.T_target_sensor;
  return t;
}

TEST(EvaluateTrajectory, ARigidMotionIsNoErrorAfterAlignment) {
  const Pose by = se3_exp((Vector6d() << 0.1, -0.2, 0.4, 3, -2, 1).finished());
  const auto e = evaluate_trajectory(moved(walk(), by), walk(), {});
  EXPECT_LT(value(e.summary, "ate_rmse"), 1e-9);
  EXPECT_LT(value(e.summary, "rotation_error_max"), 1e-5);
  EXPECT_LT(value(e.summary, "rpe_translation_max"), 1e-9);
  EXPECT_LT(value(e.summary, "drift"), 1e-9);
  EXPECT_TRUE(e.T_reference_estimate.isApprox(by.inverse(), 1e-9));
  EvaluationOptions none;
  none.align_trajectory = AlignTrajectory::none;
  EXPECT_GT(value(evaluate_trajectory(moved(walk(), by), walk(), none).summary, "ate_rmse"), 1);
}

TEST(EvaluateTrajectory, HandComputedErrors) {
  auto estimate = walk();
  estimate.poses.back().T_target_sensor.translation().x() += 0.3;  // one of 201 poses
  EvaluationOptions none;
  none.align_trajectory = AlignTrajectory::none;
  const auto e = evaluate_trajectory(estimate, walk(), none);
  EXPECT_NEAR(value(e.summary, "poses"), 201, 0);
  EXPECT_NEAR(value(e.summary, "ate_max"), 0.3, 1e-9);
  EXPECT_NEAR(value(e.summary, "ate_rmse"), 0.3 / std::sqrt(201), 1e-9);
  EXPECT_NEAR(value(e.summary, "ate_median"), 0, 1e-9);
  EXPECT_NEAR(value(e.summary, "end_error"), 0.3, 1e-9);
  const double length = 10 * std::sqrt(1.01) + 10 * std::sqrt(1.26);
  EXPECT_NEAR(value(e.summary, "length"), length, 1e-6);
  EXPECT_NEAR(value(e.summary, "drift"), 100 * 0.3 / length, 1e-6);
  EXPECT_NEAR(e.errors.numbers("error_x_m").back(), 0.3, 1e-9);
}

TEST(EvaluateTrajectory, AWalkThatIsTooShortIsSo) {
  auto estimate = walk();
  for (auto& p : estimate.poses) p.T_target_sensor.translation() *= 0.995;
  EvaluationOptions options;
  options.rpe_distance_m = 5;
  EXPECT_NEAR(value(evaluate_trajectory(estimate, walk(), options).summary, "length_error"), -0.5, 1e-9);
  EXPECT_NEAR(value(evaluate_trajectory(walk(), walk(), options).summary, "length_error"), 0, 1e-9);
}

TEST(EvaluateTrajectory, PosesAreInterpolatedToTheEstimatesTimes) {
  auto coarse = walk(0, 1.0);
  Trajectory estimate;
  estimate.poses.push_back({-5, Pose::Identity()});  // no reference there
  for (const auto& p : walk(0, 0.25).poses) estimate.poses.push_back(p);
  EvaluationOptions o;
  o.align_trajectory = AlignTrajectory::none, o.max_time_gap = 1.5;
  const auto e = evaluate_trajectory(estimate, coarse, o);
  EXPECT_EQ(e.poses, 81U);
  EXPECT_LT(value(e.summary, "ate_max"), 1e-9);
  coarse.poses.erase(coarse.poses.begin() + 4, coarse.poses.begin() + 8);  // a gap of 5 s: nothing is compared inside
  EXPECT_EQ(evaluate_trajectory(estimate, coarse, o).poses, 81U - 19U);
}

TEST(EvaluateTrajectory, SegmentsAsKittiTakesThem) {
  // A path whose scale is 2 % too large and that turns 0.01 deg too much per metre.
  Trajectory truth, estimate;
  for (int i = 0; i <= 3000; ++i) {
    Pose T = Pose::Identity(), E = T;
    T.translation().x() = 0.1 * i, E.translation().x() = 0.102 * i;
    E.linear() = rotation_from_rpy(0.001 * i * std::numbers::pi / 180, 0, 0);
    truth.poses.push_back({0.1 * i, T}), estimate.poses.push_back({0.1 * i, E});
  }
  const auto e = evaluate_trajectory(estimate, truth, {});
  EXPECT_NEAR(value(e.summary, "kitti_translation"), 2, 0.01);
  EXPECT_NEAR(value(e.summary, "kitti_rotation"), 0.01, 1e-4);
  EXPECT_THAT(evaluate_trajectory(walk(), walk(), {}).summary.texts("measure"),
              testing::Not(testing::Contains("kitti_translation")));  // 20 m are too short
}

TEST(EvaluateTrajectory, DifferentClocksAreExplained) {
  try {
    evaluate_trajectory(walk(1000), walk(), {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("0 of 201 poses"));
    EXPECT_THAT(e.hint(), testing::HasSubstr("clock"));
  }
}

TEST(EvaluateTrajectory, RelativeErrorsByDistanceGrowWithTheWay) {
  // One per cent too long: 2 cm over 2 m, 5 cm over 5 m, whatever the speed.
  Trajectory reference, estimate;
  for (int i = 0; i <= 200; ++i) {
    Pose T = Pose::Identity();
    const double x = i < 100 ? 0.1 * i : 10 + 0.05 * (i - 100);
    T.translation().x() = x;
    reference.poses.push_back({0.1 * i, T});
    T.translation().x() = 1.01 * x;
    estimate.poses.push_back({0.1 * i, T});
  }
  EvaluationOptions options;
  for (const double distance_m : {2.0, 5.0}) {
    options.rpe_distance_m = distance_m;
    const auto e = evaluate_trajectory(estimate, reference, options);
    EXPECT_NEAR(value(e.summary, "rpe_distance_translation_mean"), 0.01 * distance_m, 0.0011);
    EXPECT_NEAR(value(e.summary, "rpe_distance_rotation_max"), 0, 1e-9);
  }
}

}  // namespace
}  // namespace bole::evaluation
