#include "io/core/scans/ouster_capture.h"

#include <gmock/gmock.h>

#include <numbers>

#include "../sensor/ouster_packets.h"
#include "cloud/known_facts.h"
#include "io_test_tools.h"
#include "pcap_bytes.h"

namespace bole::io {
namespace {

using namespace testing_io;
using testing::HasSubstr;
namespace maker = testing_ouster;

constexpr double ouster_start_s = 1.7e9;
constexpr std::uint64_t sensor_start_ns = 278'000'000'000;  // after it was switched on

maker::Sensor small_sensor(const std::string& profile = "RNG19_RFL8_SIG16_NIR16_DUAL") {
  maker::Sensor sensor;
  sensor.profile = profile;
  for (int i = 0; i < 32; ++i) {
    sensor.elevations_deg.push_back(15.5 - i);
    sensor.azimuths_deg.push_back(-1.4);
  }
  return sensor;
}

struct Recording {
  maker::Sensor sensor = small_sensor();
  int frames = 4;
  std::uint16_t first_frame_id = 65534;
  int skip_packet = -1, drop_column = -1;
  std::size_t mtu = 65535;
  int clock_set_at = -1;  // packet from which the sensor counts UTC
  bool twice = false;     // each lidar packet
  bool with_other_sensor = false;
  int first_lost = -1, last_lost = -1;  // packets

  // 64 columns per frame, 16 per packet, 0.1 s; an inertial packet before every lidar packet.
  PcapBytes capture() const {
    PcapBytes out(mtu);
    for (int p = 0; p < 4 * frames; ++p) {
      const double time_s = ouster_start_s + 0.025 * p;
      const auto ns =
          (clock_set_at >= 0 && p >= clock_set_at ? std::uint64_t{1'700'000'000'000'000'000} : sensor_start_ns) +
          static_cast<std::uint64_t>(p) * 25'000'000;
      out.add(maker::Sensor::inertial_packet(ns + 1000, {0, 0, 1}, {0, 0, 10}), time_s, 7503);
      if (p == skip_packet || (p >= first_lost && p <= last_lost)) continue;
      std::vector<maker::Column> columns(16);
      for (int c = 0; c < 16; ++c) {
        auto& column = columns[static_cast<std::size_t>(c)];
        column.id = static_cast<std::uint16_t>(p % 4 * 16 + c);
        column.time_ns = ns + static_cast<std::uint64_t>(c) * 1'562'500;
        column.first.assign(32, {5000, 30});
        column.second.assign(32, {p % 2 == 0 ? 9000U : 0U, 20});
        column.valid = column.id != drop_column;
      }
      const auto id = static_cast<std::uint16_t>(first_frame_id + p / 4);
      out.add(sensor.packet(id, columns), time_s, 7502);
      if (twice) out.add(sensor.packet(id, columns), time_s, 7502);
      auto other = sensor;
      other.serial = 77;
      if (with_other_sensor) out.add(other.packet(static_cast<std::uint16_t>(id + 900), columns), time_s, 7502);
    }
    return out;
  }

