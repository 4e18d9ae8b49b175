#include "survey/core/join_trajectory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "cloud/core/global_frame.h"
#include "cloud/known_facts.h"
#include "survey/core/path_clock.h"
#include "survey/core/path_curve.h"
#include "synthetic/scan_world.h"

namespace bole::survey {
namespace {

using testing::HasSubstr;

// A walk of 200 s about a square of 30 m, twice, with a gait; height 1.5 m.
Eigen::Vector3d place_at(double t) {
  const double s = std::fmod(t, 100) * 1.2;
  const double side = 30;
  const int corner = static_cast<int>(s / side) % 4;
  const double along = std::fmod(s, side);
  const Eigen::Vector2d corners[5] = {{0, 0}, {side, 0}, {side, side}, {0, side}, {0, 0}};
  const Eigen::Vector2d p = corners[corner] + along / side * (corners[corner + 1] - corners[corner]);
  return {500000 + p.x(), 5400000 + p.y(), 301.5 + 0.02 * std::sin(6 * t)};
}

constexpr double walk_s = 200;

Trajectory walk(double time_offset, double rate = 10) {
  Trajectory out;
  for (int i = 0; i <= static_cast<int>(walk_s * rate); ++i) {
    const double t = i / rate;
    Pose pose = Pose::Identity();
    pose.translation() = place_at(t);
    out.poses.push_back({t + time_offset, pose});
  }
  return out;
}

// Points of the ground, 1.4 m below the sensor, `nearest` to `farthest` metres aside from where it was.
PointCloud mapped(double time_offset, double nearest = 2, double farthest = 12) {
  PointCloud::Positions positions;
  std::vector<double> time;
  const Eigen::Vector3d origin(500000, 5400000, 300);
  for (int i = 0; i < 20000; ++i) {
    const double t = 0.5 + (walk_s - 1) * i / 20000;
    const double bearing = 2.399963 * i, range = nearest + (farthest - nearest) * std::fmod(0.618034 * i, 1);
    const Eigen::Vector3d place =
        place_at(t) + Eigen::Vector3d(range * std::cos(bearing), range * std::sin(bearing), -1.4);
    positions.push_back((place - origin).cast<float>());
    time.push_back(t + time_offset);
  }
  PointCloud cloud(std::move(positions), origin);
  cloud.set_column(arrays::time, std::move(time));
  return cloud;
}

template <class F>
std::string error_of(F&& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.what();
  }
  return "no error";
}

const Finding* finding(const Report& report, std::string_view code) {
  const auto it = std::ranges::find_if(report.findings, [&](const Finding& f) { return f.code == code; });
  return it == report.findings.end() ? nullptr : &*it;
}

// How far the sensors of the joined cloud are from where it was.
double worst_sensor(const PointCloud& cloud, double time_offset) {
  double worst = 0;
  const auto& x = cloud.values<float>(arrays::sensor_x);
  const auto& y = cloud.values<float>(arrays::sensor_y);
  const auto& z = cloud.values<float>(arrays::sensor_z);
  const auto& time = cloud.values<double>(arrays::time);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    worst =
        std::max(worst, (cloud.origin + Eigen::Vector3d(x[i], y[i], z[i]) - place_at(time[i] - time_offset)).norm());
  return worst;
}

TEST(PathCurve, GoesThroughPosesAndNotOverGaps) {
  auto path = walk(0, 10);
  const PathCurve curve(path, 0.5);
  // Straight lines would be off by up to 0.9 mm.
  for (double t = 10.05; t < 20; t += 0.1) EXPECT_LT((*curve.at(t) - place_at(t)).norm(), 1e-4) << t;
  EXPECT_EQ(*curve.at(7), path.poses[70].T_target_sensor.translation());
  EXPECT_FALSE(curve.at(-0.1));
  EXPECT_FALSE(curve.at(walk_s + 0.1));
  EXPECT_FALSE(curve.at(std::nan("")));
  path.poses.erase(path.poses.begin() + 100, path.poses.begin() + 120);
  EXPECT_FALSE(PathCurve(path, 0.5).at(11));
  EXPECT_TRUE(PathCurve(path, 5).at(11));
}

TEST(PathCurve, PosesThatNearlyCoincideInTimeAreOne) {
  Trajectory path;
  for (const auto& [t, x] : {std::pair(0.0, 0.0), {0.1, 0.1}, {0.100001, 0.101}, {0.2, 0.2}, {0.3, 0.3}}) {
    path.poses.push_back({t, Pose::Identity()});
    path.poses.back().T_target_sensor.translation().x() = x;
  }
  const PathCurve curve(path, 0.5);
  for (double t = 0; t <= 0.3; t += 0.003) EXPECT_NEAR(curve.at(t)->x(), t, 2e-3) << t;
}

TEST(PathClock, LeapSecondsOfTheDates) {
  EXPECT_EQ(leap_seconds(315964800), 0);  // 1980-01-06
  EXPECT_EQ(leap_seconds(1136073599), 13);
  EXPECT_EQ(leap_seconds(1136073600), 14);  // 2006-01-01
  EXPECT_EQ(leap_seconds(1700000000), 18);  // 2023-11-14
}

// Of a survey with a place on the earth the cloud was moved there, and the path was not.
TEST(JoinTrajectory, MovesThePathOfThePlotToAPlacedCloud) {
  GlobalFrame frame;
  frame.centre_local = {500000, 5400000, 300};  // the axes of the plot, far from what they were moved to
  frame.shift_global = {3563210, 5912345, 431};
  frame.A_global_local = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  frame.A_global_local.topRows<2>() *= 0.9996;
  frame.crs_wkt = "LOCAL_CS[\"a grid\"]";
  frame.heights_known = true;
  const auto placed = to_global(mapped(0), frame, {});
  const auto joined = join_trajectory(placed, walk(0), {}, {});
  ASSERT_NE(finding(joined.report, "path_moved"), nullptr);
  EXPECT_EQ(finding(joined.report, "path_moved")->severity, Severity::note);
  const auto& time = joined.points.values<double>(arrays::time);
  const auto &x = joined.points.values<float>(arrays::sensor_x), &y = joined.points.values<float>(arrays::sensor_y),
             &z = joined.points.values<float>(arrays::sensor_z);
  double worst = 0;
  for (std::size_t i = 0; i < time.size(); ++i)
    worst = std::max(
        worst, (joined.points.origin + Eigen::Vector3d(x[i], y[i], z[i]) - frame.to_global(place_at(time[i]))).norm());
  EXPECT_LT(worst, 0.03);
  for (const auto& pose : joined.trajectory.poses)
    EXPECT_LT((pose.T_target_sensor.linear() * pose.T_target_sensor.linear().transpose() - Eigen::Matrix3d::Identity())
                  .norm(),
              1e-9);
  EXPECT_NEAR(std::atan2(joined.trajectory.poses[0].T_target_sensor.linear()(1, 0),
                         joined.trajectory.poses[0].T_target_sensor.linear()(0, 0)),
              0.4, 1e-9);
  auto foreign = placed;  // does not know them
  foreign.facts.erase("local_axes");
  EXPECT_THAT(error_of([&] { join_trajectory(foreign, walk(0), {}, {}); }),
              HasSubstr("does not run through the cloud"));
}

TEST(JoinTrajectory, GivesEveryPointItsRayAndItsPass) {
  const auto joined = join_trajectory(mapped(0), walk(0), {}, {});
  EXPECT_LT(worst_sensor(joined.points, 0), 0.03);  // float32, and the corners that are cut
  EXPECT_EQ(joined.report.counts.at("points_without_pose"), 0);
  EXPECT_EQ(joined.report.counts.at("passes"), 3);  // each begins 8 m before the walk closes its round
  const auto& pass = joined.points.values<std::int32_t>(arrays::pass);
  EXPECT_EQ(pass.front(), 0);
  EXPECT_EQ(pass[12000], 1);
  EXPECT_EQ(pass.back(), 2);
  const auto& range = joined.points.values<float>(arrays::range);
  for (const float r : range) EXPECT_TRUE(r > 1.9F && r < 12.2F) << r;
  EXPECT_EQ(pose_origin(joined.points.facts), PoseOrigin::given);
  EXPECT_EQ(finding(joined.report, "time_offset"), nullptr);
  EXPECT_EQ(finding(joined.report, "time_shift_suspect"), nullptr);
  EXPECT_EQ(finding(joined.report, "path_place_suspect"), nullptr);
}

TEST(JoinTrajectory, KnowsTheClocksThatProgramsWrite) {
  constexpr double unix_s = 1700000000, gps = unix_s - 315964800 + 18;
  const double week = std::floor(gps / 604800) * 604800;
  const double clocks[] = {gps, gps - 1e9, gps - week, unix_s};
  for (const double of_points : clocks)
    for (const double of_path : clocks) {
      const auto joined = join_trajectory(mapped(of_points), walk(of_path), {}, {});
      EXPECT_NEAR(joined.report.metrics.at("time_offset").value, of_points - of_path, 1e-5)
          << of_points << " " << of_path;
      EXPECT_LT(worst_sensor(joined.points, of_points), 0.03);
      EXPECT_EQ(finding(joined.report, "time_offset") != nullptr, of_points != of_path);
      EXPECT_NEAR(joined.trajectory.poses.front().time_s, of_points, 1e-5);
    }
}

TEST(JoinTrajectory, ClocksThatDoNotGoTogetherGiveBothRanges) {
  for (const double of_path : {9000.0, 3e8}) {
    const auto text = error_of([&] { join_trajectory(mapped(700000), walk(of_path), {}, {}); });
    EXPECT_THAT(text, HasSubstr("no clocks are known"));
    EXPECT_THAT(text, HasSubstr("from 70000"));
    EXPECT_THAT(text, HasSubstr(of_path == 9000 ? "from 9000.000 to 9200.000" : "to 300000200.000"));
    EXPECT_THAT(text, HasSubstr("Set time_offset; it is"));
  }
  JoinOptions options;
  options.time_offset = 691000;
  EXPECT_LT(worst_sensor(join_trajectory(mapped(700000), walk(9000), options, {}).points, 700000), 0.03);
  options.time_offset = 5;
  EXPECT_THAT(error_of([&] { join_trajectory(mapped(700000), walk(9000), options, {}); }), HasSubstr("have a pose"));
}

TEST(JoinTrajectory, AShiftOfLeapSecondsIsToldAndNotMade) {
  const auto joined = join_trajectory(mapped(1000), walk(1018), {}, {});
  EXPECT_EQ(joined.report.metrics.at("time_offset").value, 0);
  const auto* found = finding(joined.report, "time_shift_suspect");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->text, HasSubstr("time_offset=-18.000"));
  JoinOptions options;
  options.time_offset = -18;
  EXPECT_LT(worst_sensor(join_trajectory(mapped(1000), walk(1018), options, {}).points, 1000), 0.03);
}

