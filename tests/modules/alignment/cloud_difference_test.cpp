#include "alignment/core/cloud_difference.h"

#include <gtest/gtest.h>

#include <limits>

#include "modules/alignment/small_stand.h"

namespace bole::alignment {
namespace {

// A level grid of 10 cm.
PointCloud grid(int nx, int ny, double z, const Eigen::Vector3d& origin) {
  PointCloud::Positions points;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) points.emplace_back(0.1F * float(i), 0.1F * float(j), float(z));
  return PointCloud(std::move(points), origin);
}

TEST(CloudDifference, OfPointsAboveAGridIsTheirHeight) {
  const auto from = grid(100, 100, 0, {563000, 5412000, 300});
  PointCloud::Positions points;
  for (int k = 0; k < 1000; ++k)
    points.emplace_back(0.1F * float(k % 100), 0.1F * float(k / 100 * 7),
                        (k % 2 == 0 ? 1 : -1) * 0.001F * float(k + 1));
  const PointCloud cloud(std::move(points), {563000, 5412000, 300});
  const auto d = difference_of(cloud, from, {}, {});
  for (std::size_t k = 0; k < cloud.size(); ++k) {
    ASSERT_NEAR(d.distance_m[k], 0.001 * double(k + 1), 1e-5);
    ASSERT_NEAR(d.rise_m[k], (k % 2 == 0 ? 1 : -1) * 0.001 * double(k + 1), 1e-5);
  }
  EXPECT_EQ(d.compared, 1000u);
  EXPECT_EQ(d.beyond, 0u);
  EXPECT_NEAR(d.median_m, 0.5, 1e-4);
  EXPECT_NEAR(d.p95_m, 0.95, 1e-4);
  EXPECT_NEAR(d.largest_m, 1, 1e-4);
  EXPECT_NEAR(d.rms_m, std::sqrt(1001.0 * 2001 / 6) * 0.001, 1e-4);
  EXPECT_EQ(d.distances.median_m, d.median_m);
  EXPECT_EQ(d.distances.hi95_m, d.p95_m);
  EXPECT_EQ(d.distances.compared, 1000u);
  EXPECT_NEAR(d.rises.median_m, 0, 0.0021);  // as many above as below
  EXPECT_NEAR(d.rises.lo95_m, -0.95, 0.003);
  EXPECT_NEAR(d.rises.hi95_m, 0.95, 0.003);
}

TEST(CloudDifference, IsTheNearestPointOfAll) {
  Random random(5, 1);
  PointCloud::Positions a, b;
  for (int i = 0; i < 400; ++i) a.emplace_back(random.uniform(0, 5), random.uniform(0, 5), random.uniform(0, 5));
  for (int i = 0; i < 900; ++i) b.emplace_back(random.uniform(0, 5), random.uniform(0, 5), random.uniform(0, 5));
  const PointCloud cloud(a, {100, 200, 3}), from(b, {100.5, 199, 3});
  const auto d = difference_of(cloud, from, {}, {});
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    double least = 1e9;
    for (std::size_t j = 0; j < from.size(); ++j)
      least = std::min(least, (cloud.position(i) - from.position(j)).norm());
    ASSERT_NEAR(d.distance_m[i], least, 1e-5);
  }
}

// Points between those of a coarse grid lie on its plane.
TEST(CloudDifference, FromThePlaneCountsNoDensity) {
  const auto from = grid(100, 100, 0, {0, 0, 0});
  Random random(9, 1);
  PointCloud::Positions points;
  for (int i = 0; i < 3000; ++i) points.emplace_back(random.uniform(1, 9), random.uniform(1, 9), 0.02F);
  const PointCloud cloud(std::move(points));
  const auto nearest = difference_of(cloud, from, {}, {}), plane = difference_of(cloud, from, {.to_plane = true}, {});
  EXPECT_GT(nearest.median_m, 0.035);
  EXPECT_NEAR(plane.median_m, 0.02, 1e-4);
  EXPECT_NEAR(plane.largest_m, 0.02, 1e-4);
  EXPECT_NEAR(plane.rise_m[7], 0.02, 1e-4);
}

TEST(CloudDifference, TellsWhatHasNothingNear) {
  const auto from = grid(50, 50, 0, {0, 0, 0});
  PointCloud::Positions points;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 90; ++i) points.emplace_back(2.0F, 2.0F, 0.1F);
  for (int i = 0; i < 10; ++i) points.emplace_back(2.0F, 2.0F, 7.0F);
  points.emplace_back(nan, 0.0F, 0.0F);
  const PointCloud cloud(std::move(points));
  const auto d = difference_of(cloud, from, {.max_m = 1}, {});
  EXPECT_EQ(d.compared, 100u);
  EXPECT_EQ(d.beyond, 10u);
  EXPECT_NEAR(d.median_m, 0.1, 1e-5);
  EXPECT_TRUE(std::isinf(d.p95_m));
  EXPECT_TRUE(std::isinf(d.largest_m));
  EXPECT_NEAR(d.rms_m, 0.1, 1e-5);
  EXPECT_TRUE(std::isnan(d.distance_m[95]) && std::isnan(d.rise_m[95]));
  EXPECT_TRUE(std::isnan(d.distance_m[100]));
  // Nothing near at all.
  const auto far = difference_of(grid(5, 5, 0, {1000, 0, 0}), from, {.max_m = 1}, {});
  EXPECT_EQ(far.beyond, 25u);
  EXPECT_TRUE(std::isinf(far.median_m));
}

// A tree of 5 m that is gone: its points are told, all others are as near as the noise.
TEST(CloudDifference, ShowsAStemThatIsGone) {
  const auto before = small_stand(81), after = small_stand(181, {.stems = 11});
  const auto d = difference_of(before, after, {.to_plane = true}, {});
  std::size_t gone = 0;
  for (std::size_t i = before.size() - 2000; i < before.size(); ++i) gone += d.distance_m[i] > 0.1F ? 1 : 0;
  EXPECT_GT(gone, 1800u);
  EXPECT_LT(d.median_m, 0.015);
}

TEST(CloudDifference, RefusesAndIsCancelled) {
  const auto cloud = grid(50, 50, 0, {0, 0, 0});
  EXPECT_THROW(difference_of(PointCloud(), cloud, {}, {}), Error);
  EXPECT_THROW(difference_of(cloud, PointCloud(), {}, {}), Error);
  EXPECT_THROW(difference_of(cloud, cloud, {.max_m = 0}, {}), Error);
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(difference_of(cloud, cloud, {}, run), Error);
}

}  // namespace
}  // namespace bole::alignment
