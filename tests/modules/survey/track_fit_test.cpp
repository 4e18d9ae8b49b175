#include "survey/core/georeference/track_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "base/random.h"
#include "checks.h"
#include "survey/core/georeference/track_place.h"

namespace bole::survey {
namespace {

using ::testing::HasSubstr;
using testing_checks::refusal_of;

constexpr double begin_s = 1714551000;

// Parallel lines 6 m apart over 30 m, walked at 0.9 m/s; the sensor looks ahead and nods.
Trajectory walk_in_lines() {
  Trajectory path;
  constexpr double step_s = 0.1, speed = 0.9;
  constexpr int lines = 6;
  double t = begin_s;
  for (int line = 0; line < lines; ++line) {
    const bool up = line % 2 == 0;
    for (double s = 0; s < 30; s += speed * step_s, t += step_s) {
      StampedPose pose;
      pose.time_s = t;
      const double yaw = up ? std::numbers::pi / 2 : -std::numbers::pi / 2;
      pose.T_target_sensor = Pose(Eigen::AngleAxisd(yaw + 0.2 * std::sin(t), Eigen::Vector3d::UnitZ()) *
                                  Eigen::AngleAxisd(0.1 * std::sin(1.7 * t), Eigen::Vector3d::UnitY()));
      pose.T_target_sensor.translation() =
          Eigen::Vector3d(-15 + 6 * line + 0.3 * std::sin(0.4 * s), up ? s - 15 : 15 - s, 1.6 + 0.02 * std::sin(9 * t));
      path.poses.push_back(pose);
    }
    for (double s = 0; s < 6 && line + 1 < lines; s += speed * step_s, t += step_s) {
      StampedPose pose;
      pose.time_s = t;
      pose.T_target_sensor.translation() = Eigen::Vector3d(-15 + 6 * line + s, up ? 15 : -15, 1.6);
      path.poses.push_back(pose);
    }
  }
  return path;
}

struct TrackTruth {
  double turn_rad = radians(-38);
  Eigen::Vector3d shift{563210.5, 5412345.25, 450};
  double offset_s = 18;  // time of the walk - time of the receiver
  Eigen::Vector3d lever{0.12, -0.2, 0.35};
};

// Once a second, with errors that last: a first-order process with the time constant of a receiver under trees.
std::vector<TrackFix> track_of(const Trajectory& path, const TrackTruth& truth, double sd, double constant_s, int seed,
                               double outlier_share = 0) {
  Random random(static_cast<std::uint64_t>(seed), 5);
  std::vector<TrackFix> track;
  Eigen::Vector3d error(random.normal(0, sd), random.normal(0, sd), random.normal(0, 2 * sd));
  const double keep = constant_s > 0 ? std::exp(-1 / constant_s) : 0, fresh = std::sqrt(1 - keep * keep);
  for (double t = path.poses.front().time_s + 0.35; t < path.poses.back().time_s; t += 1) {
    const Eigen::Vector3d local = path.at(t) * truth.lever;
    Eigen::Vector3d p = truth.shift + Eigen::AngleAxisd(truth.turn_rad, Eigen::Vector3d::UnitZ()) * local + error;
    if (random.chance(outlier_share)) p += Eigen::Vector3d(random.normal(0, 15), random.normal(0, 15), 0);
    track.push_back({t - truth.offset_s, p, 1});
    error =
        keep * error + fresh * Eigen::Vector3d(random.normal(0, sd), random.normal(0, sd), random.normal(0, 2 * sd));
  }
  return track;
}

TEST(TrackFit, ExactTracksGiveClockLeverAndPlace) {
  const auto path = walk_in_lines();
  const TrackTruth truth;
  const auto track = track_of(path, truth, 1e-4, 0, 1);
  const double offset = find_clock_offset(path, track, {0}, 30).offset_s;
  EXPECT_NEAR(offset, truth.offset_s, 1);
  const auto fit = fit_track(path, track, offset, {Eigen::Vector3d::Zero(), 1});
  EXPECT_NEAR(fit.clock_offset_s, truth.offset_s, 0.002);
  EXPECT_NEAR(wrapped(fit.turn_rad - truth.turn_rad), 0, 1e-4);
  EXPECT_LT((fit.lever_sensor - truth.lever).head<2>().norm(), 0.005);
  const Eigen::Vector3d at =
      fit.centre_global - Eigen::AngleAxisd(fit.turn_rad, Eigen::Vector3d::UnitZ()) * fit.centre_local;
  EXPECT_LT((at - truth.shift).head<2>().norm(), 0.005);
}

// Of the 95 % intervals, those that hold.
struct Held {
  int clock = 0, turn = 0, place = 0, places = 0;
};

Held held_with(double constant_s, double outlier_share, int seeds) {
  const auto path = walk_in_lines();
  Held held;
  for (int seed = 0; seed < seeds; ++seed) {
    const TrackTruth truth;
    const auto track = track_of(path, truth, 0.4, constant_s, seed, outlier_share);
    // The start is as far off as find_clock_offset() leaves it.
    const auto fit = fit_track(path, track, truth.offset_s + 0.3, {Eigen::Vector3d::Zero(), 0.3});
    held.clock += std::abs(fit.clock_offset_s - truth.offset_s) <= 1.96 * fit.clock_offset_se_s ? 1 : 0;
    held.turn += std::abs(wrapped(fit.turn_rad - truth.turn_rad)) <= 1.96 * fit.turn_se_rad ? 1 : 0;
    const Eigen::Vector3d centre =
        truth.shift + Eigen::AngleAxisd(truth.turn_rad, Eigen::Vector3d::UnitZ()) * fit.centre_local;
    for (int k = 0; k < 2; ++k)
      held.place += std::abs((fit.centre_global - centre)(k)) <= 1.96 * fit.shift_se_m ? 1 : 0;
    held.places += 2;
    if (seed == 0)
      printf("se: clock %.2f s, turn %.2f deg, place %.2f m, lever %.2f m; %.1f fixes count as one\n",
             fit.clock_offset_se_s, degrees(fit.turn_se_rad), fit.shift_se_m, fit.lever_se_m.x(),
             fit.fixes_per_independent);
  }
  printf("errors last %.0f s, %.0f %% gross: clock %d, turn %d of %d; place %d of %d\n", constant_s,
         100 * outlier_share, held.clock, held.turn, seeds, held.place, held.places);
  return held;
}

// 95 % are wanted; the bounds of clock and turn are three binomial standard deviations below.
TEST(TrackFit, UncertaintiesHoldWithErrorsThatLast) {
  constexpr int seeds = 100;
  int place = 0, places = 0;
  for (const auto& [constant_s, outliers] : {std::pair(0.0, 0.0), std::pair(10.0, 0.05), std::pair(25.0, 0.05)}) {
    const auto held = held_with(constant_s, outliers, seeds);
    EXPECT_GE(held.clock, 88);
    EXPECT_GE(held.turn, 88);
    EXPECT_GE(held.place, 0.91 * held.places);
    place += held.place;
    places += held.places;
  }
  EXPECT_GE(place, 0.92 * places);
  EXPECT_LE(place, 0.98 * places);
}

TEST(TrackFit, TheOffsetFoundByShapeIsNearEnoughToStartFrom) {
  const auto path = walk_in_lines();
  const TrackTruth truth;
  const auto track = track_of(path, truth, 0.4, 10, 1, 0.05);
  const double offset = find_clock_offset(path, track, {0}, 30).offset_s;
  EXPECT_NEAR(fit_track(path, track, offset, {Eigen::Vector3d::Zero(), 0.3}).clock_offset_s, truth.offset_s, 0.2);
}

TEST(TrackFit, ATimeOfDayIsUnderstood) {
  const auto path = walk_in_lines();
  TrackTruth truth;
  truth.offset_s = std::floor(begin_s / 86400) * 86400 + 3.2;
  const auto track = track_of(path, truth, 0.05, 0, 3);
  const auto usual = usual_clock_offsets(path, track);
  EXPECT_NEAR(find_clock_offset(path, track, usual, 30).offset_s, truth.offset_s, 1);
}

TEST(TrackFit, ClocksWithoutAnythingInCommonAreFoundByTheShape) {
  const auto path = walk_in_lines();
  TrackTruth truth;
  truth.offset_s = begin_s - 4711.5;
  const auto track = track_of(path, truth, 0.3, 5, 4);
  const auto found = find_clock_offset(path, track, {}, 30);
  EXPECT_NEAR(found.offset_s, truth.offset_s, 2);
  EXPECT_TRUE(found.rival_s.has_value());  // the lines, shifted by two
}

TEST(TrackFit, RefusedWithTheReason) {
  const auto path = walk_in_lines();
  // A circle walked again and again has the same shape at every round.
  Trajectory round;
  for (int i = 0; i < 6000; ++i) {
    StampedPose pose;
    pose.time_s = begin_s + 0.1 * i;
    pose.T_target_sensor.translation() = Eigen::Vector3d(10 * std::cos(0.01 * i), 10 * std::sin(0.01 * i), 1.5);
    round.poses.push_back(pose);
  }
  const auto same = track_of(round, {}, 0.1, 0, 5);
  EXPECT_THAT(refusal_of([&] { find_clock_offset(round, same, {18}, 100); }), HasSubstr("fits alike"));
  auto other = track_of(path, {}, 0.1, 0, 6);
  for (auto& fix : other) fix.time_s *= 100;
  EXPECT_THAT(refusal_of([&] { find_clock_offset(path, other, {}, 30); }), HasSubstr("clocks"));
  EXPECT_THAT(refusal_of([&] { fit_track(path, other, 0, {}); }), HasSubstr("0 fixes"));
}

TEST(TrackPlace, ATableOfFixesPlacesThePlot) {
  const auto path = walk_in_lines();
  const TrackTruth truth;
  const auto track = track_of(path, truth, 0.02, 0, 7);
  Table table;
  std::vector<double> time, x, y, z;
  for (const auto& f : track) {
    time.push_back(f.time_s);
    x.push_back(f.global.x());
    y.push_back(f.global.y());
    z.push_back(f.global.z());
  }
  table.set("time_s", time);
  table.set("x_m", x);
  table.set("y_m", y);
  table.set("height_m", z);
  table.set("quality", std::vector<std::int64_t>(time.size(), 4));
  GeoreferenceOptions options;
  LocalPlot plot;
  plot.stems = {{0, 0, 0}, {12, 12, 1}};
  const geo::ProjectedCrs crs("EPSG:25832");
  const auto place = place_by_track(path, with_plane_columns(table), crs, plot, options);
  const Eigen::Vector3d stem(12, 12, 1);
  const Eigen::Vector3d is = truth.shift + Eigen::AngleAxisd(truth.turn_rad, Eigen::Vector3d::UnitZ()) * stem;
  const Eigen::Vector3d off = place.frame.to_global(stem) - is;
  EXPECT_LT(off.head<2>().norm(), 4 * place.uncertainty.at(stem));
  EXPECT_LT(place.uncertainty.at(stem), 0.1);
  EXPECT_NEAR(place.report.metrics.at("clock_offset").value, truth.offset_s, 0.1);
  table.remove("time_s");
  EXPECT_THAT(refusal_of([&] { place_by_track(path, with_plane_columns(table), crs, plot, options); }),
              HasSubstr("no times"));
}

}  // namespace
}  // namespace bole::survey
