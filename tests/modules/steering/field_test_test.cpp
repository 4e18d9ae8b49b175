// The whole test drive and its analysis.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "steering/core/field_test.h"
#include "steering/core/tracking_errors.h"
#include "steering/core/tracking_tables.h"
#include "steering/core/tuning.h"

namespace bole::steering {
namespace {

FieldTestOptions calm() {
  FieldTestOptions o;
  o.white_noise = o.drift = o.wheel_disturbance_deg = o.roughness_deg = o.heading_noise_deg = o.tilt_noise_deg = 0;
  o.steering_offset_deg = 0;
  return o;
}

TrackingErrors measured(const FieldTestOptions& o) {
  const auto test = simulate_field_test(o, {});
  return tracking_errors(test.log, &test.lines, nullptr, {}, {});
}

double value(const Table& table, const char* column, std::size_t row) { return table.numbers(column)[row]; }

TEST(FieldTest, FollowsTheLineToTheMillimetreWithoutDisturbance) {
  auto o = calm();
  o.speeds = "3";
  const auto e = measured(o);
  ASSERT_EQ(e.passes.rows(), 2u);
  EXPECT_LT(value(e.summary, "line_max_m", 0), 0.005);
  EXPECT_LT(value(e.summary, "adjacent_max_m", 0), 0.01);
}

TEST(FieldTest, MeetsTheProtocolOfThePaper) {
  FieldTestOptions o;
  const auto e = measured(o);
  ASSERT_EQ(e.passes.rows(), 6u);
  ASSERT_EQ(e.summary.rows(), 4u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_GE(value(e.passes, "length_m", i), 80) << i;
  EXPECT_EQ(e.summary.texts("speed_km_h").back(), "mean");
  EXPECT_NEAR(value(e.summary, "published_line_sd_m", 1), 0.02374, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(value(e.summary, "line_sd_m", i), 0.05) << i;
    EXPECT_LT(std::abs(value(e.summary, "line_mean_m", i)), 0.05) << i;
  }
}

TEST(FieldTest, TellsTheReceiversShareFromTheControllers) {
  auto o = calm();
  o.speeds = "5";
  o.drift = 0.05;
  o.drift_time = 1000;
  const auto e = measured(o);
  // A slow error of the receiver is driven exactly: the controller leaves nothing, the truth is all the receiver's.
  EXPECT_LT(value(e.passes, "controller_sd_m", 0), 0.003);
  EXPECT_NEAR(value(e.passes, "line_mean_m", 0), -value(e.passes, "receiver_mean_m", 0), 0.004);
  EXPECT_GT(std::abs(value(e.passes, "receiver_mean_m", 0)), 0.005);
}

TEST(FieldTest, FindsTheWheelOffsetAndTheSlipBySumming) {
  auto o = calm();
  o.speeds = "3";
  o.steering_offset_deg = 1;
  o.side_slope_deg = 10;
  EXPECT_LT(std::abs(value(measured(o).summary, "line_mean_m", 0)), 0.02);
  o.gain_i = 0;
  EXPECT_GT(std::abs(value(measured(o).passes, "line_mean_m", 0)), 0.005);
}

// Within the deadband nothing steers: the tractor weaves about the line.
TEST(FieldTest, WeavesWithADeadbandOfTheValve) {
  auto o = calm();
  o.speeds = "5";
  o.steering_offset_deg = 0.3;
  const double without = value(measured(o).summary, "controller_sd_m", 0);
  o.steering_deadband_deg = 1;
  const double with = value(measured(o).summary, "controller_sd_m", 0);
  EXPECT_GT(with, 2 * without);
  EXPECT_LT(with, 0.1);
}

TEST(FieldTest, StaysNearTheLineThroughOutagesAndJumps) {
  FieldTestOptions o;
  o.speeds = "5";
  o.repeats = 4;
  o.outages_per_hour = 120;
  o.outage_length = 4;
  auto e = measured(o);
  EXPECT_LT(value(e.summary, "line_max_m", 0), 0.35);
  o.outages_per_hour = 0;
  o.jumps_per_hour = 60;
  o.jump_size = 0.1;
  e = measured(o);
  // A jump is driven, for it looks like a place; what the controller adds to it stays small.
  EXPECT_LT(value(e.summary, "line_max_m", 0), 0.5);
  EXPECT_LT(value(e.summary, "controller_sd_m", 0), 0.06);
}

TEST(FieldTest, StopsWithoutFixesAndGoesOn) {
  FieldTestOptions o;
  o.speeds = "5";
  o.outages_per_hour = 60;
  o.outage_length = 20;
  o.max_outage = 2;
  const auto test = simulate_field_test(o, {});
  std::int64_t stopped = 0;
  for (const auto s : test.log.integers("stopped")) stopped += s;
  EXPECT_GT(stopped, 50);
  const auto e = tracking_errors(test.log, &test.lines, nullptr, {}, {});
  EXPECT_EQ(e.passes.rows(), 2u);
  EXPECT_LT(value(e.summary, "line_max_m", 0), 0.35);
}

TEST(FieldTest, IsTheSameForTheSameSeedAlone) {
  FieldTestOptions o;
  o.speeds = "5";
  const auto a = measured(o), b = measured(o);
  EXPECT_EQ(a.errors.numbers("error_m"), b.errors.numbers("error_m"));
  o.seed = 2;
  EXPECT_NE(a.errors.numbers("error_m"), measured(o).errors.numbers("error_m"));
}

// Errors are those of the drive, wherever the rows lead.
TEST(FieldTest, TurnsWithTheField) {
  auto o = calm();
  o.speeds = "5";
  o.direction_deg = 0;
  const auto straight = simulate_field_test(o, {});
  o.direction_deg = 123;
  const auto turned = simulate_field_test(o, {});
  const auto bearing = [](const Table& lines) {
    return std::atan2(value(lines, "b_x_m", 0) - value(lines, "a_x_m", 0),
                      value(lines, "b_y_m", 0) - value(lines, "a_y_m", 0));
  };
  const double turn = std::remainder(bearing(turned.lines) - bearing(straight.lines), 2 * std::numbers::pi);
  EXPECT_NEAR(std::abs(turn), 123 * std::numbers::pi / 180, 1e-6);
  const auto a = tracking_errors(straight.log, &straight.lines, nullptr, {}, {}),
             b = tracking_errors(turned.log, &turned.lines, nullptr, {}, {});
  ASSERT_EQ(a.passes.rows(), b.passes.rows());
  for (const char* column : {"line_mean_m", "line_sd_m", "line_max_m", "length_m"})
    for (std::size_t i = 0; i < a.passes.rows(); ++i)
      EXPECT_NEAR(value(a.passes, column, i), value(b.passes, column, i), 1e-5) << column << " of pass " << i + 1;
}

TEST(FieldTest, SaysWhatIsWrong) {
  FieldTestOptions o;
  o.speeds = "fast";
  EXPECT_THROW(simulate_field_test(o, {}), Error);
  o.speeds = "7";
  o.gain_p = 1;
  o.gain_d = 0;
  o.gain_i = 0;
  o.preview = 0;
  o.steering_offset_deg = 10;
  EXPECT_THROW(simulate_field_test(o, {}), Error);  // leaves the field
  Table log;
  log.set("time_s", std::vector<double>{0, 1, 2});
  log.set("x_m", std::vector<double>{0, 1, 2});
  EXPECT_THROW(tracking_errors(log, nullptr, nullptr, {}, {}), Error);  // y_m is missing
  log.set("y_m", std::vector<double>{0, 0, 0});
  EXPECT_THROW(tracking_errors(log, nullptr, nullptr, {}, {}), Error);  // no pass
}

// A log without any line or reference: two passes drawn by hand, 2.5 m apart, the second with a wave of 4 cm.
TEST(TrackingErrors, FindsLineAndPassesInABareLog) {
  std::vector<double> t, x, y;
  const auto add = [&](double px, double py) {
    t.push_back(0.1 * static_cast<double>(t.size()));
    x.push_back(px + 500'000);
    y.push_back(py + 3'000'000);
  };
  for (double s = 0; s <= 100; s += 0.15) add(s, 0);
  for (double a = 0; a < 3.14; a += 0.06) add(100 + 1.25 * std::sin(a), 1.25 - 1.25 * std::cos(a));
  for (double s = 100; s >= 0; s -= 0.15) add(s, 2.5 + 0.04 * std::sin(s));
  Table log;
  log.set("time_s", t);
  log.set("x_m", x);
  log.set("y_m", y);
  ErrorOptions o;
  o.row_width = 2.5;
  o.run_in = 10;
  const auto e = tracking_errors(log, nullptr, nullptr, o, {});
  ASSERT_EQ(e.passes.rows(), 2u);
  EXPECT_EQ(e.passes.integers("row"), (std::vector<std::int64_t>{0, 1}));
  EXPECT_EQ(e.passes.integers("direction"), (std::vector<std::int64_t>{1, -1}));
  EXPECT_LT(value(e.passes, "line_max_m", 0), 0.03);
  EXPECT_NEAR(value(e.passes, "adjacent_sd_m", 1), 0.04 / std::sqrt(2), 0.003);
  EXPECT_NEAR(value(e.passes, "line_sd_m", 1), 0.04 / std::sqrt(2), 0.003);
  EXPECT_EQ(e.summary.texts("speed_km_h")[0], "5");  // 1.5 m/s
  EXPECT_TRUE(std::isnan(value(e.summary, "receiver_sd_m", 0)));
  EXPECT_THAT(e.report.warnings, testing::Contains(testing::HasSubstr("no reference")));
}

TEST(TrackingErrors, TakesAReferenceReceiverByTime) {
  FieldTestOptions o;
  o.speeds = "5";
  const auto test = simulate_field_test(o, {});
  const auto direct = tracking_errors(test.log, &test.lines, nullptr, {}, {});
  Table log = test.log, reference;
  reference.set("time_s", *log.find("time_s"));
  reference.set("x_m", *log.find("ref_x_m"));
  reference.set("y_m", *log.find("ref_y_m"));
  log.remove("ref_x_m");
  log.remove("ref_y_m");
  const auto by_time = tracking_errors(log, &test.lines, &reference, {}, {});
  EXPECT_EQ(direct.errors.numbers("error_m"), by_time.errors.numbers("error_m"));
  EXPECT_EQ(direct.errors.numbers("receiver_m"), by_time.errors.numbers("receiver_m"));
  EXPECT_THAT(by_time.report.warnings, testing::Not(testing::Contains(testing::HasSubstr("no reference"))));
}

// One pass alone at its speed has no neighbour: the others make the mean of the adjacent error.
TEST(TrackingTables, TheMeanIsOfTheSpeedsThatWereMeasured) {
  const auto pass = [](double speed, double error, double adjacent) {
    return MeasuredPass{1, 0, 1, speed, {{0, 0, error, NAN, adjacent}, {1, 1, error, NAN, adjacent}}};
  };
  const auto summary = summary_table({pass(3, 0.01, 0.02), pass(5, 0.02, NAN), pass(7, 0.06, 0.04)});
  ASSERT_EQ(summary.texts("speed_km_h").back(), "mean");
  EXPECT_NEAR(value(summary, "line_mean_m", 3), 0.03, 1e-12);
  EXPECT_NEAR(value(summary, "adjacent_mean_m", 3), 0.03, 1e-12);
  EXPECT_NEAR(value(summary, "adjacent_max_m", 3), 0.03, 1e-12);
  EXPECT_TRUE(std::isnan(value(summary, "controller_sd_m", 3)));  // at no speed
}

TEST(Tuning, FindsGainsThatDriveTheTestWithoutOscillation) {
  TuneOptions o;
  o.speed_km_h = 5;
  const auto tuning = tune(o, {});
  const auto& p = tuning.parameters;
  EXPECT_GT(value(p, "preview_m", 0), 0);
  EXPECT_GT(value(p, "p", 0), o.first_p - 1);
  EXPECT_NEAR(value(p, "published_p", 0), 150, 1e-9);
  FieldTestOptions test;
  test.speeds = "5";
  test.preview = value(p, "preview_m", 0);
  test.gain_p = value(p, "p", 0);
  test.gain_i = value(p, "i", 0);
  test.gain_d = value(p, "d", 0);
  EXPECT_LT(value(measured(test).summary, "line_sd_m", 0), 0.05);
}

}  // namespace
}  // namespace bole::steering
