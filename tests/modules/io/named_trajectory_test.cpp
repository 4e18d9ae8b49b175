#include "io/core/tables/named_trajectory.h"
#include "io/core/tables/sbet_reader.h"

#include <gmock/gmock.h>

#include <cmath>

#include "cloud/known_facts.h"
#include "io/core/formats.h"
#include "io/core/gdal/project_trajectory.h"
#include "io/core/tables/trajectory_file.h"
#include "io_test_tools.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

Trajectory read_named(const std::string& text) { return read_named_trajectory(bytes_of(text), "a.txt"); }

std::string trajectory_format(const std::string& text, const std::string& name) {
  constexpr std::array trajectories{FileContent::trajectory};
  return std::string(find_format(bytes_of(text), name, trajectories)->name);
}

TEST(NamedTrajectory, GeoSlamHasTheScalarFirst) {
  const std::string text =
      "%time x y z q0 q1 q2 q3 userfields\n10.5 1 2 3 0.70710678 0 0 0.70710678\n"
      "10.6 1 2 3.5 1 0 0 0 7 8\n";
  EXPECT_EQ(trajectory_format(text, "plot_traj.txt"), "named");
  const auto path = read_named(text);
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_EQ(path.poses[0].time_s, 10.5);
  EXPECT_EQ(path.poses[1].T_target_sensor.translation(), Eigen::Vector3d(1, 2, 3.5));
  // A quarter turn to the left.
  EXPECT_LT((path.poses[0].T_target_sensor.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
            1e-7);
  EXPECT_FALSE(path.facts.contains("orientation"));
}

TEST(NamedTrajectory, HdMappingHasMatricesAndNanoseconds) {
  const auto path = read_named(
      "timestamp_nanoseconds pose00 pose01 pose02 pose03 pose10 pose11 pose12 pose13 pose20 pose21 pose22 pose23 "
      "timestampUnix_nanoseconds om_rad fi_rad ka_rad\n"
      "548348730180 1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 0\n548348730189.99993896 0 -1 0 4 1 0 0 5 0 0 1 6 0 0 0 0\n");
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_NEAR(path.poses[0].time_s, 548.348730180, 1e-9);
  EXPECT_EQ(path.poses[1].T_target_sensor.translation(), Eigen::Vector3d(4, 5, 6));
  EXPECT_LT((path.poses[1].T_target_sensor.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
            1e-9);
}

TEST(NamedTrajectory, ColumnsInAnyOrderWithOrWithoutOrientation) {
  const auto path =
      read_named("Easting,Northing,Height,Roll,GPSTime\n500000.25,5400000.5,300,0,1000\n500001,5400001,301,0,1001\n");
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_EQ(path.poses[0].T_target_sensor.translation(), Eigen::Vector3d(500000.25, 5400000.5, 300));
  EXPECT_EQ(path.facts.at("orientation"), "unknown");
  EXPECT_EQ(read_named("#nsecs, x, y, z, ori_w, ori_x, ori_y, ori_z\n1478254247676381327, 1, 2, 3, 1, 0, 0, 0\n")
                .poses[0]
                .time_s,
            1478254247676381327 * 1e-9);
}

TEST(NamedTrajectory, CommentsAboveTumPosesMayGoOn) {
  const std::string poses = "1 1 2 3 0 0 0 1\n2 1 2 4 0 0 0 1\n";
  EXPECT_EQ(read_named("# time_s x_m y_m z_m qx qy qz qw (sensor in plot axes)\n" + poses).poses.size(), 2U);
  EXPECT_EQ(trajectory_format("# timestamp tx ty tz qx qy qz qw from the second walk\n" + poses, "a.txt"), "TUM");
}

TEST(NamedTrajectory, OtherFormatsStayWhatTheyAre) {
  EXPECT_EQ(trajectory_format("# time x y z\n1 0 0 0 0 0 0 1\n", "a.tum"), "TUM");
  EXPECT_EQ(trajectory_format("# timestamp tx ty tz qx qy qz qw\n1 0 0 0 0 0 0 1\n", "a.tum"), "named");
  EXPECT_EQ(trajectory_format("1 0 0 0 0 0 0 1\n", "a.txt"), "TUM");
  EXPECT_EQ(trajectory_format("# a path\n1 0 0 0 0 0 0 1\n", "a.txt"), "TUM");
  EXPECT_EQ(trajectory_format("1 0 0 0 0 1 0 0 0 0 1 0\n", "a.txt"), "KITTI");
}

TEST(NamedTrajectory, LinesThatCannotBeUsedAreNamed) {
  const std::string head = "time x y z qw qx qy qz\n";
  EXPECT_THAT(error_of([&] { read_named(head + "1 2 3\n"); }), HasSubstr("line 2"));
  EXPECT_THAT(error_of([&] { read_named(head + "1 a 0 0 1 0 0 0\n"); }), HasSubstr("'a'"));
  EXPECT_THAT(error_of([&] { read_named(head + "1 0 0 0 2 0 0 0\n"); }), HasSubstr("quaternion"));
  EXPECT_THAT(error_of([&] { read_named(head + "2 0 0 0 1 0 0 0\n1 0 0 0 1 0 0 0\n"); }),
              HasSubstr("times that increase"));
  EXPECT_THAT(error_of([&] { read_named(head); }), HasSubstr("no poses"));
  EXPECT_THAT(error_of([&] { read_named(""); }), HasSubstr("names the columns"));
  EXPECT_EQ(read_named(head + "1 0 0 0 1 0 0 0\n1 9 0 0 1 0 0 0\n2 0 0 0 1 0 0 0\n").facts.at("repeated_times"), "1");
}

TEST(NamedTrajectory, UnitsInTheHeaderAreNoColumns) {
  const auto path = read_named("Time (s),X (m),Y (m),Z (m),Roll,Pitch,Yaw\n1.5,10,20,30,0.1,0.2,0.3\n");
  EXPECT_EQ(path.poses[0].time_s, 1.5);
  EXPECT_EQ(path.poses[0].T_target_sensor.translation(), Eigen::Vector3d(10, 20, 30));
  EXPECT_EQ(read_named("timestamp [ns], x [m], y [m], z [m]\n1500000000, 1, 2, 3\n").poses[0].time_s, 1.5);
  EXPECT_EQ(read_named("time [s] x [m] y [m] z [m]\n2 1 2 3\n").poses[0].T_target_sensor.translation().z(), 3);
  const auto riprocess = read_named("Time[s],Easting[m],Northing[m],Elevation[m]\n7,500000,5400000,300\n");
  EXPECT_EQ(riprocess.poses[0].T_target_sensor.translation(), Eigen::Vector3d(500000, 5400000, 300));
  EXPECT_TRUE(is_geographic(read_named("gps_seconds[s] latitude[deg] longitude[deg] altitude[m]\n7 48 9 300\n")));
  EXPECT_THAT(error_of([&] { read_named("time,x [ft],y [ft],z [ft]\n1,2,3,4\n"); }), HasSubstr("names the columns"));
}

TEST(NamedTrajectory, CellsStandUnderTheirNamesOrAreRefused) {
  const std::string head = "time;x;y;z\n";
  EXPECT_THAT(error_of([&] { read_named(head + "0,00;12,34;56,78;1,20\n"); }), HasSubstr("'0,00'"));
  EXPECT_THAT(error_of([&] { read_named("time,x,y,z\n0,00;12,34;56,78;1,20\n"); }), HasSubstr("line 2"));
  EXPECT_THAT(error_of([&] { read_named("time,x,y,z,roll\n1.0,,3,4,5\n"); }), HasSubstr("''"));
  EXPECT_THAT(error_of([&] { read_named("time,x,y,z\n1,2,3,4,5\n"); }), HasSubstr("5 values"));
  EXPECT_EQ(read_named("time,x,y,z,\n1,2,3,4,\n").poses[0].T_target_sensor.translation(), Eigen::Vector3d(2, 3, 4));
  // An empty cell of another column moves nothing.
  EXPECT_EQ(read_named("time,roll,x,y,z\n1,,2,3,4\n").poses[0].T_target_sensor.translation(), Eigen::Vector3d(2, 3, 4));
}

TEST(NamedTrajectory, SecondsAndNanosecondsAreOneTime) {
  const auto path = read_named("sec,nanosec,x,y,z\n5,250000000,1,2,3\n5,750000000,1,2,4\n");
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_EQ(path.poses[0].time_s, 5.25);
  EXPECT_EQ(path.poses[1].time_s, 5.75);
  EXPECT_EQ(read_named("nanoseconds seconds x y z\n500000000 5 1 2 3\n").poses[0].time_s, 5.5);
  EXPECT_THAT(error_of([&] { read_named("sec,nanosec,x,y,z\n5,2500000000,1,2,3\n"); }), HasSubstr("below a second"));
}

std::string sbet_of(std::vector<std::array<double, 4>> records) {
  std::string out;
  for (const auto& [time, latitude, longitude, height] : records) {
    put(out, time);
    put(out, latitude * M_PI / 180);
    put(out, longitude * M_PI / 180);
    put(out, height);
    for (int i = 4; i < 17; ++i) put(out, 0.0);
  }
  return out;
}

TEST(Sbet, IsProjectedToTheCoordinatesOfThePoints) {
  const auto file = sbet_of({{345600.5, 48, 9, 300}, {345601.5, 48.001, 9, 301}});
  EXPECT_EQ(trajectory_format(file, "sbet.out"), "SBET");
  auto path = read_sbet(bytes_of(file), "sbet.out");
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_TRUE(is_geographic(path));
  project_trajectory(path, "EPSG:32632");
  // On the central meridian of the zone; the length of the meridian from the equator to 48 deg, times 0.9996.
  const auto& p = path.poses[0].T_target_sensor.translation();
  EXPECT_NEAR(p.x(), 500000, 1e-3);
  EXPECT_NEAR(p.y(), 0.9996 * 5318427.5955, 0.01);
  EXPECT_EQ(p.z(), 300);
  EXPECT_NEAR(path.poses[1].T_target_sensor.translation().y() - p.y(), 111.2 * 0.9996, 0.2);
  EXPECT_THAT(error_of([&] { project_trajectory(path, "EPSG:4326"); }), HasSubstr("projected"));
  EXPECT_THAT(error_of([&] { project_trajectory(path, "nonsense"); }), HasSubstr("crs"));
}

TEST(Sbet, CutLyingAndEmptyFiles) {
  const auto file = sbet_of({{1, 48, 9, 300}, {1, 48, 9, 300}, {2, 48, 9, 300}, {3, 480, 9, 300}});
  const auto path = read_sbet(bytes_of(file), "a");
  EXPECT_EQ(path.poses.size(), 2U);
  EXPECT_EQ(path.facts.at("repeated_times"), "1");
  EXPECT_EQ(path.facts.at("impossible_records"), "1");
  const auto rolled = read_sbet(bytes_of(sbet_of({{604799, 48, 9, 300}, {0.5, 48, 9, 300}, {1.5, 48, 9, 300}})), "a");
  ASSERT_EQ(rolled.poses.size(), 3U);
  EXPECT_EQ(rolled.poses[2].time_s, 604801.5);
  EXPECT_EQ(read_sbet(bytes_of(file.substr(0, 300)), "a").poses.size(), 1U);
  EXPECT_THAT(error_of([&] { read_sbet(bytes_of(file.substr(0, 100)), "a"); }), HasSubstr("SBET"));
  EXPECT_THAT(error_of([&] { read_sbet({}, "a"); }), HasSubstr("SBET"));
}

}  // namespace
}  // namespace bole::io
