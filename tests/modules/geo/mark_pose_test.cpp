#include "geo/core/mark_pose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "base/angles.h"
#include "base/error.h"
#include "base/transform.h"

namespace bole::geo {
namespace {

using ::testing::HasSubstr;

const Eigen::Vector3d robot(434'000.25, 2'562'000.5, 21.4);
const double yaw = 2.8;
const std::vector<Eigen::Vector3d> places{{-3.2, 7.5, 0.9}, {2.8, 6.0, 1.3}, {0.4, 4.0, 0.4}};  // levelled axes

std::vector<SeenMark> marks_at(const std::vector<Eigen::Vector3d>& seen) {
  std::vector<SeenMark> marks;
  for (const auto& p : seen) marks.push_back({robot + rotation_from_rpy(0, 0, yaw) * p, p});
  return marks;
}

TEST(MarkPose, FindsPlaceAndYawInProjectedCoordinates) {
  for (const std::size_t count : {2U, 3U}) {
    const auto marks = marks_at({places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)});
    const auto pose = pose_from_marks(marks, {});
    EXPECT_LT((pose.position_nav - robot).norm(), 1e-7);
    EXPECT_NEAR(pose.yaw_rad, yaw, 1e-9);
    EXPECT_NEAR(pose.sigma0, 0, 1e-4);
    EXPECT_EQ(pose.redundancy, 3 * static_cast<int>(count) - 4);
  }
}

// Simulated with the errors that are assumed, tilt included: the spread of the results is the one that is reported.
TEST(MarkPose, ItsCovarianceIsThatOfRepeatedTrials) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const MarkErrors e{0.01, 0.02, 0.008, 0.0015, 0.003};
  constexpr int trials = 3000;
  Eigen::Matrix4d sample = Eigen::Matrix4d::Zero(), predicted = Eigen::Matrix4d::Zero();
  double sigma0_square = 0;
  for (int t = 0; t < trials; ++t) {
    auto marks = marks_at(places);
    const auto tilt = rotation_from_rpy(e.tilt_rad * normal(random), e.tilt_rad * normal(random), 0);
    for (auto& m : marks) {
      m.mark_nav += Eigen::Vector3d(e.mark_plan_m * normal(random), e.mark_plan_m * normal(random),
                                    e.mark_height_m * normal(random));
      const Eigen::Vector3d u = m.seen.normalized(), v = u.unitOrthogonal(), w = u.cross(v);
      const double d = m.seen.norm();
      m.seen += e.range_m * normal(random) * u + d * e.direction_rad * (normal(random) * v + normal(random) * w);
      m.seen = tilt * m.seen;
    }
    const auto pose = pose_from_marks(marks, e);
    Eigen::Vector4d error;
    error << pose.position_nav - robot, wrapped(pose.yaw_rad - yaw);
    sample += error * error.transpose() / trials;
    predicted += pose.covariance / trials;
    sigma0_square += pose.sigma0 * pose.sigma0 / trials;
  }
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(sample(i, i) / predicted(i, i), 1, 0.12) << i;
  EXPECT_NEAR(sample(0, 3) / std::sqrt(sample(0, 0) * sample(3, 3)),
              predicted(0, 3) / std::sqrt(predicted(0, 0) * predicted(3, 3)), 0.06);
  EXPECT_NEAR(sigma0_square, 1, 0.06);
}

TEST(MarkPose, AnErrorInOneMarkShows) {
  auto marks = marks_at(places);
  marks[1].mark_nav.x() += 0.15;
  const auto pose = pose_from_marks(marks, {});
  EXPECT_GT(pose.sigma0, largest_usual_sigma0(pose.redundancy));
}

TEST(MarkPose, RefusesMarksThatCarryNoPose) {
  const auto error_of = [](const std::vector<SeenMark>& marks) {
    try {
      pose_from_marks(marks, {});
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(error_of(marks_at({places[0]})), HasSubstr("1 marks"));
  EXPECT_THAT(error_of(marks_at({{1, 5, 0}, {1, 5, 1}, {1, 5, 2}})), HasSubstr("no heading"));
  EXPECT_THAT(error_of(marks_at({{1, 5, 0}, {0, 0, 0}})), HasSubstr("mark 2"));
  auto lost = marks_at(places);
  lost[2].mark_nav.y() = NAN;
  EXPECT_THAT(error_of(lost), HasSubstr("mark 3"));
}

TEST(MarkPose, UsualSigma0IsTheQuantileOfChiSquared) {
  EXPECT_NEAR(largest_usual_sigma0(1), 3.2905, 1e-3);  // tables: 10.828, 20.515 at 99.9 %
  EXPECT_NEAR(largest_usual_sigma0(5), std::sqrt(20.515 / 5), 1e-3);
}

}  // namespace
}  // namespace bole::geo
