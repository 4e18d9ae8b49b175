#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"
#include "steering/core/analyse_log.h"
#include "steering/core/run_drives.h"

namespace bole::steering {
namespace {

// Passes of 80 m at 30 deg, 2.5 m apart, there and back, at 2 m/s, with turns between them and a wave of 2 cm in the
// second.
Table log_of(double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> scatter(0, noise > 0 ? noise : 1e-12);
  std::vector<double> t, x, y;
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  const auto add = [&](double along, double across) {
    t.push_back(0.1 * static_cast<double>(t.size()));
    x.push_back(300'000 + c * along - s * across + scatter(random)),
        y.push_back(4'600'000 + s * along + c * across + scatter(random));
  };
  for (int pass = 0; pass < 3; ++pass) {
    const bool back = pass % 2 == 1;
    for (double a = 0; a <= 80; a += 0.2)
      add(back ? 80 - a : a, 2.5 * pass + (pass == 1 ? 0.02 * std::sqrt(2.0) * std::sin(a / 3) : 0));
    for (double turn = 0.05; turn < M_PI; turn += 0.05)
      add((back ? 0 : 80) + (back ? -1 : 1) * 1.25 * std::sin(turn), 2.5 * pass + 1.25 - 1.25 * std::cos(turn));
  }
  Table table;
  table.set("time_s", t), table.set("x_m", x), table.set("y_m", y);
  return table;
}

TEST(Log, PassesAndTheirErrors) {
  const auto out = analyse_log(log_of(0, 1), {}, {});
  ASSERT_EQ(out.passes.rows(), 3U);
  const auto value = [&](const char* name, std::size_t k) { return out.passes.numbers(name)[k]; };
  EXPECT_NEAR(value("angle_deg", 0), 30, 1e-6);
  EXPECT_NEAR(value("angle_deg", 2), 30, 1e-6);
  EXPECT_NEAR(value("angle_deg", 1), -150, 0.1);
  EXPECT_NEAR(value("speed_km_h", 0), 7.2, 0.1);
  EXPECT_LT(value("line_sd_m", 0), 1e-6);
  EXPECT_NEAR(value("line_sd_m", 1), 0.02, 0.003);
  EXPECT_EQ(out.passes.integers("neighbour")[1], 1);
  EXPECT_EQ(out.passes.integers("neighbour")[2], 2);
  EXPECT_NEAR(value("distance_m", 1), 2.5, 0.01);
  EXPECT_NEAR(value("adjacent_sd_m", 1), 0.02, 0.003);
  EXPECT_NEAR(out.report.metrics.at("swath").value, 2.5, 0.01);
}

TEST(Log, NoiseIsMeasuredAndFiltered) {
  const auto raw = log_of(0.03, 2);
  const auto noisy = analyse_log(raw, {}, {});
  ASSERT_EQ(noisy.passes.rows(), 3U);
  EXPECT_NEAR(noisy.passes.numbers("line_sd_m")[0], 0.03, 0.005);
  FilterOptions filter;
  filter.acceleration_sigma = 0.1;
  const auto smooth = analyse_log(filter_track(raw, filter, {}).track, {}, {});
  EXPECT_LT(smooth.passes.numbers("line_sd_m")[0], 0.7 * noisy.passes.numbers("line_sd_m")[0]);
}

TEST(Log, OddTracksSurvive) {
  Table still;
  still.set("x_m", std::vector<double>(50, 1.0)), still.set("y_m", std::vector<double>(50, 2.0));
  EXPECT_EQ(analyse_log(still, {}, {}).passes.rows(), 0U);
  Table few;
  few.set("x_m", std::vector<double>{1, std::nan("")}), few.set("y_m", std::vector<double>{1, 1});
  EXPECT_THROW(analyse_log(few, {}, {}), Error);
  Table back = log_of(0, 1);
  auto t = back.numbers("time_s");
  t[5] = 0;
  back.set("time_s", t);
  EXPECT_THROW(filter_track(back, {}, {}), Error);
}

TEST(Tune, FindsGainsThatKeepTheLine) {
  TuneOptions o;
  o.speeds = "3, 7";
  const auto tuned = tune(o, {});
  printf("%s\n", tuned.report.message.c_str());
  ASSERT_EQ(tuned.gains.rows(), 2U);
  EXPECT_GT(tuned.steps.rows(), 10U);
  for (std::size_t k = 0; k < 2; ++k) {
    DriveOptions drive;
    drive.preview = tuned.gains.numbers("preview_m")[k], drive.gain_p = tuned.gains.numbers("p")[k];
    drive.gain_i = std::max(0.01, tuned.gains.numbers("i")[k]),
    drive.gain_d = std::max(0.01, tuned.gains.numbers("d")[k]);
    drive.speeds = k == 0 ? "3" : "7";
    EXPECT_LT(run_drives(drive, {}).figures.numbers("line_sd_m")[0], 0.05);
  }
}

}  // namespace
}  // namespace bole::steering