  std::filesystem::path write(const TempDir& folder, const std::string& name = "walk") const {
    write_file(folder / (name + ".pcap"), capture().bytes());
    write_file(folder / (name + ".json"), sensor.metadata(true).dump());
    return folder / (name + ".pcap");
  }
};

std::size_t points_of(const FrameSource& source) {
  std::size_t points = 0;
  ScanFrame frame;
  for (std::size_t i = 0; i < source.size(); ++i) {
    source.read(i, frame);
    points += frame.size();
  }
  return points;
}

TEST(OusterCapture, FramesAreThoseOfTheSensorAlsoWhereItsNumbersWrap) {
  const TempDir folder;
  Report report;
  const auto source = open_frame_source(Recording().write(folder), {}, {}, report);
  EXPECT_EQ(source->size(), 4U);
  EXPECT_EQ(source->rings(), 32);
  EXPECT_EQ(source->sensor_model(), "os1_32");
  EXPECT_EQ(report.facts.at("return_mode"), "dual");
  EXPECT_EQ(report.facts.at("calibration"), "walk.json");
  EXPECT_TRUE(report.warnings.empty()) << testing::PrintToString(report.warnings);
  ScanFrame frame;
  source->read(1, frame);
  EXPECT_EQ(frame.size(), 64U * 32 + 32 * 32);
  EXPECT_EQ(std::ranges::count(frame.return_number, 2), 32 * 32);
  EXPECT_NEAR(frame.start_time_s, ouster_start_s + 0.1, 1e-6);  // its clock counts on from the recorder's first time
  EXPECT_NEAR(frame.end_time_s - frame.start_time_s, 0.1 - 0.0015625, 1e-6);
  EXPECT_TRUE(std::ranges::is_sorted(frame.time_offset_s));
  const auto reopened = open_frame_source(Recording().write(folder), {});
  EXPECT_EQ(points_of(*reopened), points_of(*source));
}

TEST(OusterCapture, TheInertialUnitComesWithTheFrames) {
  const TempDir folder;
  const auto source = open_frame_source(Recording().write(folder));
  const auto* inertial = source->inertial();
  ASSERT_NE(inertial, nullptr);
  ASSERT_EQ(inertial->samples.size(), 16U);
  EXPECT_NEAR(inertial->samples[4].time_s, ouster_start_s + 0.1 + 1e-6, 1e-6);
  EXPECT_NEAR(inertial->samples[4].specific_force_m_s2.z(), 9.80665, 1e-6);
  EXPECT_NEAR(inertial->samples[4].angular_rate_rad_s.z(), 10 * std::numbers::pi / 180, 1e-6);
  ASSERT_TRUE(inertial->T_sensor_imu);
  EXPECT_NEAR(inertial->T_sensor_imu->translation().y(), -0.011775, 1e-9);
}

TEST(OusterCapture, FragmentsAreJoined) {
  const TempDir folder;
  Recording pieces;
  pieces.mtu = 1500;
  const auto whole = open_frame_source(Recording().write(folder, "whole"));
  Report report;
  const auto joined = open_frame_source(pieces.write(folder, "pieces"), {}, {}, report);
  EXPECT_EQ(joined->size(), whole->size());
  EXPECT_EQ(points_of(*joined), points_of(*whole));
  EXPECT_TRUE(report.warnings.empty()) << testing::PrintToString(report.warnings);
}

TEST(OusterCapture, WhatIsLostIsCounted) {
  const TempDir folder;
  Recording recording;
  recording.skip_packet = 6;
  recording.drop_column = 33;
  Report report;
  const auto source = open_frame_source(recording.write(folder), {}, {}, report);
  EXPECT_EQ(source->size(), 4U);
  EXPECT_EQ(report.counts.at("lost_packets"), 1);
  EXPECT_EQ(report.counts.at("incomplete_frames"), 1);
  ScanFrame frame;
  source->read(0, frame);
  EXPECT_EQ(frame.size(), 63U * 32 + 31 * 32);
}

TEST(OusterCapture, ACutCaptureGivesTheFramesBeforeTheCut) {
  const TempDir folder;
  const auto path = Recording().write(folder);
  auto bytes = file_text(path);
  write_file(path, bytes.substr(0, bytes.size() * 6 / 10));
  Report report;
  const auto source = open_frame_source(path, {}, {}, report);
  EXPECT_EQ(source->size(), 2U);
  ASSERT_FALSE(report.findings.empty());
  EXPECT_THAT(report.findings.front().text, HasSubstr("cut off or damaged"));
  // A length that the file does not hold.
  bytes[24 + 8] = '\xFF';
  bytes[24 + 9] = '\xFF';
  write_file(path, bytes);
  EXPECT_THAT(error_of([&] { open_frame_source(path); }), testing::Not(HasSubstr("no error")));
}

TEST(OusterCapture, TheJsonFileIsFoundOrAskedFor) {
  const TempDir folder;
  const auto path = Recording().write(folder);
  std::filesystem::rename(folder / "walk.json", folder / "sensor.json");
  EXPECT_EQ(open_frame_source(path)->size(), 4U);  // the only one
  write_file(folder / "other.json", small_sensor("LEGACY").metadata(false).dump());
  EXPECT_EQ(open_frame_source(path)->size(), 4U);  // the only one with such packets
  auto twin = small_sensor();
  twin.serial = 5;
  write_file(folder / "twin.json", twin.metadata(true).dump());
  Report report;
  EXPECT_EQ(open_frame_source(path, {}, {}, report)->size(), 4U);  // the serial number decides
  EXPECT_EQ(report.facts.at("calibration"), "sensor.json");
  std::filesystem::remove(folder / "sensor.json");
  open_frame_source(path, {}, {}, report);
  ASSERT_FALSE(report.findings.empty());
  EXPECT_EQ(report.findings.front().code, "calibration_of_another_sensor");
  twin.serial = 6;
  write_file(folder / "second.json", twin.metadata(true).dump());
  EXPECT_THAT(error_of([&] { open_frame_source(path); }), HasSubstr("'second.json', 'twin.json'"));
  FrameSourceOptions named;
  named.sensor = (folder / "twin.json").string();
  EXPECT_EQ(open_frame_source(path, named)->size(), 4U);
  named.sensor = (folder / "other.json").string();
  EXPECT_THAT(error_of([&] { open_frame_source(path, named); }), HasSubstr("Is it the JSON file"));
  named.sensor = "os1_32";
  EXPECT_THAT(error_of([&] { open_frame_source(path, named); }), HasSubstr("the JSON file of the sensor"));
  for (const char* name : {"twin.json", "second.json", "other.json"}) std::filesystem::remove(folder / name);
  EXPECT_THAT(error_of([&] { open_frame_source(path); }), HasSubstr("there is no Ouster JSON file beside"));
}

TEST(OusterCapture, PacketsAsLongAsThoseOfTheInertialUnitAreNone) {
  const TempDir folder;
  const Recording recording;
  auto capture = recording.capture();
  for (int i = 0; i < 5; ++i) capture.add(std::string(48, static_cast<char>(35 + i)), ouster_start_s, 123);  // NTP
  capture.add(maker::Sensor::inertial_packet(sensor_start_ns + 1'000'000'000'000, {0, 0, 1}, {0, 0, 10}),
              ouster_start_s, 7503);
  const auto path = recording.write(folder);
  write_file(path, capture.bytes());
  Report report;
  const auto source = open_frame_source(path, {}, {}, report);
  ASSERT_NE(source->inertial(), nullptr);
  EXPECT_EQ(source->inertial()->samples.size(), 16U);
  EXPECT_EQ(report.counts.at("inertial_packets"), 16);
  EXPECT_EQ(report.counts.at("other_packets"), 6);
}

TEST(OusterCapture, LostRevolutionsAndDoubledPacketsAreCounted) {
  const TempDir folder;
  Recording recording;
  recording.frames = 10;
  recording.first_lost = 16;  // frames 4 to 6
  recording.last_lost = 27;
  recording.twice = true;
  recording.skip_packet = 6;
  Report report;
  const auto source = open_frame_source(recording.write(folder), {}, {}, report);
  EXPECT_EQ(source->size(), 7U);
  EXPECT_EQ(report.counts.at("lost_revolutions"), 3);
  EXPECT_EQ(report.counts.at("lost_packets"), 13);
  EXPECT_EQ(report.counts.at("duplicate_packets"), 27);
  EXPECT_EQ(report.counts.at("incomplete_frames"), 1);
}

TEST(OusterCapture, AClockThatIsSetDoesNotMoveTheTimes) {
  const TempDir folder;
  Recording recording;
  recording.frames = 6;
  recording.clock_set_at = 12;
  Report report;
  const auto source = open_frame_source(recording.write(folder), {}, {}, report);
  ASSERT_EQ(source->size(), 6U);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(source->frame_time_s(k), ouster_start_s + 0.1 * static_cast<double>(k), 1e-5) << k;
  EXPECT_EQ(report.counts.at("clock_jumps"), 1);
  ASSERT_EQ(source->inertial()->samples.size(), 24U);
  EXPECT_NEAR(source->inertial()->samples[12].time_s, ouster_start_s + 0.3 + 1e-6, 1e-5);
  EXPECT_THAT(report.findings, testing::Contains(testing::Field(&Finding::code, "clock_jumped")));
}

TEST(OusterCapture, PacketsOfASecondSensorAreLeftOut) {
  const TempDir folder;
  Recording recording;
  recording.with_other_sensor = true;
  Report report;
  const auto source = open_frame_source(recording.write(folder), {}, {}, report);
  EXPECT_EQ(source->size(), 4U);
  EXPECT_EQ(points_of(*source), points_of(*open_frame_source(Recording().write(folder, "alone"))));
  EXPECT_THAT(report.warnings, testing::Contains(HasSubstr("16 packets of a second sensor")));
}

TEST(OusterCapture, AJsonFileThatIsNotReadableDoesNotBlockTheOthers) {
  const TempDir folder;
  const auto path = Recording().write(folder);
  std::filesystem::rename(folder / "walk.json", folder / "sensor.json");
  write_file(folder / "a_later.json", small_sensor("SOME_LATER_PROFILE").metadata(true).dump());
  EXPECT_EQ(open_frame_source(path)->size(), 4U);
  std::filesystem::remove(folder / "sensor.json");
  EXPECT_THAT(error_of([&] { open_frame_source(path); }), HasSubstr("a_later.json"));
}

// The numbers of points are those of ouster-sdk 1.0 (tests/bench/peers/ouster_against_sdk.py compares every point).
TEST(OusterCapture, RealCaptures) {
  BOLE_NEEDS_SHARED("OUSTER_pcaps");
  struct Expected {
    std::string file, calibration, sensor;
    std::size_t frames, points, inertial;
  };
  const std::vector<Expected> all{
      {"OS-1-64_1024x10_fw20.pcap", "OS-1-64_sensor_config_reduced.json", "os1_64", 1, 16749, 11},
      {"OS-1-128_v2.3.0_1024x10_lb_n3.pcap", "OS-1-128_v2.3.0_1024x10.json", "os1_128", 3, 322536, 30},
      {"OS-1-32-G_v2.1.1_1024x10.pcap", "OS-1-32-G_v2.1.1_1024x10.json", "os1_32", 1, 27310, 0}};
  for (const auto& e : all) {
    FrameSourceOptions options;
    options.min_range = 0;
    options.max_range = 1000;
    Report report;
    const auto source = open_frame_source(shared("OUSTER_pcaps/" + e.file), options, {}, report);
    EXPECT_EQ(source->size(), e.frames) << e.file;
    EXPECT_EQ(points_of(*source), e.points) << e.file;
    EXPECT_EQ(source->sensor_model(), e.sensor) << e.file;
    EXPECT_EQ(report.facts.at("calibration"), e.calibration) << e.file;
    EXPECT_EQ(source->inertial() == nullptr ? 0 : source->inertial()->samples.size(), e.inertial) << e.file;
  }
}

}  // namespace
}  // namespace bole::io