TEST(JoinTrajectory, ShiftsBelowASecondAreTold) {
  const auto joined = join_trajectory(mapped(1000, 0.1, 0.6), walk(1001), {}, {});
  const auto* found = finding(joined.report, "time_shift_suspect");
  ASSERT_NE(found, nullptr);
  EXPECT_THAT(found->text, HasSubstr("time_offset=-1.0"));
  EXPECT_EQ(finding(join_trajectory(mapped(0, 0.1, 0.6), walk(0), {}, {}).report, "time_shift_suspect"), nullptr);
}

TEST(JoinTrajectory, APathThatWasMovedIsTold) {
  for (const Eigen::Vector3d& by :
       {Eigen::Vector3d(10, 0, 0), Eigen::Vector3d(0, -10, 0), Eigen::Vector3d(0, 0, 6), Eigen::Vector3d(0, 0, -3)}) {
    auto path = walk(0);
    for (auto& pose : path.poses) pose.T_target_sensor.translation() += by;
    const auto* found = finding(join_trajectory(mapped(0), path, {}, {}).report, "path_place_suspect");
    ASSERT_NE(found, nullptr) << by.transpose();
    EXPECT_THAT(found->text, HasSubstr(by.z() == 0 ? "aside" : "above the lowest"));
  }
}

