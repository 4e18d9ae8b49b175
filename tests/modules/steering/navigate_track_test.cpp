// Recorded fixes through lever arm and filter, and what is told of bad ones.
#include "steering/core/track/navigate_track.h"
#include "base/verdict.h"
#include "checks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/angles.h"
#include "base/random.h"
#include "geo/core/attitude.h"
#include "steering/core/field_test.h"
#include "steering/core/tracking_errors.h"

namespace bole::steering {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

struct Recording {
  Table track, attitude;
  std::vector<Eigen::Vector2d> truth;
};

// A curve at 2 m/s, 10 fixes a second, on ground that rolls; the antenna 0.8 m ahead, 0.3 m to the left and 2.8 m up.
Recording recording(double noise_m) {
  Random random(4, 1);
  Recording r;
  std::vector<double> t, x, y, roll, pitch, heading, speed;
  Eigen::Vector2d p(500'100, 2'500'200);
  double yaw = 0.4;
  for (int i = 0; i < 600; ++i) {
    const double time = 0.1 * i;
    const geo::Attitude a{radians(4) * std::sin(0.4 * time), radians(2) * std::cos(0.3 * time), yaw};
    const Eigen::Vector2d antenna = p + (a.R_nav_body() * Eigen::Vector3d(0.8, 0.3, 2.8)).head<2>() +
                                    noise_m * Eigen::Vector2d(random.normal(), random.normal());
    t.push_back(time);
    x.push_back(antenna.x());
    y.push_back(antenna.y());
    roll.push_back(degrees(a.roll_rad));
    pitch.push_back(degrees(a.pitch_rad));
    heading.push_back(degrees(geo::bearing_from_yaw_rad(yaw)) + 1.5);  // grid north lies 1.5 deg east of true north
    speed.push_back(2);
    r.truth.push_back(p);
    yaw += 0.1 * 0.05;
    p += 0.2 * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
  }
  r.track.set("time_s", t);
  r.track.set("x_m", x);
  r.track.set("y_m", y);
  r.track.set("heading_deg", heading);
  r.track.set("speed_m_s", speed);
  r.track.set("quality", std::vector<std::int64_t>(t.size(), 4));
  r.track.set("convergence_deg", std::vector<double>(t.size(), 1.5));
  r.attitude.set("time_s", t);
  r.attitude.set("roll_deg", roll);
  r.attitude.set("pitch_deg", pitch);
  return r;
}

NavigateOptions arm() {
  NavigateOptions o;
  o.antenna_forward = 0.8;
  o.antenna_left = 0.3;
  o.antenna_up = 2.8;
  return o;
}

double rms(const NavigatedTrack& n, const std::vector<Eigen::Vector2d>& truth, const char* x, const char* y) {
  const auto nx = n.log.numbers(x), ny = n.log.numbers(y);
  double sum = 0;
  for (std::size_t i = 50; i < nx.size(); ++i) sum += (Eigen::Vector2d(nx[i], ny[i]) - truth[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(2 * (nx.size() - 50)));
}

TEST(NavigateTrack, BringsTheAntennaToTheControlPoint) {
  const auto r = recording(0);
  const auto n = navigate_track(r.track, &r.attitude, arm(), {});
  EXPECT_LT(rms(n, r.truth, "gnss_x_m", "gnss_y_m"), 1e-6);
  EXPECT_LT(rms(n, r.truth, "x_m", "y_m"), 0.02);  // the curve accelerates; the filter lags
  EXPECT_EQ(n.report.counts.at("heading_measured"), 600);
  EXPECT_TRUE(n.report.findings.empty());
  // Each part of the reduction counts: 2.8 m up with 4 deg of roll are 20 cm, 1.5 deg of convergence 2 cm.
  EXPECT_GT(rms(navigate_track(r.track, nullptr, arm(), {}), r.truth, "gnss_x_m", "gnss_y_m"), 0.05);
  auto no_convergence = r.track;
  no_convergence.remove("convergence_deg");
  const auto turned = navigate_track(no_convergence, &r.attitude, arm(), {});
  EXPECT_GT(rms(turned, r.truth, "gnss_x_m", "gnss_y_m"), 0.01);
  EXPECT_TRUE(has_finding(turned.report, "no_convergence"));
}

TEST(NavigateTrack, FiltersTheNoiseOfTheFixes) {
  const auto r = recording(0.02);
  const auto n = navigate_track(r.track, &r.attitude, arm(), {});
  const double raw = rms(n, r.truth, "gnss_x_m", "gnss_y_m"), filtered = rms(n, r.truth, "x_m", "y_m");
  EXPECT_NEAR(raw, 0.02, 0.002);
  EXPECT_LT(filtered, 0.75 * raw);
  // The standard error that the filter reports is about that of its result.
  EXPECT_NEAR(n.log.numbers("x_se_m").back() / filtered, 1, 0.4);
}

// The simulated tractor and the stage go through the same lever arm and filter: the antenna track of a drive comes out
// where its controller was.
TEST(NavigateTrack, IsTheNavigationOfTheSimulatedDrive) {
  FieldTestOptions o;
  o.speeds = "5";
  o.white_noise = 0.02;
  const auto drive = simulate_field_test(o, {});
  Table track;  // gnss_* are fixes at the control point already
  track.set("time_s", *drive.log.find("time_s"));
  track.set("x_m", *drive.log.find("gnss_x_m"));
  track.set("y_m", *drive.log.find("gnss_y_m"));
  NavigateOptions n;
  n.position_sigma = o.position_sigma;
  n.acceleration_sigma = o.acceleration_sigma;
  const auto navigated = navigate_track(track, nullptr, n, {});
  const auto x = navigated.log.numbers("x_m"), sx = drive.log.numbers("x_m");
  ASSERT_EQ(x.size(), sx.size());
  for (std::size_t i = 300; i < x.size(); ++i) ASSERT_NEAR(x[i], sx[i], 1e-6) << i;  // starts differ and are forgotten
}

TEST(NavigateTrack, TakesTheHeadingFromCourseAndMotionWhereNothingElseGivesIt) {
  auto r = recording(0);
  auto o = arm();
  o.antenna_up = 0;
  auto course = r.track;
  course.set("course_deg", r.track.numbers("heading_deg"));
  course.remove("heading_deg");
  const auto by_course = navigate_track(course, nullptr, o, {});
  EXPECT_EQ(by_course.report.counts.at("heading_by_course"), 600);
  course.remove("course_deg");
  const auto by_motion = navigate_track(course, nullptr, o, {});
  EXPECT_GT(by_motion.report.counts.at("heading_by_motion"), 590);
  EXPECT_TRUE(has_finding(by_motion.report, "heading_from_motion"));
  auto still = course;
  still.set("x_m", std::vector<double>(600, 1.0));
  still.set("y_m", std::vector<double>(600, 2.0));
  EXPECT_THAT(refusal_of([&] { navigate_track(still, nullptr, o, {}); }), HasSubstr("needs a heading"));
}

TEST(NavigateTrack, TellsPoorFixesGapsJumpsAndTimesThatRunBack) {
  auto r = recording(0);
  auto quality = r.track.integers("quality");
  auto time = r.track.numbers("time_s"), x = r.track.numbers("x_m");
  for (std::size_t i = 100; i < 110; ++i) quality[i] = 0;  // no fix
  for (std::size_t i = 110; i < 115; ++i) quality[i] = 6;  // dead reckoning
  for (std::size_t i = 200; i < 600; ++i) time[i] += 60;   // a gap
  time[300] -= 100;                                        // the clock was set back for one fix
  for (std::size_t i = 400; i < 600; ++i) x[i] += 3;       // a jump that stays
  r.track.set("quality", quality);
  r.track.set("time_s", time);
  r.track.set("x_m", x);
  const auto n = navigate_track(r.track, nullptr, {}, {});
  const auto& c = n.report.counts;
  EXPECT_EQ(c.at("poor_fixes"), 15);
  EXPECT_EQ(c.at("quality_6"), 5);
  EXPECT_EQ(c.at("back_in_time"), 1);
  EXPECT_EQ(c.at("gaps"), 1);
  EXPECT_EQ(c.at("jumps"), 1);
  EXPECT_NEAR(static_cast<double>(c.at("doubted")), 20, 2);  // 2 s of patience
  EXPECT_EQ(n.log.rows(), 584U);
  EXPECT_EQ(n.log.integers("segment").back(), 2);
  for (const char* code : {"poor_fixes", "times_run_back", "gaps", "doubted_fixes", "no_lever_arm"})
    EXPECT_TRUE(has_finding(n.report, code)) << code;
}

// A receiver that finds its satellites again wanders off for some seconds: the filter takes neither place nor speed of
// that for good. (A walk of a real log went on at 22 m/s.)
TEST(NavigateTrack, ForgetsAVelocityThatWasWrong) {
  std::vector<double> t, x, y;
  for (int i = 0; i < 120; ++i) {
    t.push_back(i < 40 ? i : i + 30);  // a gap of half a minute
    const double lost = i >= 40 && i < 46 ? 20.0 * (46 - i) : 0;
    x.push_back(1.2 * t.back() + lost);
    y.push_back(-2 * lost);
  }
  Table track;
  track.set("time_s", t);
  track.set("x_m", x);
  track.set("y_m", y);
  track.set("quality", std::vector<std::int64_t>(t.size(), 1));
  const auto n = navigate_track(track, nullptr, {}, {});
  const auto speed = n.log.numbers("speed_m_s"), nx = n.log.numbers("x_m");
  for (std::size_t i = 70; i < speed.size(); ++i) {
    EXPECT_LT(speed[i], 2.5) << i;
    EXPECT_NEAR(nx[i], x[i], 4) << i;
  }
}

TEST(NavigateTrack, RefusesWhatIsNoTrack) {
  auto r = recording(0);
  r.track.set("quality", std::vector<std::int64_t>(600, 6));
  EXPECT_THAT(refusal_of([&] { navigate_track(r.track, nullptr, {}, {}); }), HasSubstr("6: 600"));
  NavigateOptions o;
  o.accept = "RTK";
  EXPECT_THAT(refusal_of([&] { navigate_track(r.track, nullptr, o, {}); }), HasSubstr("accept"));
  Table geodetic;
  geodetic.set("time_s", std::vector<double>{0, 1});
  geodetic.set("latitude_deg", std::vector<double>{50, 50});
  geodetic.set("longitude_deg", std::vector<double>{8, 8});
  EXPECT_THAT(refusal_of([&] { navigate_track(geodetic, nullptr, {}, {}); }), HasSubstr("geo.project"));
  auto bad = recording(0);
  auto time = bad.attitude.numbers("time_s");
  time[5] = time[4];
  bad.attitude.set("time_s", time);
  EXPECT_THAT(refusal_of([&] { navigate_track(bad.track, &bad.attitude, {}, {}); }), HasSubstr("does not rise"));
}

// Qualities are not in order: 0 means nothing only where a log gives no quality at all.
TEST(NavigateTrack, ALogWithoutAnyQualityIsTakenAsSingleFixes) {
  auto r = recording(0);
  r.track.set("quality", std::vector<std::int64_t>(600, 0));
  const auto n = navigate_track(r.track, nullptr, {}, {});
  EXPECT_EQ(n.log.rows(), 600U);
  EXPECT_NEAR(n.report.metrics.at("fix_sigma").value, 2.5, 1e-9);
  EXPECT_TRUE(has_finding(n.report, "fixes_too_poor"));
  r.track.set("sd_east_m", std::vector<double>(600, 0.03));
  r.track.set("sd_north_m", std::vector<double>(600, 0.04));
  EXPECT_NEAR(navigate_track(r.track, nullptr, {}, {}).report.metrics.at("fix_sigma").value, 0.05 / std::sqrt(2.0),
              1e-9);
  r.track.remove("quality");
  r.track.remove("sd_east_m");
  EXPECT_TRUE(has_finding(navigate_track(r.track, nullptr, {}, {}).report, "quality_unknown"));
}

// A receiver that jumps over the field has driven no pass.
TEST(TrackingErrors, AJumpIsNoPass) {
  std::vector<double> t, x;
  for (int i = 0; i < 300; ++i) {
    t.push_back(i);
    x.push_back(i % 100 < 60 ? 0.5 * (i % 7) : 30.0 * (i % 5));  // about a place, then 30 m from second to second
  }
  Table log;
  log.set("time_s", t);
  log.set("x_m", x);
  log.set("y_m", std::vector<double>(t.size(), 0.0));
  ErrorOptions o;
  o.run_in = 0;
  o.run_out = 0;
  EXPECT_THAT(refusal_of([&] { tracking_errors(log, nullptr, nullptr, o, {}); }), HasSubstr("no straight stretch"));
}

// What was driven in a gap is unknown: two passes the same way on different lines do not become one.
TEST(TrackingErrors, AGapEndsAPass) {
  std::vector<double> t, x, y;
  for (int pass = 0; pass < 2; ++pass)
    for (double s = 0; s <= 100; s += 0.2) {
      t.push_back((t.empty() ? 0 : t.back()) + (s == 0 && pass > 0 ? 120 : 0.1));
      x.push_back(s);
      y.push_back(pass * 5.0);
    }
  Table log;
  log.set("time_s", t);
  log.set("x_m", x);
  log.set("y_m", y);
  ErrorOptions o;
  EXPECT_TRUE(has_finding(tracking_errors(log, nullptr, nullptr, o, {}).report, "row_width_unknown"));
  o.row_width = 2.5;
  const auto e = tracking_errors(log, nullptr, nullptr, o, {});
  EXPECT_FALSE(has_finding(e.report, "row_width_unknown"));
  ASSERT_EQ(e.passes.rows(), 2U);
  EXPECT_EQ(e.passes.integers("row"), (std::vector<std::int64_t>{0, 2}));
  EXPECT_LT(e.passes.numbers("line_max_m")[1], 1e-6);
}

}  // namespace
}  // namespace bole::steering
