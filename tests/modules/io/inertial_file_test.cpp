#include "io/core/scans/inertial_file.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.h"
#include "io_test_tools.h"
#include "synthetic/scan_world.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;

InertialRecord read_inertial_text(const std::string& text, Report& report) {
  return read_inertial(Bytes(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "imu.csv", report);
}
InertialRecord read_inertial_text(const std::string& text) {
  Report report;
  return read_inertial_text(text, report);
}
std::string why_refused(const std::string& text) {
  try {
    read_inertial_text(text);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::bad_input);
    return e.what();
  }
  return {};
}

const std::string header = "time_s,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,accel_x_m_s2,accel_y_m_s2,accel_z_m_s2\n";

TEST(InertialFile, OwnFileWithMountAndNoise) {
  const auto record = read_inertial_text(
      "# unit: some\n# T_sensor_imu: 0.1 0.2 0.3 0 0 0.7071068 0.7071068\n# gyroscope_rad_s_sqrt_hz: 1e-4\n"
      "# accelerometer_m_s2_sqrt_hz: 2e-3\n# gyroscope_walk_rad_s2_sqrt_hz: 3e-6\n"
      "# accelerometer_walk_m_s3_sqrt_hz: 4e-5\n" +
      header + "10,0.1,0.2,0.3,1,2,9.5\n10.01,0.1,0.2,0.3,1,2,9.6\n");
  ASSERT_EQ(record.samples.size(), 2u);
  EXPECT_EQ(record.samples[1].time_s, 10.01);
  EXPECT_EQ(record.samples[0].angular_rate_rad_s, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(record.samples[1].specific_force_m_s2, Eigen::Vector3d(1, 2, 9.6));
  ASSERT_TRUE(record.T_sensor_imu && record.noise);
  EXPECT_NEAR((record.T_sensor_imu->linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0, 1e-6);
  EXPECT_EQ(record.T_sensor_imu->translation(), Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(record.noise->accelerometer_walk_m_s3_sqrt_hz, 4e-5);
}

TEST(InertialFile, NamesAndUnitsOfOthers) {
  const auto euroc = read_inertial_text(
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],a_RS_S_x [m s^-2],a_RS_S_y [m "
      "s^-2],a_RS_S_z [m s^-2]\n1403636579758555392,-0.1,0.2,0.3,9.0,0.1,-3.6\n1403636579763555584,-0.1,0.2,0.3,9.0,0."
      "1,-3.6\n");
  ASSERT_EQ(euroc.samples.size(), 2u);
  EXPECT_NEAR(euroc.samples[1].time_s - euroc.samples[0].time_s, 0.005, 1e-6);
  EXPECT_EQ(euroc.samples[0].angular_rate_rad_s.x(), -0.1);
  EXPECT_FALSE(euroc.T_sensor_imu || euroc.noise);

  const auto degrees = read_inertial_text(
      "Time (ms);Gyro X (deg/s);Gyro Y (deg/s);Gyro Z (deg/s);Acc X (g);Acc Y (g);Acc Z (g)\n0;90;0;0;0;0;1\n"
      "10;90;0;0;0;0;1.01\n");
  EXPECT_NEAR(degrees.samples[1].time_s, 0.01, 1e-12);
  EXPECT_NEAR(degrees.samples[1].angular_rate_rad_s.x(), 1.5707963, 1e-6);
  EXPECT_NEAR(degrees.samples[1].specific_force_m_s2.z(), 1.01 * 9.80665, 1e-9);

  const auto ros = read_inertial_text(
      "%time,field.angular_velocity.x,field.angular_velocity.y,field.angular_velocity.z,field.linear_acceleration.x,"
      "field.linear_acceleration.y,field.linear_acceleration.z\n1600000000000000000,0,0,1,0,0,9.8\n"
      "1600000000010000000,0,0,1,0,0,9.8\n");
  EXPECT_NEAR(ros.samples[0].time_s, 1.6e9, 1e-3);
}

TEST(InertialFile, WrongUnitsAreNamed) {
  EXPECT_THAT(why_refused(header + "0,0,0,0,0,0,1\n0.01,0,0,0,0,0,1.01\n"), HasSubstr("multiples of g"));
  EXPECT_THAT(why_refused(header + "0,0,0,0,0,0,1001\n0.01,0,0,0,0,0,999\n"), HasSubstr("thousandths of g"));
  EXPECT_THAT(why_refused(header + "0,0,0,0,0,0,0.1\n0.01,0,0,0,0,0,0\n"), HasSubstr("Gravity seems to be removed"));
  EXPECT_THAT(why_refused(header + "0,0,0,90,0,0,9.8\n0.01,0,0,90,0,0,9.8\n"), HasSubstr("gyro_x_deg_s"));
  EXPECT_THAT(why_refused("time_s,gyro_x,gyro_y,gyro_z\n0,0,0,0\n"), HasSubstr("three columns of specific force"));
  EXPECT_THAT(why_refused("# T_sensor_imu: 1 2 3\n" + header + "0,0,0,0,0,0,9.8\n"), HasSubstr("7 numbers"));
  EXPECT_THAT(why_refused("# T_sensor_imu: 0 0 0 1 1 0 0\n" + header + "0,0,0,0,0,0,9.8\n"), HasSubstr("quaternion"));
  EXPECT_NE(why_refused(header), "");
  EXPECT_NE(why_refused(""), "");
}

TEST(InertialFile, GapsAndBadRowsAreTold) {
  Report report;
  const auto record = read_inertial_text(
      header + "0,0,0,0,0,0,9.8\n0.01,0,0,0,0,0,\n0.02,0,0,0,0,0,9.8\n0.015,0,0,0,0,0,9.8\n2,0,0,0,0,0,9.8\n", report);
  EXPECT_EQ(record.samples.size(), 3u);
  EXPECT_EQ(report.counts.at("imu_gaps"), 1);
  EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("the longest 1.98 s")));
  EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("1 measurements are no numbers")));
  EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("1 measurements go back")));
}