// Two hundred stems on level ground, seen from a walk between them; the sensor is in sight of every point.
PointCloud seen_stems(const Trajectory& path) {
  synthetic::World world;
  world.planes.push_back({Eigen::Vector3d::UnitZ(), -1.5});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-15, 45), radius(0.08, 0.2);
  const auto way = [&](const Eigen::Vector2d& at) {
    double nearest = 1e9;
    for (const auto& pose : path.poses)
      nearest = std::min(nearest, (pose.T_target_sensor.translation().head<2>() - at).norm());
    return nearest;
  };
  while (world.cylinders.size() < 200) {
    const Eigen::Vector2d at(place(random), place(random));
    if (way(at) > 0.8) world.cylinders.push_back({{at.x(), at.y(), -2}, Eigen::Vector3d::UnitZ(), radius(random), 12});
  }
  PointCloud::Positions positions;
  std::vector<double> time;
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi), up(-0.4, 0.4);
  const double length = path.poses.back().time_s - path.poses.front().time_s;
  for (int i = 0; i < 150000; ++i) {
    const double t = length * i / 150000;
    const auto& sensor = path.poses[static_cast<std::size_t>(t * 10)].T_target_sensor;
    const double a = turn(random), e = up(random);
    const Eigen::Vector3d ray(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    const double range = world.range(sensor.translation(), ray);
    if (!(range < 40)) continue;
    positions.push_back((sensor.translation() + range * ray).cast<float>());
    time.push_back(path.poses[static_cast<std::size_t>(t * 10)].time_s);
  }
  PointCloud cloud(std::move(positions), Eigen::Vector3d::Zero());
  cloud.set_column(arrays::time, std::move(time));
  return cloud;
}

