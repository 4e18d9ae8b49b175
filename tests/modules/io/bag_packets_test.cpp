#include "io/core/bags/bag_source.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "../sensor/ouster_packets.h"
#include "bag_sweeps.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/scans/velodyne_pcap.h"
#include "pcap_bytes.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::Contains;
using testing::HasSubstr;

TEST(BagSource, VelodynePacketsGiveTheFramesOfACapture) {
  const TempDir dir;
  const auto model = sensor::load_sensor_model("vlp16");
  sensor::PcapWriter capture(dir / "walk.pcap");
  std::vector<Message> messages;
  std::vector<std::pair<std::int64_t, std::string>> packets;
  sensor::VelodyneEncoder encoder(
      model, sensor::VelodyneReturnMode::strongest, [&](const sensor::VelodyneEncoder::Bytes& bytes, double time_s) {
        const auto ns = static_cast<std::int64_t>(std::llround(time_s * 1e6)) * 1000;
        capture.write(bytes, time_s);
        packets.emplace_back(ns, std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
        if (packets.size() < 76) return;
        messages.push_back({"/velodyne_packets", "velodyne_msgs/msg/VelodyneScan", ns,
                            velodyne_message(Wire::cdr_little, packets.front().first, packets)});
        packets.clear();
      });
  const std::vector<sensor::LaserEcho> echoes(model.channels.size(), {10.F, 50});
  for (int s = 0; s < 18084; ++s)
    encoder.add(1.7e9 + s * model.sequence_period_s, 20 * std::numbers::pi * s * model.sequence_period_s, echoes, {});
  capture.close();
  messages.push_back({"/velodyne_packets", "velodyne_msgs/msg/VelodyneScan", start_ns + 2'000'000'000,
                      velodyne_message(Wire::cdr_little, start_ns, packets)});
  messages.push_back({"/velodyne_packets", "velodyne_msgs/msg/VelodyneScan", start_ns + 2'000'000'001, "cut"});
  Report report;
  const auto source = open_messages(messages, Wire::cdr_little, report);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("1 messages of packets cannot be read")));
  const auto same = open_frame_source(dir / "walk.pcap");
  EXPECT_EQ(source->sensor_model(), "vlp16");
  ASSERT_GE(source->size(), 8U);
  ASSERT_EQ(source->size(), same->size());
  ScanFrame a, b;
  for (std::size_t k = source->size(); k-- > 0;) {
    source->read(k, a);
    same->read(k, b);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.time_offset_s, b.time_offset_s);
    EXPECT_EQ(a.ring, b.ring);
    EXPECT_NEAR(a.start_time_s, b.start_time_s, 1e-6);
  }
}

double signed_azimuth_deg(const Eigen::Vector3f& p) { return std::atan2(-p.y(), p.x()) * 180 / std::numbers::pi; }

struct Difference {
  std::size_t unmatched = 0, same = 0, still = 0, next = 0, other = 0;
};

// Points of another decoder beside ours: the same laser, range and height (to 3 um). That decoder rounds azimuths to
// 0.01 degrees. In the last firing of a packet its rotor does not turn, and most second returns get the azimuth at
// which the next firing starts.
Difference compare_decoders(const std::vector<ScanFrame>& ours, const std::vector<Eigen::Vector3f>& truth,
                            const sensor::SensorModel& model) {
  struct Ours {
    float range, z;
    double azimuth;
    std::uint16_t ring;
  };
  std::vector<Ours> points;
  for (const auto& frame : ours)
    for (std::size_t i = 0; i < frame.size(); ++i)
      points.push_back(
          {frame.positions[i].norm(), frame.positions[i].z(), signed_azimuth_deg(frame.positions[i]), frame.ring[i]});
  std::ranges::sort(points, {}, &Ours::range);
  std::vector<double> firing_time_s(model.channels.size());
  for (const auto& c : model.channels) firing_time_s[static_cast<std::size_t>(c.ring)] = c.firing_time_s;
  Difference out;
  for (const auto& p : truth) {
    constexpr float near = 3e-6F;
    constexpr double grid_deg = 0.0085, rate_deg_s = 3600;
    bool matched = false, same = false, still = false, next = false;
    for (auto q = std::ranges::lower_bound(points, p.norm() - near, {}, &Ours::range);
         q != points.end() && q->range <= p.norm() + near; ++q) {
      if (std::abs(q->z - p.z()) > near) continue;
      const double ahead = std::remainder(signed_azimuth_deg(p) - q->azimuth, 360);
      matched = true;
      same = same || std::abs(ahead) < grid_deg;
      for (int k = 0; k < model.sequences_per_block; ++k) {
        const double since_start_deg = rate_deg_s * (firing_time_s[q->ring] + k * model.sequence_period_s);
        const double firing_deg = rate_deg_s * model.sequences_per_block * model.sequence_period_s;
        still = still || std::abs(ahead + since_start_deg) < grid_deg;
        next = next || std::abs(ahead + since_start_deg - firing_deg) < grid_deg;
      }
    }
    ++(!matched ? out.unmatched : same ? out.same : still ? out.still : next ? out.next : out.other);
  }
  return out;
}

