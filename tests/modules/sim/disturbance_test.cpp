#include "sim/core/walk/disturbance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modules/sim/plots.h"
#include "sim/core/plot/forest.h"

namespace bole::sim {
namespace {

struct Recorded {
  std::vector<bool> kept;
  std::vector<std::vector<sensor::LaserEcho>> echoes;
  std::vector<double> azimuth_rad, time_s;
};

class DisturbanceTest : public testing::Test {
 protected:
  DisturbanceTest()
      : terrain_(bare_plot().terrain, 1),
        sensor_(sensor::load_sensor_model("vlp32c")),
        walk_(route(), terrain_, {}, 1) {}

  // Two seconds of a sensor that sees a wall 9 m away all around.
  Recorded record(const DisturbanceParameters& parameters) const {
    Disturbance disturbance(parameters, sensor_, walk_, 1);
    Recorded out;
    const std::vector<sensor::LaserEcho> wall(sensor_.channels.size(), sensor::LaserEcho{9, 50});
    for (std::int64_t i = 0; static_cast<double>(i) * sensor_.sequence_period_s < 2; ++i) {
      const double time_s = static_cast<double>(i) * sensor_.sequence_period_s, turn_rad_s = two_pi * 10;
      FiringSequence s{i, time_s, std::fmod(first_azimuth_rad + turn_rad_s * time_s, two_pi), turn_rad_s, wall};
      out.kept.push_back(disturbance.apply(s));
      out.echoes.emplace_back(s.echoes.begin(), s.echoes.end());
      out.azimuth_rad.push_back(s.azimuth_rad);
      out.time_s.push_back(time_s);
    }
    return out;
  }

  static std::vector<Eigen::Vector2d> route() {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < 20; ++i) points.emplace_back(0.25 * i, 0);
    return points;
  }
  Terrain terrain_;
  sensor::SensorModel sensor_;
  Walk walk_;
};

TEST_F(DisturbanceTest, nothing_asked_changes_nothing) {
  const auto r = record({});
  EXPECT_TRUE(std::ranges::all_of(r.kept, [](bool k) { return k; }));
  for (const auto& echoes : r.echoes)
    for (const auto& e : echoes) ASSERT_EQ(e.range_m, 9);
}

TEST_F(DisturbanceTest, a_gap_takes_whole_packets) {
  const auto r = record({.gap_at_s = 0.5, .gap_s = 1.0});
  std::size_t lost = 0;
  for (std::size_t i = 0; i < r.kept.size(); ++i) {
    if (i % 24 != 0) {
      EXPECT_EQ(r.kept[i], r.kept[i - 1]) << i;
    }
    if (r.time_s[i] > 0.503 && r.time_s[i] < 1.497) {
      EXPECT_FALSE(r.kept[i]);
    }
    lost += !r.kept[i];
  }
  EXPECT_NEAR(static_cast<double>(lost) * sensor_.sequence_period_s, 1.0, 0.004);
}

TEST_F(DisturbanceTest, a_blind_sector_lies_behind) {
  const auto r = record({.blind_sector_rad = std::numbers::pi / 2});
  for (std::size_t i = 0; i < r.kept.size(); ++i) {
    const double from_behind = std::abs(std::remainder(r.azimuth_rad[i] - std::numbers::pi, two_pi));
    if (std::abs(from_behind - std::numbers::pi / 4) < 0.15) continue;  // lasers differ in azimuth
    for (const auto& e : r.echoes[i]) ASSERT_EQ(e.range_m > 0, from_behind > std::numbers::pi / 4);
  }
}

TEST_F(DisturbanceTest, rain_is_nearer_and_as_frequent_as_asked) {
  const auto r = record({.rain = 0.1});
  double drops = 0, all = 0;
  for (const auto& echoes : r.echoes)
    for (const auto& e : echoes) {
      ASSERT_LE(e.range_m, 9);
      ASSERT_GE(e.range_m, static_cast<float>(sensor_.min_range_m));
      drops += e.range_m < 9;
      ++all;
    }
  // Drops beyond the wall are not seen.
  EXPECT_NEAR(drops / all, 0.1 * (1 - std::exp(-(9 - sensor_.min_range_m) / 6)), 0.005);
}

TEST_F(DisturbanceTest, the_companion_stands_where_it_is_said) {
  const auto r = record({.companion = true, .noise = 0});
  std::size_t seen = 0;
  for (std::size_t i = 0; i < r.kept.size(); i += 7)
    for (std::size_t c = 0; c < r.echoes[i].size(); ++c) {
      if (r.echoes[i][c].range_m >= 9) continue;
      ++seen;
      const auto& laser = sensor_.channels[c];
      const double a = r.azimuth_rad[i] + two_pi * 10 * laser.firing_time_s + laser.azimuth_offset_rad,
                   e = laser.elevation_rad;
      const Eigen::Vector3d p = walk_.pose(r.time_s[i]).linear() *
                                (r.echoes[i][c].range_m *
                                 Eigen::Vector3d(std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), std::sin(e)));
      EXPECT_NEAR((p.head<2>() - Disturbance::companion_offset(r.time_s[i])).norm(), Disturbance::companion_radius_m,
                  0.002);
      EXPECT_GT(p.z(), -1.71);
      EXPECT_LT(p.z(), 0.06);
    }
  EXPECT_GT(seen, 500u);
}