TEST(InertialFile, IsFoundBesideTheScanWhereItFits) {
  const TempDir dir;
  const auto source = std::make_shared<synthetic::SyntheticScan>(
      synthetic::trunks(9, 3.5), synthetic::SpinningSensor::even(16, -25, 15, 360),
      [](double) { return Pose::Identity(); }, 5);
  const auto scan = dir / "walk.pcap";
  write_file(scan, "x");
  Report report;
  EXPECT_EQ(with_inertial_file(source, scan, "", {}, report)->inertial(), nullptr);
  write_file(dir / "imu.csv", header + "0,0,0,0,0,0,9.8\n0.3,0,0,0,0,0,9.8\n");
  const auto with = with_inertial_file(source, scan, "", {}, report);
  ASSERT_NE(with->inertial(), nullptr);
  EXPECT_EQ(with->inertial()->samples.size(), 2u);
  EXPECT_EQ(with->size(), source->size());
  EXPECT_EQ(with->rings(), 16);
  EXPECT_EQ(report.facts.at("imu"), "imu.csv");
  EXPECT_EQ(with_inertial_file(source, scan, "none", {}, report)->inertial(), nullptr);

  // Of another hour: one that was found is left out, one that was named is an error.
  write_file(dir / "imu.csv", header + "3600,0,0,0,0,0,9.8\n3600.3,0,0,0,0,0,9.8\n");
  Report other;
  EXPECT_EQ(with_inertial_file(source, scan, "", {}, other)->inertial(), nullptr);
  EXPECT_THAT(other.warnings, testing::Contains(HasSubstr("from 3600.00 to 3600.30 s")));
  EXPECT_THROW(with_inertial_file(source, scan, (dir / "imu.csv").string(), {}, other), Error);
  EXPECT_THROW(with_inertial_file(source, scan, (dir / "nothing.csv").string(), {}, other), Error);
}

}  // namespace
}  // namespace bole::io
