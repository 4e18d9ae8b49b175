// What the encoders of the simulator write comes back through the readers: every range, place, time and return.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "io/core/scans/frame_source.h"
#include "io_test_tools.h"
#include "sensor/core/hesai_encoder.h"
#include "sensor/core/ouster_encoder.h"
#include "sensor/core/pcap_writer.h"

namespace bole::io {
namespace {

using namespace testing_io;

constexpr double encoder_start_s = 1.7e9 + 2799.95;  // an hour ends in the first turn
constexpr double turn_rad_s = 20 * std::numbers::pi;

struct Pulse {
  sensor::LaserEcho first, second;
  Eigen::Vector3d ray = Eigen::Vector3d::Zero();
  double time_s = 0;
};

// Three turns from behind the sensor on; one pulse of a laser in ten has no return, half have two.
template <class Encoder>
std::vector<Pulse> record(const sensor::SensorModel& model, Encoder& encoder) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> range(1, 90);
  std::vector<Pulse> pulses;
  const auto sequences = static_cast<int>(std::lround(0.3 / model.sequence_period_s));
  for (int s = 0; s < sequences; ++s) {
    const double since_s = s * model.sequence_period_s, azimuth_rad = std::numbers::pi + turn_rad_s * since_s;
    std::vector<sensor::LaserEcho> first, second;
    for (const auto& laser : model.channels) {
      Pulse pulse;
      pulse.first = {range(random), static_cast<std::uint8_t>(random() % 100)};
      const bool alone = random() % 2 == 0;
      pulse.second = alone ? pulse.first : sensor::LaserEcho{range(random), static_cast<std::uint8_t>(random() % 100)};
      if (random() % 10 == 0) pulse.first = pulse.second = {};
      const double a = azimuth_rad + turn_rad_s * laser.firing_time_s + laser.azimuth_offset_rad,
                   flat = std::cos(laser.elevation_rad);
      pulse.ray = {flat * std::cos(a), -flat * std::sin(a), std::sin(laser.elevation_rad)};
      pulse.time_s = encoder_start_s + since_s + laser.firing_time_s;
      first.push_back(pulse.first);
      second.push_back(pulse.second);
      pulses.push_back(pulse);
    }
    encoder.add(encoder_start_s + since_s, azimuth_rad, first, second);
  }
  encoder.flush();
  return pulses;
}

struct Tolerance {
  double range_m, angle_rad, time_s;
};

// Each point has its pulse: the nearest in time among those with its range.
void expect_pulses(const FrameSource& source, const std::vector<Pulse>& pulses, const Tolerance& tolerance) {
  std::multimap<double, std::pair<const Pulse*, int>> by_range;
  std::size_t echoes = 0;
  for (const auto& p : pulses) {
    if (p.first.range_m > 0) by_range.emplace(p.first.range_m, std::pair{&p, 1});
    const bool two = p.second.range_m > 0 && p.second.range_m != p.first.range_m;
    if (two) by_range.emplace(p.second.range_m, std::pair{&p, 2});
    echoes += (p.first.range_m > 0) + two;
  }
  std::size_t points = 0, wrong = 0;
  ScanFrame frame;
  for (std::size_t k = 0; k < source.size(); ++k) {
    source.read(k, frame);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const Eigen::Vector3d at = frame.positions[i].cast<double>();
      const double time_s = frame.start_time_s + static_cast<double>(frame.time_offset_s[i]);
      bool found = false;
      for (auto p = by_range.lower_bound(at.norm() - tolerance.range_m);
           p != by_range.end() && p->first <= at.norm() + tolerance.range_m && !found; ++p) {
        const auto& [pulse, number] = p->second;
        const auto& echo = number == 1 ? pulse->first : pulse->second;
        found = std::abs(pulse->time_s - time_s) < tolerance.time_s && number == frame.return_number[i] &&
                (at.normalized() - pulse->ray).norm() < tolerance.angle_rad &&
                echo.intensity == static_cast<std::uint8_t>(frame.intensity[i]);
      }
      wrong += !found;
      ++points;
    }
  }
  EXPECT_EQ(wrong, 0U);
  // Each range that is rounded to the other one of its pulse is a return less.
  EXPECT_NEAR(static_cast<double>(points), static_cast<double>(echoes), 0.001 * static_cast<double>(echoes));
}