TEST(BagSource, AgreesWithAnotherDecoderOnARealVlp16) {
  BOLE_NEEDS_SHARED("NEBULA_velodyne");
  FrameSourceOptions options;
  options.keep_partial_frames = true;
  options.min_range = 0.1;
  options.laser_heights = false;  // the other decoder takes them from its calibration, where they are zero
  const auto source = open_frame_source(shared("NEBULA_velodyne/vlp16/1673400471837873222"), options);
  EXPECT_EQ(source->sensor_model(), "vlp16");
  ASSERT_EQ(source->size(), 5U);
  std::vector<ScanFrame> frames(source->size());
  for (std::size_t i = 0; i < frames.size(); ++i) source->read(i, frames[i]);
  const auto truth = read_cloud(shared("NEBULA_velodyne/vlp16/1673400472138016708.pcd")).cloud;
  ASSERT_EQ(truth.size(), 14831U);
  const auto found = compare_decoders(frames, truth.positions(), sensor::load_sensor_model("vlp16"));
  EXPECT_EQ(found.unmatched, 0U);
  // Two returns: a packet has six firings, the last of which does not turn in the other decoder.
  EXPECT_GT(found.same, truth.size() * 5 / 6 - truth.size() / 50);
  EXPECT_LT(found.next, 99U + 89U);  // there are that many
  EXPECT_LT(found.other, truth.size() / 1000);
}

TEST(BagSource, TheHeightsOfTheLasersMoveARealVlp16) {
  BOLE_NEEDS_SHARED("NEBULA_velodyne");
  const auto folder = shared("NEBULA_velodyne/vlp16/1673400471837873222");
  FrameSourceOptions without;
  without.laser_heights = false;
  const auto a = open_frame_source(folder), b = open_frame_source(folder, without);
  const auto model = sensor::load_sensor_model("vlp16");
  ScanFrame ours, plain;
  a->read(0, ours);
  b->read(0, plain);
  ASSERT_EQ(ours.size(), plain.size());
  ASSERT_GT(ours.size(), 10'000U);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const auto laser = std::ranges::find(model.channels, ours.ring[i], &sensor::LaserChannel::ring);
    const Eigen::Vector3d moved = (ours.positions[i] - plain.positions[i]).cast<double>();
    EXPECT_LT((moved - Eigen::Vector3d(0, 0, laser->offsets.height)).norm(), 1e-5);
  }
}

// The calibration that Nebula has for its VLP-32C is the table of the manual.
TEST(BagSource, TheYamlOfNebulaIsTheNominalVlp32c) {
  BOLE_NEEDS_SHARED("NEBULA_velodyne");
  const auto own = sensor::load_sensor_model(shared("NEBULA_velodyne/VLP32.yaml").string());
  const auto nominal = sensor::load_sensor_model("vlp32c");
  ASSERT_EQ(own.channels.size(), nominal.channels.size());
  for (std::size_t i = 0; i < own.channels.size(); ++i) {
    EXPECT_NEAR(own.channels[i].elevation_rad, nominal.channels[i].elevation_rad, 1e-6);
    EXPECT_NEAR(own.channels[i].azimuth_offset_rad, nominal.channels[i].azimuth_offset_rad, 1e-6);
    EXPECT_EQ(own.channels[i].ring, nominal.channels[i].ring);
  }
  EXPECT_EQ(sensor::load_sensor_model(shared("VELODYNE_pcaps/HDL-32E_calibration.yml").string()).id, "hdl32e");
}

