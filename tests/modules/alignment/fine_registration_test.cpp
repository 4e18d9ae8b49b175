#include "alignment/core/fine_registration.h"

#include <gtest/gtest.h>

#include "modules/alignment/small_stand.h"

namespace bole::alignment {
namespace {

const Eigen::Vector3d middle(8, 8, 2);

// How far the motion that was found leaves the corners of the plot from where they belong.
double worst_m(const FineRegistration& found, const Pose& away, const Eigen::Vector3d& about) {
  double worst = 0;
  for (const double x : {-8.0, 8.0})
    for (const double y : {-8.0, 8.0})
      for (const double z : {-2.0, 3.0}) {
        const Eigen::Vector3d p(x, y, z);
        worst = std::max(worst, (found.motion.of(about + away * p) - (about + p)).norm());
      }
  return worst;
}

TEST(FineRegistration, FindsAKnownMotion) {
  const Eigen::Vector3d origin(563000, 5412000, 300);
  for (std::uint64_t seed = 20; seed < 23; ++seed) {
    const auto fixed = small_stand(seed, {}, origin), other = small_stand(seed + 100, {}, origin);
    const auto away = pose_of({0.5, -0.4, 0.8}, {0.15, -0.12, 0.1});
    const auto found = register_finely(moved_cloud(other, away, origin + middle), fixed, {}, {});
    ASSERT_TRUE(found.converged()) << static_cast<int>(found.end);
    EXPECT_LT(worst_m(found, away, origin + middle), 0.004);
    EXPECT_GT(found.overlap, 0.97);
    EXPECT_NEAR(found.rms_m, 0.01, 0.004);
    EXPECT_GT(found.start_rms_m, 2 * found.rms_m);
    EXPECT_GT(found.pairs, 20'000u);
    EXPECT_EQ(found.motion.scale, 1);
  }
}

// Half of the plot, and a third of the points somewhere in the air.
TEST(FineRegistration, BearsAPartialOverlapAndPointsWithoutAPartner) {
  const auto fixed = small_stand(31);
  auto other = small_stand(131, {.x_from_m = 8});
  auto points = other.positions();
  Random random(31, 2);
  const std::size_t strays = points.size() / 2;
  for (std::size_t i = 0; i < strays; ++i)
    points.emplace_back(random.uniform(8, 24), random.uniform(0, 16), random.uniform(0.5, 6));
  other.set_positions(points);
  const auto away = pose_of({0.3, 0.2, -0.6}, {-0.1, 0.14, -0.06});
  const auto found = register_finely(moved_cloud(other, away, middle), fixed, {}, {});
  ASSERT_TRUE(found.converged()) << static_cast<int>(found.end);
  EXPECT_LT(worst_m(found, away, middle), 0.01);
  EXPECT_LT(found.overlap, 0.75);
  EXPECT_GT(found.overlap, 0.5);
}

TEST(FineRegistration, LeavesWhatLiesRight) {
  const auto cloud = small_stand(41);
  const auto found = register_finely(cloud, cloud, {}, {});
  EXPECT_LT(worst_m(found, Pose::Identity(), middle), 0.001);
}

TEST(FineRegistration, SaysWhenTheCloudsAreApart) {
  const auto fixed = small_stand(51);
  const auto found = register_finely(moved_cloud(fixed, pose_of({0, 0, 0}, {40, 0, 0}), middle), fixed, {}, {});
  EXPECT_EQ(found.end, FineEnd::apart);
  EXPECT_EQ(found.motion.to, found.motion.from);
  EXPECT_EQ(found.motion.turn, Eigen::Matrix3d::Identity());
}

// A level floor says nothing of where along it the cloud belongs; two stems are enough to say it.
TEST(FineRegistration, SaysWhenTheCloudCouldSlide) {
  const auto level = [](std::uint64_t seed, bool stems) {
    Random random(seed, 9);
    PointCloud::Positions points;
    for (int i = 0; i < 40'000; ++i)
      points.emplace_back(random.uniform(0, 16), random.uniform(0, 16), 0.02 * random.normal());
    for (int i = 0; stems && i < 3'000; ++i) {
      const double a = random.angle();
      points.emplace_back((i % 2 == 0 ? 3 : 12) + 0.15 * std::cos(a), 6 + 0.15 * std::sin(a), random.uniform(0, 4));
    }
    return PointCloud(std::move(points));
  };
  const auto away = pose_of({0.4, 0.3, 0.2}, {0.05, 0.04, 0.08});
  const auto slides = register_finely(moved_cloud(level(62, false), away, middle), level(61, false), {}, {});
  EXPECT_EQ(slides.end, FineEnd::open);
  EXPECT_LT(std::abs(slides.open_shift.z()), 0.3);
  EXPECT_LT(slides.open_turn.head<2>().norm(), 0.3);
  EXPECT_EQ(slides.motion.to, slides.motion.from);
  const auto held = register_finely(moved_cloud(level(64, true), away, middle), level(63, true), {}, {});
  ASSERT_TRUE(held.converged()) << static_cast<int>(held.end);
  EXPECT_LT(worst_m(held, away, middle), 0.02);
}

TEST(FineRegistration, IsTheSameAgainAndCanBeCancelled) {
  const auto fixed = small_stand(71), other = moved_cloud(small_stand(171), pose_of({0, 0, 0.5}, {0.1, 0, 0}), middle);
  const auto first = register_finely(other, fixed, {}, {}), second = register_finely(other, fixed, {}, {});
  EXPECT_EQ(first.motion.turn, second.motion.turn);
  EXPECT_EQ(first.motion.to, second.motion.to);
  std::stop_source stop;
  bole::Run run;
  run.cancel = stop.get_token();
  double last = 0;
  run.progress = [&](double fraction, std::string_view) {
    EXPECT_GE(fraction, last);
    last = fraction;
    if (fraction > 0.2) stop.request_stop();
  };
  EXPECT_THROW(register_finely(other, fixed, {}, run), Error);
  EXPECT_THROW(register_finely(PointCloud(), fixed, {}, {}), Error);
  EXPECT_THROW(register_finely(other, fixed, {.reach_m = 0}, {}), Error);
}

}  // namespace
}  // namespace bole::alignment