FrameSourceOptions everything() {
  FrameSourceOptions options;
  options.keep_partial_frames = true;
  options.min_range = 0.1;
  return options;
}

TEST(PacketEncoder, OusterPacketsComeBackWithBothReturns) {
  for (const char* name : {"os0_32", "os1_128"}) {
    SCOPED_TRACE(name);
    const TempDir dir;
    const auto model = sensor::load_sensor_model(name);
    sensor::PcapWriter pcap(dir / "walk.pcap", sensor::OusterEncoder::lidar_port);  // in fragments
    sensor::OusterEncoder encoder(
        model, 10, true, [&](std::span<const std::uint8_t> packet, double time_s) { pcap.write(packet, time_s); });
    const auto pulses = record(model, encoder);
    pcap.close();
    write_file(dir / "walk.json", encoder.metadata());
    Report report;
    const auto source = open_frame_source(dir / "walk.pcap", everything(), {}, report);
    EXPECT_TRUE(report.warnings.empty()) << testing::PrintToString(report.warnings);
    EXPECT_TRUE(report.findings.empty());
    EXPECT_EQ(source->sensor_model(), name);
    EXPECT_EQ(source->size(), 3U);
    expect_pulses(*source, pulses, {0.0006, 1e-6, 1e-6});
  }
}

TEST(PacketEncoder, OusterPacketsOfOneReturnHaveTheSingleProfile) {
  const TempDir dir;
  const auto model = sensor::load_sensor_model("os1_32");
  sensor::PcapWriter pcap(dir / "walk.pcap", sensor::OusterEncoder::lidar_port);
  sensor::OusterEncoder encoder(
      model, 10, false, [&](std::span<const std::uint8_t> packet, double time_s) { pcap.write(packet, time_s); });
  auto pulses = record(model, encoder);
  for (auto& p : pulses) p.second = p.first;
  pcap.close();
  write_file(dir / "walk.json", encoder.metadata());
  expect_pulses(*open_frame_source(dir / "walk.pcap", everything()), pulses, {0.0006, 1e-6, 1e-6});
  EXPECT_THROW(sensor::OusterEncoder(model, 7, true, {}), Error);  // no whole number of columns
  EXPECT_THROW(sensor::OusterEncoder(sensor::load_sensor_model("vlp16"), 10, true, {}), Error);
}

TEST(PacketEncoder, HesaiPacketsComeBackWithBothReturns) {
  for (const char* name : {"pandar_xt32", "pandar40p"}) {
    SCOPED_TRACE(name);
    const TempDir dir;
    const auto model = sensor::load_sensor_model(name);
    sensor::PcapWriter pcap(dir / "walk.pcap");
    sensor::HesaiEncoder encoder(
        model, 10, true, [&](std::span<const std::uint8_t> packet, double time_s) { pcap.write(packet, time_s); });
    const auto pulses = record(model, encoder);
    pcap.close();
    write_file(dir / "walk.csv", encoder.correction());
    Report report;
    const auto source = open_frame_source(dir / "walk.pcap", everything(), {}, report);
    EXPECT_TRUE(report.warnings.empty()) << testing::PrintToString(report.warnings);
    EXPECT_EQ(report.facts.at("return_mode"), "dual");
    EXPECT_EQ(report.facts.at("calibration"), "walk.csv");
    EXPECT_EQ(source->sensor_model(), name);
    // Azimuths are rounded to 0.01 degrees at both ends of the interpolation, stamps to a microsecond.
    expect_pulses(*source, pulses, {0.0021, 0.015 * std::numbers::pi / 180, 3e-6});
  }
  EXPECT_THROW(sensor::HesaiEncoder(sensor::load_sensor_model("os1_32"), 10, true, {}), Error);
}

}  // namespace
}  // namespace bole::io