TEST(BagSource, AFileOfARealVlp32cIsItsFolder) {
  BOLE_NEEDS_SHARED("NEBULA_velodyne");
  const auto folder = shared("NEBULA_velodyne/vlp32/1713492677464078412");
  const auto a = open_frame_source(folder), b = open_frame_source(folder / "1713492677464078412_0.db3");
  EXPECT_EQ(a->sensor_model(), "vlp32c");
  ASSERT_EQ(a->size(), 5U);
  ASSERT_EQ(b->size(), a->size());
  ScanFrame one, other;
  std::size_t points = 0;
  for (std::size_t i = 0; i < a->size(); ++i) {
    a->read(i, one);
    b->read(i, other);
    EXPECT_EQ(one.positions, other.positions);
    points += one.size();
  }
  EXPECT_GT(points, 130'000U);
}

std::string packet_message(Wire wire, const std::string& packet, bool older_driver) {
  return MessageWriter(wire).blob(packet + (older_driver ? std::string(1, 'z') : "")).bytes();
}

TEST(BagSource, OusterPacketsGiveTheFramesOfACapture) {
  testing_ouster::Sensor sensor;
  for (int line = 0; line < 32; ++line) {
    sensor.elevations_deg.push_back(15 - line);
    sensor.azimuths_deg.push_back(line % 2);
  }
  for (const bool older_driver : {false, true}) {
    const auto wire = older_driver ? Wire::ros1 : Wire::cdr_little;
    const std::string type = older_driver ? "ouster_ros/PacketMsg" : "ouster_sensor_msgs/msg/PacketMsg";
    const TempDir dir;
    PcapBytes capture;
    std::vector<Message> messages{{"/ouster/metadata", "std_msgs/msg/String", start_ns,
                                   MessageWriter(wire).text(sensor.metadata(true).dump()).bytes()}};
    for (int p = 0; p < 20; ++p) {
      std::vector<testing_ouster::Column> fired(16);
      for (int c = 0; c < 16; ++c) {
        auto& column = fired[static_cast<std::size_t>(c)];
        column.id = static_cast<std::uint16_t>(p % 4 * 16 + c);
        column.time_ns = static_cast<std::uint64_t>(start_ns) + 1'500'000U * static_cast<std::uint64_t>(p * 16 + c);
        column.first.assign(32, {static_cast<std::uint32_t>(4000 + p), 7});
        column.second.assign(32, {static_cast<std::uint32_t>(5000 + c), 9});
      }
      const auto time_ns = start_ns + 24'000'000LL * p;
      const auto imu =
          testing_ouster::Sensor::inertial_packet(static_cast<std::uint64_t>(time_ns), {0, 0, 1}, {1, 2, 3});
      const auto lidar = sensor.packet(static_cast<std::uint16_t>(p / 4), fired);
      capture.add(imu, 1e-9 * static_cast<double>(time_ns), 7503);
      capture.add(lidar, 1e-9 * static_cast<double>(time_ns), 7502);
      messages.push_back({"/ouster/imu_packets", type, time_ns, packet_message(wire, imu, older_driver)});
      messages.push_back({"/ouster/lidar_packets", type, time_ns, packet_message(wire, lidar, older_driver)});
    }
    write_file(dir / "walk.pcap", capture.bytes());
    write_file(dir / "walk.json", sensor.metadata(true).dump());
    const auto same = open_frame_source(dir / "walk.pcap");
    Report report;
    const auto source = open_messages(messages, wire, report);
    EXPECT_EQ(report.facts.at("calibration"), "topic /ouster/metadata");
    EXPECT_EQ(source->sensor_model(), same->sensor_model());
    ASSERT_EQ(source->size(), 5U);
    ASSERT_EQ(same->size(), 5U);
    ScanFrame a, b;
    for (std::size_t k = source->size(); k-- > 0;) {
      source->read(k, a);
      same->read(k, b);
      EXPECT_EQ(a.size(), 2U * 32 * 64);
      EXPECT_EQ(a.positions, b.positions);
      EXPECT_EQ(a.time_offset_s, b.time_offset_s);
      EXPECT_EQ(a.start_time_s, b.start_time_s);
    }
    ASSERT_NE(source->inertial(), nullptr);
    EXPECT_EQ(source->inertial()->samples.size(), 20U);
    messages.erase(messages.begin());
    EXPECT_THAT(error_of([&] { open_messages(messages, wire, report); }), HasSubstr("topic 'metadata'"));
    FrameSourceOptions options;
    options.sensor = (dir / "walk.json").string();
    EXPECT_EQ(open_messages(messages, wire, report, options)->size(), 5U);
  }
}

}  // namespace
}  // namespace bole::io
