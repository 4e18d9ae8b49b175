// Calibrations of units (db.xml): their angles and offsets, and what they make of a range.
#include "sensor/core/velodyne_calibration.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "base/error.h"
#include "checks.h"
#include "modules/sensor/velodyne_calibration.h"
#include "sensor/core/spinning_beams.h"

namespace bole::sensor {
namespace {

using testing::HasSubstr;
using testing_checks::error_of;
using testing_velodyne::calibration_xml;
using testing_velodyne::calibration_yaml;
using testing_velodyne::UnitLaser;

constexpr double degree = std::numbers::pi / 180;

std::string error_of_xml(const std::string& xml) {
  return error_of([&] { velodyne_model_from(xml); });
}

TEST(VelodyneCalibration, GivesTheLasersOfTheUnit) {
  std::vector<UnitLaser> lasers(64);
  for (std::size_t i = 0; i < 64; ++i) lasers[i].vertical_deg = i % 2 == 0 ? -0.25 * static_cast<double>(i) : 2;
  lasers[3] = {-4.6461787, -7.2296872, 118.20465, 123.05249, 121.988, 21.569468, 2.5999999};
  const auto model = velodyne_model_from_xml(calibration_xml(lasers));
  EXPECT_EQ(model.id, "hdl64e_s2");
  ASSERT_EQ(model.channels.size(), 64U);
  const auto& laser = model.channels[3];
  EXPECT_NEAR(laser.elevation_rad, -7.2296872 * degree, 1e-12);
  EXPECT_NEAR(laser.azimuth_offset_rad, 4.6461787 * degree, 1e-12);
  EXPECT_NEAR(laser.offsets.range, 1.1820465, 1e-12);
  EXPECT_NEAR(laser.offsets.near_x, 1.2305249, 1e-12);
  EXPECT_NEAR(laser.offsets.near_y, 1.21988, 1e-12);
  EXPECT_NEAR(laser.offsets.vertical, 0.21569468, 1e-12);
  EXPECT_NEAR(laser.offsets.horizontal, 0.025999999, 1e-12);
  EXPECT_TRUE(laser.offsets.two_points);
  EXPECT_FALSE(model.channels[0].offsets.two_points);
  const auto elevations = model.ring_elevations_rad();
  EXPECT_TRUE(std::ranges::is_sorted(elevations));
}

TEST(VelodyneCalibration, TheNumberOfLasersTellsTheSensor) {
  EXPECT_EQ(velodyne_model_from_xml(calibration_xml(std::vector<UnitLaser>(16))).id, "vlp16");
  EXPECT_EQ(velodyne_model_from_xml(calibration_xml(std::vector<UnitLaser>(32), 0.4)).id, "vlp32c");
  EXPECT_EQ(velodyne_model_from_xml(calibration_xml(std::vector<UnitLaser>(32), 0.2)).id, "hdl32e");
}

// One firing of a calibrated unit at an azimuth.
VelodyneReturn shot(const std::vector<UnitLaser>& lasers, double azimuth_deg, float range_m) {
  const SpinningBeams beams(velodyne_model_from_xml(calibration_xml(lasers)));
  std::vector<VelodyneReturn> out;
  beams.append(range_m, 50, 0, {0, true, 100 * azimuth_deg, 0, 0}, 1e-4, 0, 0, 1, out);
  return out.at(0);
}

TEST(VelodyneCalibration, RangesAreCorrectedByTheDistanceAlongEachAxis) {
  std::vector<UnitLaser> lasers(64);
  lasers[0] = {0, 0, 100, 120, 130, 0, 0};  // far 1 m; near 1.2 m aside, 1.3 m ahead
  const float far_m = 25.04F - 1, near_ahead_m = 1.93F - 1, near_aside_m = 2.4F - 1;
  EXPECT_NEAR(shot(lasers, 0, far_m).position.x(), 25.04, 1e-5);
  EXPECT_NEAR(shot(lasers, 0, near_ahead_m).position.x(), 0.93 + 1.3, 1e-5);
  EXPECT_NEAR(shot(lasers, 180, near_ahead_m).position.x(), -0.93 - 1.3, 1e-5);
  EXPECT_NEAR(shot(lasers, 90, near_aside_m).position.y(), -1.4 - 1.2, 1e-5);  // clockwise: to the right
  const auto middle_m = static_cast<float>((25.04 + 1.93) / 2 - 1);
  EXPECT_NEAR(shot(lasers, 0, middle_m).position.x(), static_cast<double>(middle_m) + 1.15, 1e-5);
  EXPECT_NEAR(shot(lasers, 0, far_m).range_m, 25.04F, 1e-5F);
}

TEST(VelodyneCalibration, TheLaserStandsBesideTheCentre) {
  std::vector<UnitLaser> lasers(64);
  lasers[0] = {0, 30, 0, 0, 0, 20, 5};  // 30 deg up, 20 cm above, 5 cm to the left
  const Eigen::Vector3d ahead = shot(lasers, 0, 10).position.cast<double>();
  const double cos30 = std::sqrt(0.75), sin30 = 0.5;
  EXPECT_NEAR(ahead.x(), 10 * cos30 - 0.2 * sin30, 1e-5);
  EXPECT_NEAR(ahead.y(), 0.05, 1e-5);
  EXPECT_NEAR(ahead.z(), 10 * sin30 + 0.2 * cos30, 1e-5);
  const Eigen::Vector3d right = shot(lasers, 90, 10).position.cast<double>();
  EXPECT_NEAR(right.x(), 0.05, 1e-5);
  EXPECT_NEAR(right.y(), -(10 * cos30 - 0.2 * sin30), 1e-5);
}

TEST(VelodyneCalibration, AUnitWithoutOffsetsIsTheNominalSensor) {
  std::vector<UnitLaser> lasers(64);
  lasers[0] = {-2, 11, 0, 0, 0, 0, 0};
  const auto p = shot(lasers, 45, 20);
  EXPECT_NEAR(p.position.norm(), 20, 1e-5);
  EXPECT_EQ(p.range_m, 20);
  EXPECT_NEAR(std::atan2(-p.position.y(), p.position.x()), 47 * degree, 1e-6);
  EXPECT_NEAR(std::asin(p.position.z() / 20), 11 * degree, 1e-6);
}

TEST(VelodyneCalibration, WhatCannotBeIsRefusedInWords) {
  const std::vector<UnitLaser> lasers(64);
  const auto whole = calibration_xml(lasers);
  EXPECT_THAT(error_of([] { velodyne_model_from_xml(""); }), HasSubstr("XML"));
  EXPECT_THAT(error_of_xml("<a/>"), HasSubstr("<DB>"));
  EXPECT_THAT(error_of_xml(whole.substr(0, whole.size() / 2)), HasSubstr("XML"));
  EXPECT_THAT(error_of_xml(calibration_xml(std::vector<UnitLaser>(5))), HasSubstr("enables 5 lasers"));
  auto missing = lasers;
  missing[7].id = 70;
  EXPECT_THAT(error_of_xml(calibration_xml(missing)), HasSubstr("laser 7 is absent"));
  auto twice = lasers;
  twice[7].id = 6;
  EXPECT_THAT(error_of_xml(calibration_xml(twice)), HasSubstr("laser 6 is there twice"));
  auto steep = lasers;
  steep[1].vertical_deg = 1e9;
  EXPECT_THAT(error_of_xml(calibration_xml(steep)), HasSubstr("vertCorrection_"));
}

// XML and YAML of the same unit.
TEST(VelodyneCalibration, BothFormsGiveTheSameUnit) {
  std::vector<UnitLaser> lasers(64);
  for (std::size_t i = 0; i < 64; ++i) {
    const auto n = static_cast<double>(i);
    lasers[i] = {0.1 * n - 3, 2 - 0.4 * n, 100 + n, 101 + n, 102 + n, 20 - 0.1 * n, i % 2 == 0 ? 2.6 : -2.6};
  }
  const auto xml = velodyne_model_from(calibration_xml(lasers));
  for (const bool flow : {false, true}) {
    const auto yaml = velodyne_model_from(calibration_yaml(lasers, 0.002, flow, "two_pt_correction_available: true, "));
    EXPECT_EQ(yaml.id, xml.id);
    EXPECT_EQ(yaml.range_quantum_m, xml.range_quantum_m);
    for (std::size_t i = 0; i < 64; ++i) {
      const auto &a = yaml.channels[i], &b = xml.channels[i];
      EXPECT_NEAR(a.elevation_rad, b.elevation_rad, 1e-12);
      EXPECT_NEAR(a.azimuth_offset_rad, b.azimuth_offset_rad, 1e-12);
      EXPECT_EQ(a.ring, b.ring);
      EXPECT_NEAR(a.offsets.range, b.offsets.range, 1e-12);
      EXPECT_NEAR(a.offsets.near_x, b.offsets.near_x, 1e-12);
      EXPECT_NEAR(a.offsets.near_y, b.offsets.near_y, 1e-12);
      EXPECT_NEAR(a.offsets.vertical, b.offsets.vertical, 1e-12);
      EXPECT_NEAR(a.offsets.horizontal, b.offsets.horizontal, 1e-12);
      EXPECT_TRUE(a.offsets.two_points);
    }
    // Without the word that they are known, the two distances are not used (as in velodyne_pointcloud).
    EXPECT_FALSE(velodyne_model_from(calibration_yaml(lasers, 0.002, flow)).channels[0].offsets.two_points);
  }
}

TEST(VelodyneCalibration, TheShortestYamlHasAnglesAlone) {
  const std::string yaml =
      "# beams\n---\nnum_lasers: 16\nlasers: [{laser_id: 1, rot_correction: 1e-2, vert_correction: -0.2}";
  std::string whole = yaml;
  for (const int id : {0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15})
    whole += ", {laser_id: " + std::to_string(id) + ", rot_correction: 0, vert_correction: 0.1}";
  const auto model = velodyne_model_from(whole + "]\n");
  EXPECT_EQ(model.id, "vlp16");
  EXPECT_EQ(model.range_quantum_m, 0.002);
  EXPECT_NEAR(model.channels[1].azimuth_offset_rad, -0.01, 1e-15);
  EXPECT_NEAR(model.channels[1].elevation_rad, -0.2, 1e-15);
  EXPECT_EQ(model.channels[1].ring, 0);
}

TEST(VelodyneCalibration, AVerticalOffsetOfASmallSensorIsAHeight) {
  std::vector<UnitLaser> lasers(16);
  lasers[2].vertical_offset_cm = 0.97;
  for (const auto& text : {calibration_xml(lasers), calibration_yaml(lasers, 0.002)}) {
    const auto own = velodyne_model_from(text);
    EXPECT_NEAR(own.channels[2].offsets.height, 0.0097, 1e-12);
    EXPECT_EQ(own.channels[2].offsets.vertical, 0);
    EXPECT_EQ(own.channels[0].offsets.height, 0);
  }
  // A file whose offsets are all zero does not know them.
  const auto unknown = velodyne_model_from(calibration_xml(std::vector<UnitLaser>(16)));
  EXPECT_NEAR(unknown.channels[0].offsets.height, 0.0112, 1e-12);
  EXPECT_FALSE(has_laser_heights(without_laser_heights(unknown)));
}

TEST(VelodyneCalibration, AYamlThatCannotBeIsRefusedInWords) {
  const std::vector<UnitLaser> lasers(16);
  const auto whole = calibration_yaml(lasers, 0.002);
  const auto error_with = [&](const std::string& from, const std::string& to) {
    auto text = whole;
    text.replace(text.find(from), from.size(), to);
    return error_of_xml(text);
  };
  EXPECT_THAT(error_of_xml(""), HasSubstr("lists no lasers"));
  EXPECT_THAT(error_of_xml(whole.substr(0, whole.size() / 2)), HasSubstr("laser"));
  EXPECT_THAT(error_with("laser_id: 3", "laser_id: 4"), HasSubstr("laser 4 is there twice"));
  EXPECT_THAT(error_with("laser_id: 3", "laser_id: 300"), HasSubstr("laser 3 is absent"));
  EXPECT_THAT(error_with("laser_id: 3", "nothing: 3"), HasSubstr("no 'laser_id'"));
  EXPECT_THAT(error_with("vert_correction: 0", "vert_correction: nan"), HasSubstr("'vert_correction' is 'nan'"));
  EXPECT_THAT(error_with("rot_correction: 0", "rot_correction: 1e9"), HasSubstr("'rot_correction' is '1e9'"));
  EXPECT_THAT(error_with("num_lasers: 16", "num_lasers: 15"), HasSubstr("num_lasers is 15"));
  EXPECT_THAT(error_with("num_lasers: 16", "num_lasers: 32"), HasSubstr("laser 16 is absent"));
  EXPECT_THAT(error_of_xml(calibration_yaml(std::vector<UnitLaser>(2000), 0.002)), HasSubstr("1024"));
}

}  // namespace
}  // namespace bole::sensor
