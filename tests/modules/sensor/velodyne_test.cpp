#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "base/error.h"
#include "sensor/core/velodyne_decoder.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::sensor {
namespace {

constexpr double start_time_s = 1.7e9 + 3599.9995;  // the hour rolls over within the first packets
constexpr double rate_rad_s = 2 * std::numbers::pi * 10;

struct Shot {
  double azimuth_rad, range_m, time_s;
  int intensity;
};

// A made-up room whose range depends on the direction; every laser fires at its own azimuth.
struct Recording {
  std::map<std::pair<int, int>, Shot> shots;  // by (sequence, channel)
  std::vector<std::pair<VelodynePacket, double>> packets;
};

Recording record(const SensorModel& model, VelodyneReturnMode mode, int sequences, double start_azimuth_rad = 6.2) {
  Recording out;
  VelodyneEncoder encoder(model, mode, [&](const VelodyneEncoder::Bytes& bytes, double time_s) {
    out.packets.emplace_back(*parse_velodyne_packet(bytes), time_s);
  });
  std::mt19937 random(7);
  std::uniform_real_distribution<double> range(1, 60);
  for (int s = 0; s < sequences; ++s) {
    const double time_s = start_time_s + s * model.sequence_period_s;
    const double azimuth_rad = start_azimuth_rad + rate_rad_s * (time_s - start_time_s);
    std::vector<LaserEcho> strongest, last;
    for (int c = 0; c < model.rings(); ++c) {
      const auto& channel = model.channels[static_cast<std::size_t>(c)];
      const double r = range(random);
      strongest.push_back({static_cast<float>(r), static_cast<std::uint8_t>(c)});
      last.push_back({static_cast<float>(c % 2 == 0 ? r : r + 1), 9});  // even channels: the same return again
      out.shots[{s, c}] = {azimuth_rad + rate_rad_s * channel.firing_time_s + channel.azimuth_offset_rad, r,
                           time_s + channel.firing_time_s, c};
    }
    encoder.add(time_s, azimuth_rad, strongest, last);
  }
  encoder.flush();
  return out;
}

void expect_round_trip(const std::string& name) {
  SCOPED_TRACE(name);
  const auto model = load_sensor_model(name);
  const VelodyneDecoder decoder(model);
  const int sequences = 12 * 4;
  const auto recording = record(model, VelodyneReturnMode::strongest, sequences);
  std::size_t seen = 0;
  for (const auto& [packet, time_s] : recording.packets) {
    std::vector<VelodyneReturn> returns;
    decoder.decode(packet, returns);
    const double past_hour = std::fmod(time_s, 3600);
    EXPECT_NEAR(packet.time_us * 1e-6, past_hour, 1.1e-6);
    const int first_sequence = static_cast<int>(std::lround((time_s - start_time_s) / model.sequence_period_s));
    for (const auto& r : returns) {
      const double since = r.time_offset_s - model.channels[r.channel].firing_time_s;
      const int sequence = first_sequence + static_cast<int>(std::lround(since / model.sequence_period_s));
      const auto& shot = recording.shots.at({sequence, r.channel});
      ++seen;
      EXPECT_NEAR(r.range_m, shot.range_m, model.range_quantum_m / 2 + 1e-5);
      EXPECT_EQ(r.intensity, shot.intensity);
      EXPECT_EQ(r.ring, model.channels[r.channel].ring);
      EXPECT_NEAR(time_s + r.time_offset_s, shot.time_s, 1e-6);
      const double azimuth = std::atan2(-r.position.y(), r.position.x());
      // Half a quantum of the block's azimuth, and as much for the next block's at the interpolated end.
      EXPECT_NEAR(std::remainder(azimuth - shot.azimuth_rad, 2 * std::numbers::pi), 0, 0.011 * std::numbers::pi / 180);
      const auto& laser = model.channels[r.channel];
      const Eigen::Vector3d ray = r.position.cast<double>() - Eigen::Vector3d(0, 0, laser.offsets.height);
      EXPECT_NEAR(std::asin(ray.z() / ray.norm()), laser.elevation_rad, 1e-6);
    }
  }
  EXPECT_EQ(seen, recording.shots.size());
}

TEST(Velodyne, WhatIsEncodedIsDecodedWithinQuantisation) {
  for (const char* name : {"vlp16", "vlp32c", "hdl32e", "hdl64e_s2", "vls128"}) expect_round_trip(name);
}

TEST(Velodyne, DualReturnsComeStrongestFirstAndDuplicatesOnce) {
  for (const char* name : {"vlp16", "vlp32c", "vls128"}) {
    const auto model = load_sensor_model(name);
    const VelodyneDecoder decoder(model);
    const auto recording = record(model, VelodyneReturnMode::dual, 24);
    std::size_t strongest = 0, last = 0;
    for (const auto& [packet, time_s] : recording.packets) {
      std::vector<VelodyneReturn> returns;
      decoder.decode(packet, returns);
      for (std::size_t i = 0; i < returns.size(); ++i) {
        const auto& r = returns[i];
        if (r.return_number == 1) {
          ++strongest;
          EXPECT_EQ(r.intensity, r.channel);
        } else {
          ++last;
          EXPECT_EQ(r.channel % 2, 1);
          EXPECT_EQ(returns[i - 1].channel, r.channel);
          EXPECT_NEAR(r.range_m, returns[i - 1].range_m + 1, 0.005);
        }
      }
    }
    EXPECT_EQ(strongest, recording.shots.size());
    EXPECT_EQ(last, recording.shots.size() / 2);
  }
}

TEST(Velodyne, SensorsAreRecognisedByTheirPackets) {
  for (const char* name : {"vlp16", "vlp32c", "hdl32e", "hdl64e_s2", "vls128"}) {
    const auto recording = record(load_sensor_model(name), VelodyneReturnMode::strongest, 24);
    const auto model = recognise_velodyne(recording.packets.front().first);
    ASSERT_TRUE(model) << name;
    EXPECT_EQ(model->id, name);
  }
  VelodynePacket unknown;
  unknown.product_id = 0x77;
  EXPECT_FALSE(recognise_velodyne(unknown));
}

TEST(Velodyne, AxesAreForwardLeftUp) {
  const auto model = load_sensor_model("hdl32e");
  VelodynePacket packet;
  packet.blocks[0].azimuth_centideg = 9000;  // to the right
  packet.blocks[0].records[15] = {5000, 1};  // laser 15 is level
  std::vector<VelodyneReturn> returns;
  VelodyneDecoder(model).decode(packet, returns);
  ASSERT_EQ(returns.size(), 1U);
  EXPECT_NEAR(returns[0].position.x(), 0, 1e-3);
  EXPECT_NEAR(returns[0].position.y(), -10, 1e-3);
  EXPECT_NEAR(returns[0].position.z(), 0, 1e-3);
}

TEST(Velodyne, DamagedBlocksAreLeftOutAndDoNotBendTheirNeighbours) {
  const auto model = load_sensor_model("vlp32c");
  auto packet = record(model, VelodyneReturnMode::strongest, 12).packets.front().first;
  packet.blocks[5].azimuth_centideg = 40000;
  packet.blocks[8].flag = 0x1234;
  packet.blocks[10].azimuth_centideg = static_cast<std::uint16_t>((packet.blocks[9].azimuth_centideg + 9000) % 36000);
  const VelodyneDecoder decoder(model);
  const auto firings = decoder.firings(packet);
  for (const auto& f : firings) {
    if (f.valid) {
      EXPECT_NEAR(f.advance_centideg, 19.9, 1.5);
    }
  }
  std::vector<VelodyneReturn> returns;
  decoder.decode(packet, returns);
  EXPECT_EQ(returns.size(), 10U * 32);
}

TEST(Velodyne, OtherPayloadsAreRefused) {
  EXPECT_FALSE(parse_velodyne_packet(std::vector<std::uint8_t>(554)));
  EXPECT_FALSE(parse_velodyne_packet(std::vector<std::uint8_t>(velodyne_packet_bytes)));  // no block flag
  EXPECT_THROW(VelodyneDecoder(load_sensor_model("os1_64")), Error);
  EXPECT_THROW(VelodyneEncoder(load_sensor_model("hdl64e_s2"), VelodyneReturnMode::dual, {}), Error);
}

}  // namespace
}  // namespace bole::sensor
