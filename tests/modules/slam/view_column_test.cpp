#include "slam/core/map/view_column.h"

#include <gtest/gtest.h>

#include <random>
#include <unordered_set>

namespace bole::slam {
namespace {

// Mean and spread of the range errors that a thinned map keeps of a round stem, seen from all round by a scanner that
// fires far more often than the map has room for.
struct Kept {
  int points = 0;
  double mean = 0, sd = 0, outside = 0;  // outside: mean distance of the points from the surface
};

template <class Key>
Kept thin(Key&& key) {
  constexpr double radius = 0.1, noise = 0.025;
  std::mt19937 random(5);
  std::normal_distribution<double> error;
  std::uniform_real_distribution<double> unit(0, 1);
  std::unordered_set<std::uint64_t> seen;
  Kept kept;
  double sum = 0, square = 0, outside = 0;
  for (int view = 0; view < 72; ++view)
    for (int i = 0; i < 4000; ++i) {
      const double bearing = view * 2 * std::numbers::pi / 72, across = 0.95 * radius * (2 * unit(random) - 1),
                   z = 0.2 * unit(random);
      const Eigen::Vector3d forward(-std::cos(bearing), -std::sin(bearing), 0), right(-forward.y(), forward.x(), 0),
          sensor = -5 * forward + across * right + Eigen::Vector3d(0, 0, z);
      const double e = noise * error(random), range = 5 - std::sqrt(radius * radius - across * across) + e;
      const Eigen::Vector3d p = sensor + range * forward;
      if (!seen.insert(key(p, sensor)).second) continue;
      ++kept.points, sum += e, square += e * e, outside += p.head<2>().norm() - radius;
    }
  kept.mean = sum / kept.points, kept.sd = std::sqrt(square / kept.points - kept.mean * kept.mean),
  kept.outside = outside / kept.points;
  return kept;
}

TEST(ViewColumns, WhatIsKeptHardlyWidensTheNoiseOfRanges) {
  const ViewColumns columns(0.015);
  const auto kept =
      thin([&](const Eigen::Vector3d& p, const Eigen::Vector3d& sensor) { return columns.key(p, sensor); });
  EXPECT_GT(kept.points, 500);
  EXPECT_LT(kept.points, 72 * 4000 / 4);  // it does thin
  EXPECT_NEAR(kept.mean, 0, 0.0015);
  EXPECT_NEAR(kept.sd, 0.025, 0.004);  // 0.0285: a column that ends amid the scatter keeps a second point
}

// What the columns are for: cubes widen the scatter and push the points of a round stem outwards.
TEST(ViewColumns, CubesWouldMakeStemsThicker) {
  const ViewColumns columns(0.015);
  const auto by_column =
      thin([&](const Eigen::Vector3d& p, const Eigen::Vector3d& sensor) { return columns.key(p, sensor); });
  const auto by_cube =
      thin([](const Eigen::Vector3d& p, const Eigen::Vector3d&) { return grid_key(Eigen::Vector3d(p / 0.015)); });
  EXPECT_GT(by_cube.sd, 1.3 * by_column.sd);
  EXPECT_GT(by_cube.outside, by_column.outside + 0.005);
}

TEST(ViewColumns, OneDirectionOfViewKeepsOnePointPerColumn) {
  const ViewColumns columns(0.02);
  const Eigen::Vector3d sensor(0.3, -0.2, 1.5), ray = Eigen::Vector3d(0.8, 0.5, 0.1).normalized();
  std::unordered_set<std::uint64_t> keys;
  for (double range = 4; range < 4.1; range += 0.001) keys.insert(columns.key(sensor + range * ray, sensor));
  EXPECT_LE(keys.size(), 3U);  // a ray of the sector, slanting across the columns by less than one, may meet a border
}

}  // namespace
}  // namespace bole::slam