// Less than the median distance of the points: neither distances nor the middle of the points tell.
TEST(JoinTrajectory, APathThatLooksThroughStemsIsTold) {
  auto path = walk(0);
  for (auto& pose : path.poses) pose.T_target_sensor.translation() -= Eigen::Vector3d(500000, 5400000, 301.5);
  const auto cloud = seen_stems(path);
  const auto right = join_trajectory(cloud, path, {}, {});
  EXPECT_EQ(finding(right.report, "path_looks_through_points"), nullptr);
  std::printf("rays through points: %.3f\n", right.report.metrics.at("rays_through_points").value);
  for (const Eigen::Vector3d& by : {Eigen::Vector3d(1.5, 0, 0), Eigen::Vector3d(-2, 1, 0), Eigen::Vector3d(0, -4, 0)}) {
    auto moved = path;
    for (auto& pose : moved.poses) pose.T_target_sensor.translation() += by;
    const auto joined = join_trajectory(cloud, moved, {}, {});
    std::printf("moved by %.1f m: %.3f\n", by.norm(), joined.report.metrics.at("rays_through_points").value);
    EXPECT_EQ(finding(joined.report, "path_place_suspect"), nullptr);
    const auto* found = finding(joined.report, "path_looks_through_points");
    ASSERT_NE(found, nullptr) << by.transpose();
    EXPECT_THAT(found->text, HasSubstr("m in x"));
  }
}

TEST(JoinTrajectory, APathOfAPartNamesTheBestClock) {
  auto path = walk(0);
  path.poses.resize(800);  // 80 of 200 s
  const auto text = error_of([&] { join_trajectory(mapped(0), path, {}, {}); });
  EXPECT_THAT(text, HasSubstr("same clock"));
  EXPECT_THAT(text, HasSubstr("40 %"));
  EXPECT_THAT(text, HasSubstr("time_offset=0.000"));
}

TEST(JoinTrajectory, PassesOfTheCloudAreReplacedAndTold) {
  auto cloud = mapped(0);
  cloud.set_column(arrays::pass, std::vector<std::int32_t>(cloud.size(), 7));
  EXPECT_NE(finding(join_trajectory(cloud, walk(0), {}, {}).report, "passes_replaced"), nullptr);
}

TEST(JoinTrajectory, OtherCoordinatesAreRefused) {
  auto local = walk(0);
  for (auto& pose : local.poses) pose.T_target_sensor.translation() -= Eigen::Vector3d(500000, 5400000, 300);
  EXPECT_THAT(error_of([&] { join_trajectory(mapped(0), local, {}, {}); }),
              HasSubstr("does not run through the cloud"));
  auto high = walk(0);
  for (auto& pose : high.poses) pose.T_target_sensor.translation().z() += 48;  // above the ellipsoid
  EXPECT_THAT(error_of([&] { join_trajectory(mapped(0), high, {}, {}); }), HasSubstr("does not run through the cloud"));
  auto turned = walk(0);
  const Eigen::Vector3d middle(500015, 5400015, 0);
  for (auto& pose : turned.poses) {
    const Eigen::Vector3d d = pose.T_target_sensor.translation() - middle;
    pose.T_target_sensor.translation() = middle + Eigen::Vector3d(-d.x(), -d.y(), d.z());
  }
  JoinOptions options;
  options.max_distance = 100;
  EXPECT_THAT(error_of([&] { join_trajectory(mapped(0), turned, options, {}); }), HasSubstr("do not follow the path"));
}

TEST(JoinTrajectory, CloudsWithoutTimesAndTurnedCloudsAreRefused) {
  auto cloud = mapped(0);
  cloud.facts["turned"] = "levelled";
  EXPECT_THAT(error_of([&] { join_trajectory(cloud, walk(0), {}, {}); }), HasSubstr("levelled"));
  cloud = mapped(0);
  cloud.remove_column(arrays::time.name);
  EXPECT_THAT(error_of([&] { join_trajectory(cloud, walk(0), {}, {}); }), HasSubstr("no times"));
  EXPECT_THAT(error_of([&] { join_trajectory(mapped(0), Trajectory(), {}, {}); }), HasSubstr("0 poses"));
}

TEST(JoinTrajectory, PointsWithoutAPoseAreCounted) {
  auto path = walk(0);
  path.poses.erase(path.poses.begin() + 500, path.poses.begin() + 700);
  const auto joined = join_trajectory(mapped(0), path, {}, {});
  EXPECT_NEAR(static_cast<double>(joined.report.counts.at("points_without_pose")), 20.1 / 199 * 20000, 30);
  EXPECT_NE(finding(joined.report, "points_without_pose"), nullptr);
  const auto& x = joined.points.values<float>(arrays::sensor_x);
  EXPECT_EQ(std::ranges::count_if(x, [](float v) { return std::isnan(v); }),
            joined.report.counts.at("points_without_pose"));
}

}  // namespace
}  // namespace bole::survey
