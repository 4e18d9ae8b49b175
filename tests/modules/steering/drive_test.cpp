#include "steering/core/drive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.h"
#include "steering/core/position_filter.h"
#include "steering/core/run_drives.h"

namespace bole::steering {
namespace {

DriveOptions ideal() {
  DriveOptions o;
  o.noise = o.drift = o.wander = o.jumps_per_hour = o.outages_per_hour = o.roughness = 0;
  o.heading_noise = o.attitude_noise = o.reference_noise = 0;
  return o;
}

TEST(Gains, AreThoseOfThePaper) {
  for (const auto& [v, d, p, i, k] :
       {std::array{3.0, 1.4, 170.0, 13.0, 39.0}, {5.0, 2.4, 150.0, 10.0, 30.0}, {7.0, 3.2, 130.0, 8.0, 22.0}}) {
    const auto g = table_gains(v);
    EXPECT_NEAR(g.preview_m, d, 1e-12);
    EXPECT_NEAR(g.p, p, 1e-12);
    EXPECT_NEAR(g.i, i, 1e-12);
    EXPECT_NEAR(g.d, k, 1e-12);
  }
  EXPECT_NEAR(table_gains(4).p, 160, 1e-12);
  EXPECT_NEAR(table_gains(1).p, 170, 1e-12);
  EXPECT_NEAR(table_gains(9).p, 130, 1e-12);
}

TEST(Filter, FollowsAConstantVelocityAndKeepsJumpsOut) {
  FilterOptions o;
  PositionFilter f(o);
  for (int k = 0; k < 200; ++k) {
    if (k > 0) f.predict(0.1);
    EXPECT_TRUE(f.update({0.1 * k, -0.05 * k}));
  }
  EXPECT_NEAR(f.position().x(), 19.9, 1e-3);
  EXPECT_NEAR(f.velocity().x(), 1.0, 1e-3);
  EXPECT_NEAR(f.velocity().y(), -0.5, 1e-3);
  f.predict(0.1);
  EXPECT_FALSE(f.update({25, -10}));
  EXPECT_NEAR(f.position().x(), 20.0, 2e-3);
  for (int k = 0; k < 30; ++k) f.predict(0.1), f.update({30, -10});
  EXPECT_NEAR(f.position().x(), 30, 0.3);  // after its patience it starts anew
  o.gate = 0;
  PositionFilter open(o);
  open.update({0, 0});
  open.predict(0.1);
  EXPECT_TRUE(open.update({25, -10}));
}

// Steady state of the gain against the closed form of the alpha-beta filter (Kalata 1984).
TEST(Filter, HasTheGainOfTheAlphaBetaFilter) {
  FilterOptions o;
  o.position_sigma = 0.05, o.acceleration_sigma = 0.4;
  PositionFilter f(o);
  const double dt = 0.1;
  for (int k = 0; k < 2000; ++k) f.predict(dt), f.update({0, 0});
  f.predict(dt);
  const double before = f.position().x();
  f.update({0.01, 0});
  const double alpha = (f.position().x() - before) / (0.01 - before);
  const double lambda = o.acceleration_sigma * dt * dt / o.position_sigma;
  const double r = (4 + lambda - std::sqrt(8 * lambda + lambda * lambda)) / 4;
  EXPECT_NEAR(alpha, 1 - r * r, 1e-4);
}

TEST(Drive, WithoutErrorsTheLineIsKept) {
  const auto o = ideal();
  for (const double v : {3.0, 5.0, 7.0}) {
    const auto test = drive_test(o, gains_of(o, v), v, 1, {});
    for (const int line : {1, 2}) {
      const auto samples = counted(test, line, o);
      ASSERT_GT(samples.size(), 100U) << v;
      for (const auto* s : samples)
        ASSERT_LT(std::abs(s->error_m), 0.03) << v << " km/h, line " << line << " at " << s->station_m;
    }
    EXPECT_EQ(test.stopped_s, 0);
  }
}

TEST(Drive, TheIntegralTakesUpWhatASlopeDoes) {
  auto o = ideal();
  o.cross_slope = 8, o.length = 150;
  const auto offset = [&](double i) {
    auto gains = gains_of(o, 5);
    gains.i = i;
    const auto test = drive_test(o, gains, 5, 1, {});
    std::vector<double> errors;
    for (const auto* s : counted(test, 1, o))
      if (s->station_m > 100) errors.push_back(s->error_m);
    return std::abs(figures_of(errors).mean_m);
  };
  EXPECT_GT(offset(0), 0.03);
  EXPECT_LT(offset(10), 0.6 * offset(0));
}

TEST(Drive, LeverArmKeepsASlopeOutOfThePosition) {
  auto o = ideal();
  o.cross_slope = 8, o.slip = 0;
  const auto mean = [&] {
    const auto test = drive_test(o, gains_of(o, 3), 3, 1, {});
    std::vector<double> e;
    for (const auto* s : counted(test, 1, o)) e.push_back(s->error_m);
    return figures_of(e).mean_m;
  };
  EXPECT_LT(std::abs(mean()), 0.01);
  o.lever_arm = false;  // the antenna at 2.9 m leans downhill by 0.4 m
  EXPECT_NEAR(std::abs(mean()), 2.9 * std::sin(8 * M_PI / 180), 0.03);
}

TEST(Drive, IsDeterministicAndCanBeCancelled) {
  DriveOptions o;
  const auto a = drive_test(o, gains_of(o, 5), 5, 3, {}), b = drive_test(o, gains_of(o, 5), 5, 3, {});
  ASSERT_EQ(a.samples.size(), b.samples.size());
  EXPECT_EQ(a.samples.back().error_m, b.samples.back().error_m);
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(drive_test(o, gains_of(o, 5), 5, 3, run), Error);
}

TEST(Drive, TableAndCases) {
  DriveOptions o;
  const auto result = run_drives(o, {});
  const auto& f = result.figures;
  ASSERT_EQ(f.rows(), 3U);
  for (std::size_t k = 0; k < 3; ++k)
    printf(
        "%g km/h: line mean %+.4f sd %.4f max %.4f (published %+.4f %.4f %.4f)  adjacent %+.4f %.4f %.4f (published "
        "%+.4f %.4f %.4f)\n"
        "        true sd %.4f, receiver %.4f, controller %.4f, perfect receiver %.4f\n",
        f.numbers("speed_km_h")[k], f.numbers("line_mean_m")[k], f.numbers("line_sd_m")[k], f.numbers("line_max_m")[k],
        f.numbers("published_line_mean_m")[k], f.numbers("published_line_sd_m")[k],
        f.numbers("published_line_max_m")[k], f.numbers("adjacent_mean_m")[k], f.numbers("adjacent_sd_m")[k],
        f.numbers("adjacent_max_m")[k], f.numbers("published_adjacent_mean_m")[k],
        f.numbers("published_adjacent_sd_m")[k], f.numbers("published_adjacent_max_m")[k], f.numbers("true_sd_m")[k],
        f.numbers("receiver_sd_m")[k], f.numbers("controller_sd_m")[k], f.numbers("perfect_sd_m")[k]);
  const auto& c = result.cases;
  for (std::size_t k = 0; k < c.rows(); ++k) {
    printf("%g km/h %s %g: %.3f m, stood %.1f s\n", c.numbers("speed_km_h")[k], c.texts("case")[k].c_str(),
           c.numbers("size")[k], c.numbers("peak_error_m")[k], c.numbers("stopped_s")[k]);
    const bool jump = c.texts("case")[k] == "jump";
    // A jump moves the tractor by no more than half again its size; an outage not by half a metre.
    EXPECT_LT(c.numbers("peak_error_m")[k], jump ? 0.15 + 1.5 * c.numbers("size")[k] : 0.5);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT(f.numbers("line_sd_m")[k], 0.06);
    EXPECT_LT(f.numbers("adjacent_sd_m")[k], 0.08);
    EXPECT_LT(f.numbers("perfect_sd_m")[k], f.numbers("line_sd_m")[k] + 0.005);
  }
}

TEST(Drive, WrongOptionsAreRefused) {
  EXPECT_THROW(speeds_of("3, fast"), Error);
  EXPECT_THROW(speeds_of(""), Error);
  EXPECT_THROW(speeds_of("300"), Error);
  OptionSet set(option_table(static_cast<const DriveOptions*>(nullptr)));
  set.set_text("settle", "99");
  EXPECT_THROW(set.check_all(), Error);
}

}  // namespace
}  // namespace bole::steering