TEST_F(DisturbanceTest, a_turn_on_the_spot_turns_before_the_walk) {
  const Walk turning(route(), terrain_, {.gait = 0, .stand_still_s = 1, .max_s = {}, .turn_rad = std::numbers::pi}, 1);
  const auto yaw = [&](double t) {
    const Eigen::Matrix3d R = turning.pose(t).linear();
    return std::atan2(R(1, 0), R(0, 0));
  };
  EXPECT_NEAR(std::abs(std::remainder(yaw(4.1) - yaw(0.9), two_pi)), std::numbers::pi, 1e-3);
  EXPECT_LT((turning.pose(4).translation() - turning.pose(0).translation()).norm(), 1e-6);
  double fastest = 0;
  for (double t = 1; t < 4; t += 0.01)
    fastest = std::max(fastest, std::abs(std::remainder(yaw(t + 0.01) - yaw(t), two_pi)) / 0.01);
  EXPECT_NEAR(fastest, std::numbers::pi / 2, 0.01);
  EXPECT_NEAR(turning.duration_s() - walk_.duration_s(), 3 - 1.5, 1e-9);
}

// A sensor at 0.45 m before a body of 0.2 m radius: some 53 degrees are dark, and only behind.
TEST_F(DisturbanceTest, the_operator_stands_behind_a_sensor_in_the_hand) {
  const auto r = record({.operator_body = true, .sensor_height_m = 1.5});
  double dark = 0, all = 0;
  for (std::size_t i = 0; i < r.kept.size(); ++i) {
    const Pose T = walk_.pose(r.time_s[i]);
    for (std::size_t c = 0; c < r.echoes[i].size(); ++c) {
      const auto& laser = sensor_.channels[c];
      if (std::abs(laser.elevation_rad) > 0.1) continue;
      const double azimuth = r.azimuth_rad[i] + laser.azimuth_offset_rad;
      const Eigen::Vector3d ray = T.linear() * Eigen::Vector3d(std::cos(azimuth), -std::sin(azimuth), 0);
      const bool blocked = !(r.echoes[i][c].range_m > 0);
      const double from_behind = std::abs(std::atan2(ray.y(), -ray.x()));  // the walk leads to +x
      if (blocked) {
        EXPECT_LT(from_behind, 0.75);
      }
      if (from_behind < 0.25) {
        EXPECT_TRUE(blocked);
      }
      dark += blocked;
      all += 1;
    }
  }
  EXPECT_NEAR(dark / all, 2 * std::asin(0.2 / 0.45) / two_pi, 0.02);
}

TEST_F(DisturbanceTest, the_clock_wanders_without_going_back) {
  const double sd = 0.0005;
  Disturbance disturbance({.clock_jitter_s = sd}, sensor_, walk_, 1);
  double squares = 0, last = -1, n = 0;
  for (double t = 0; t < 200; t += 24 * sensor_.sequence_period_s) {
    const double error = disturbance.clock_error_s(t);
    EXPECT_GT(t + error, last);
    last = t + error;
    squares += error * error;
    n += 1;
  }
  EXPECT_NEAR(std::sqrt(squares / n), sd, 0.35 * sd);
  EXPECT_EQ(Disturbance({}, sensor_, walk_, 1).clock_error_s(3), 0);
}

}  // namespace
}  // namespace bole::sim
