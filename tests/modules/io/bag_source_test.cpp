#include "io/core/bags/bag_source.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "../sensor/ouster_packets.h"
#include "bag_files.h"
#include "cloud/known_facts.h"
#include "io/core/bags/bag_topics.h"
#include "io/core/bags/messages.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/scans/velodyne_pcap.h"
#include "io_test_tools.h"
#include "pcap_bytes.h"
#include "sensor/core/pcap_writer.h"
#include "sensor/core/velodyne_encoder.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr std::int64_t start_ns = 1'700'000'000'000'000'000;
constexpr std::int64_t period_ns = 100'000'000;
constexpr std::uint32_t rings = 16, columns = 180;

// A sweep of 16 rings over 180 columns: the point in column c has turned by 2 c degrees.
Eigen::Vector3d point(std::size_t i) {
  const double elevation = (static_cast<double>(i % rings) - 7.5) * 2 * std::numbers::pi / 180;
  const double azimuth = 2.0 * static_cast<double>(i / rings) * std::numbers::pi / 180;
  return 10 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation));
}
double offset_s(std::size_t i) { return 0.1 * static_cast<double>(i / rings) / columns; }

std::vector<CloudColumn> coordinates(int type = f32) {
  return {{"x", type, [](std::size_t i) { return point(i).x(); }},
          {"y", type, [](std::size_t i) { return point(i).y(); }},
          {"z", type, [](std::size_t i) { return point(i).z(); }},
          {"intensity", f32, [](std::size_t i) { return static_cast<double>(i % 200); }},
          {"ring", u16, [](std::size_t i) { return static_cast<double>(i % rings); }}};
}

// `more(stamp)` gives the columns beside the coordinates; messages are recorded `delay_ns` after their stamp.
std::vector<Message> clouds(Wire wire, const std::function<std::vector<CloudColumn>(std::int64_t)>& more,
                            const CloudShape& shape = {1, rings* columns}, std::int64_t delay_ns = 105'000'000,
                            int frames = 5) {
  std::vector<Message> out;
  for (int k = 0; k < frames; ++k) {
    const auto stamp = start_ns + k * period_ns;
    auto all = coordinates();
    for (auto& c : more(stamp)) all.push_back(c);
    out.push_back({"/points", "sensor_msgs/msg/PointCloud2", stamp + delay_ns, cloud_message(wire, stamp, all, shape)});
  }
  return out;
}

std::shared_ptr<const FrameSource> open_messages(const std::vector<Message>& messages, Wire wire, Report& report,
                                                 FrameSourceOptions options = {}) {
  static std::vector<std::unique_ptr<std::string>> files;  // a bag in memory must outlive its source
  McapWriter writer;
  writer.encoding = wire == Wire::ros1 ? "ros1" : "cdr";
  files.push_back(std::make_unique<std::string>(writer.write(messages)));
  return open_bag_source(std::shared_ptr<const Bag>(open_bag(bytes_of(*files.back()), "walk.mcap")), "walk.mcap",
                         options, {}, report);
}

void expect_sweep(const FrameSource& source, double first_start_s, double tolerance_s = 1e-6) {
  ScanFrame frame;
  ASSERT_EQ(source.size(), 5U);
  EXPECT_EQ(source.rings(), 16);
  for (std::size_t k = 0; k < source.size(); ++k) {
    EXPECT_NEAR(source.frame_time_s(k), first_start_s + 0.1 * static_cast<double>(k), tolerance_s);
    source.read(k, frame);
    ASSERT_EQ(frame.size(), rings * columns);
    EXPECT_EQ(frame.start_time_s, source.frame_time_s(k));
    EXPECT_NEAR(frame.end_time_s - frame.start_time_s, offset_s(frame.size() - 1), tolerance_s);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      ASSERT_EQ(frame.positions[i], point(i).cast<float>());
      ASSERT_NEAR(frame.time_offset_s[i], offset_s(i), tolerance_s);
      ASSERT_EQ(frame.ring[i], i % rings);
      ASSERT_EQ(frame.intensity[i], static_cast<float>(i % 200));
      ASSERT_EQ(frame.return_number[i], 1);
    }
  }
}

struct Dialect {
  const char* name;
  int type;
  double per_second;
  enum { from_start, before_end, absolute } origin;
};

TEST(BagSource, TimesOfPointsInTheDialectsOfTheDrivers) {
  const Dialect dialects[] = {
      {"t", u32, 1e9, Dialect::from_start},           {"time", f32, 1, Dialect::from_start},
      {"time", f32, 1, Dialect::before_end},          {"timestamp", f64, 1, Dialect::absolute},
      {"timestamp", f64, 1e9, Dialect::absolute},     {"timestamp", f64, 1e6, Dialect::absolute},
      {"offset_time", u32, 1e9, Dialect::from_start}, {"time_stamp", u32, 1e9, Dialect::from_start},
      {"t", u32, 1e6, Dialect::from_start},           {"time", f32, 1e3, Dialect::from_start},
      {"timeOffset", f64, 1, Dialect::from_start}};
  for (const auto& d : dialects)
    for (const auto wire : {Wire::ros1, Wire::cdr_little, Wire::cdr_big}) {
      SCOPED_TRACE(std::string(d.name) + " " + std::to_string(d.per_second) + " " + std::to_string(d.origin));
      const auto messages = clouds(wire, [&](std::int64_t stamp) {
        const double origin = d.origin == Dialect::absolute     ? 1e-9 * static_cast<double>(stamp)
                              : d.origin == Dialect::before_end ? -0.1
                                                                : 0;
        return std::vector<CloudColumn>{
            {d.name, d.type, [=](std::size_t i) { return (origin + offset_s(i)) * d.per_second; }}};
      });
      Report report;
      const auto source = open_messages(messages, wire, report);
      const double start_s = 1e-9 * start_ns - (d.origin == Dialect::before_end ? 0.1 : 0);
      expect_sweep(*source, start_s, d.per_second == 1e6 && d.type == u32 ? 2e-6 : 1e-6);
      EXPECT_TRUE(report.findings.empty());
      EXPECT_THAT(report.facts.at("point_times"), HasSubstr(d.origin == Dialect::from_start   ? "start of the sweep"
                                                            : d.origin == Dialect::before_end ? "end of the sweep"
                                                                                              : "absolute"));
    }
}

TEST(BagSource, ASensorsOwnClockIsBroughtToThatOfTheStamps) {
  const auto messages = clouds(Wire::cdr_little, [](std::int64_t stamp) {
    const double own_s = 1e-9 * static_cast<double>(stamp - start_ns) + 321;
    return std::vector<CloudColumn>{{"timestamp", f64, [=](std::size_t i) { return own_s + offset_s(i); }}};
  });
  Report report;
  const auto source = open_messages(messages, Wire::cdr_little, report);
  expect_sweep(*source, 1e-9 * start_ns, 2e-6);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_EQ(report.findings[0].code, "point_times_unclear");
}

TEST(BagSource, AStampThatCannotBeTheStartIsTold) {
  const auto time = [](std::int64_t) {
    return std::vector<CloudColumn>{{"t", u32, [](std::size_t i) { return offset_s(i) * 1e9; }}};
  };
  Report report;
  open_messages(clouds(Wire::cdr_little, time, {1, rings * columns}, 9'000'000), Wire::cdr_little, report);
  ASSERT_EQ(report.findings.size(), 1U);
  EXPECT_THAT(report.findings[0].text, HasSubstr("9 ms after their stamp"));
}

TEST(BagSource, WithoutTimesTheAzimuthGivesThemWithAWarning) {
  for (const bool constant : {false, true}) {
    const auto more = [&](std::int64_t) {
      return constant ? std::vector<CloudColumn>{{"time", f32, [](std::size_t) { return 0.0; }}}
                      : std::vector<CloudColumn>{};
    };
    Report report;
    const auto source = open_messages(clouds(Wire::ros1, more), Wire::ros1, report);
    EXPECT_THAT(report.warnings, Contains(HasSubstr("the points have no times")));
    EXPECT_NEAR(source->frame_time_s(0), 1e-9 * start_ns - 0.05, 1e-6);
    ScanFrame frame;
    source->read(0, frame);
    EXPECT_NEAR(frame.time_offset_s[0], 0.05, 1e-4);  // forward in the middle
  }
}

TEST(BagSource, BigEndianPointsPaddedRowsAndPointsThatAreNone) {
  const auto time = [](std::int64_t) {
    return std::vector<CloudColumn>{{"t", u32, [](std::size_t i) { return offset_s(i) * 1e9; }}};
  };
  Report report;
  expect_sweep(*open_messages(clouds(Wire::cdr_little, time, {columns, rings, 24, true}), Wire::cdr_little, report),
               1e-9 * start_ns);
  // Every third point is none, or lies at the sensor.
  std::vector<Message> messages;
  for (int k = 0; k < 3; ++k) {
    auto all = coordinates();
    all[0].value = [](std::size_t i) {
      return i % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : i % 3 == 1 ? 0 : point(i).x();
    };
    all[1].value = [](std::size_t i) { return i % 3 == 1 ? 0 : point(i).y(); };
    all[2].value = [](std::size_t i) { return i % 3 == 1 ? 0 : point(i).z(); };
    messages.push_back({"/points", "sensor_msgs/PointCloud2", start_ns + k * period_ns,
                        cloud_message(Wire::cdr_little, start_ns + k * period_ns, all, {1, rings * columns})});
  }
  const auto source = open_messages(messages, Wire::cdr_little, report);
  ScanFrame frame;
  source->read(1, frame);
  ASSERT_EQ(frame.size(), rings * columns / 3);
  EXPECT_EQ(frame.positions[1], point(5).cast<float>());
  EXPECT_EQ(frame.ring[1], 5);
}

TEST(BagSource, RingsAreCountedFromTheLowest) {
  for (const bool shuffled : {false, true}) {
    std::vector<Message> messages;
    for (int k = 0; k < 3; ++k) {
      auto all = coordinates();
      all[4] = {"channel", u8, [=](std::size_t i) {
                  return static_cast<double>(shuffled ? i % rings * 5 % rings : rings - 1 - i % rings);
                }};
      messages.push_back({"/points", "sensor_msgs/PointCloud2", start_ns + k * period_ns,
                          cloud_message(Wire::ros1, start_ns + k * period_ns, all, {1, rings * columns})});
    }
    Report report;
    const auto source = open_messages(messages, Wire::ros1, report);
    ScanFrame frame;
    source->read(0, frame);
    for (std::size_t i = 0; i < frame.size(); ++i) ASSERT_EQ(frame.ring[i], i % rings);
    EXPECT_THAT(report.facts.at("rings"), HasSubstr(shuffled ? "sorted" : "turned round"));
    EXPECT_NEAR(source->ring_elevations_rad().front(), -15 * std::numbers::pi / 180, 1e-4);
  }
}

TEST(BagSource, TheSensorIsNamedOrToldToBeUnknown) {
  const auto none = [](std::int64_t) { return std::vector<CloudColumn>{}; };
  Report report;
  auto source = open_messages(clouds(Wire::ros1, none), Wire::ros1, report);
  EXPECT_EQ(source->sensor_model(), "unknown");
  EXPECT_FALSE(fact_text(source->facts(), facts::sensor));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("option sensor")));
  FrameSourceOptions options;
  options.sensor = "vlp16";
  source = open_messages(clouds(Wire::ros1, none), Wire::ros1, report, options);
  EXPECT_EQ(source->sensor_model(), "vlp16");
  EXPECT_EQ(source->facts().at("sensor"), "VLP-16");
  EXPECT_THAT(report.warnings, Not(Contains(HasSubstr("does not say which sensor"))));
}

TEST(BagSource, LivoxMessagesAreRosettes) {
  for (const char* type : {"livox_ros_driver/CustomMsg", "livox_ros_driver2/msg/CustomMsg"})
    for (const auto wire : {Wire::ros1, Wire::cdr_little, Wire::cdr_big}) {
      std::vector<Message> messages;
      for (int k = 0; k < 3; ++k) {
        std::vector<LivoxTestPoint> points;
        for (std::uint32_t i = 0; i < 101; ++i)
          points.push_back({i * 1'000'000, 2.F + static_cast<float>(i), 1, -1, static_cast<std::uint8_t>(i), 0x10,
                            static_cast<std::uint8_t>(i % 4)});
        messages.push_back({"/livox/lidar", type, start_ns + k * period_ns + 100'000'000,
                            livox_message(wire, start_ns + k * period_ns, points)});
      }
      Report report;
      const auto source = open_messages(messages, wire, report);
      EXPECT_EQ(source->pattern(), ScanPattern::rosette);
      EXPECT_EQ(source->rings(), 1);
      ScanFrame frame;
      source->read(2, frame);
      ASSERT_EQ(frame.size(), 101U);
      EXPECT_NEAR(frame.start_time_s, 1e-9 * static_cast<double>(start_ns + 2 * period_ns), 1e-6);
      for (std::size_t i = 0; i < frame.size(); ++i) {
        EXPECT_EQ(frame.positions[i], Eigen::Vector3f(2.F + static_cast<float>(i), 1, -1));
        EXPECT_NEAR(frame.time_offset_s[i], 1e-3 * static_cast<double>(i), 1e-8);
        EXPECT_EQ(frame.intensity[i], static_cast<float>(i));
        EXPECT_EQ(frame.ring[i], 0);
      }
    }
}

std::vector<Message> with_imu(std::vector<Message> messages, Wire wire, const std::string& topic, double gravity,
                              std::int64_t shift_ns = 0) {
  for (int k = 0; k < 100; ++k) {
    const auto stamp = start_ns + shift_ns + (k ^ 1) * 5'000'000;  // neighbours change places
    messages.push_back({topic, "sensor_msgs/msg/Imu", start_ns + k * 5'000'000,
                        imu_message(wire, stamp, {0.01, 0.02, 0.001 * (k ^ 1)}, {0, 0.1, gravity})});
  }
  return messages;
}

TEST(BagSource, TheInertialUnitComesAlong) {
  const auto none = [](std::int64_t) { return std::vector<CloudColumn>{}; };
  for (const auto wire : {Wire::ros1, Wire::cdr_little, Wire::cdr_big})
    for (const double gravity : {9.81, 1.0}) {
      Report report;
      const auto source = open_messages(with_imu(clouds(wire, none), wire, "/imu/data", gravity), wire, report);
      ASSERT_NE(source->inertial(), nullptr);
      const auto& record = *source->inertial();
      EXPECT_EQ(record.name, "/imu/data");
      EXPECT_FALSE(record.T_sensor_imu);
      ASSERT_EQ(record.samples.size(), 100U);
      for (std::size_t k = 0; k < 100; ++k) {
        EXPECT_NEAR(record.samples[k].time_s, 1e-9 * start_ns + 0.005 * static_cast<double>(k), 1e-6);
        EXPECT_DOUBLE_EQ(record.samples[k].angular_rate_rad_s.z(), 0.001 * static_cast<double>(k));
        EXPECT_NEAR(record.samples[k].specific_force_m_s2.z(), gravity == 1 ? 9.80665 : 9.81, 1e-9);
      }
    }
}

TEST(BagSource, TopicsAreChosenWhereThereIsOneAndAskedForWhereThereAreMore) {
  const auto none = [](std::int64_t) { return std::vector<CloudColumn>{}; };
  auto messages = with_imu(clouds(Wire::cdr_little, none), Wire::cdr_little, "/imu/a", 9.81);
  auto second = messages[0];
  second.topic = "/points_b";
  second.time_ns += 1'000'000'000;
  const auto two_units = with_imu(messages, Wire::cdr_little, "/imu/b", 9.81);
  messages.push_back(second);
  Report report;
  const auto ask = error_of([&] { open_messages(messages, Wire::cdr_little, report); });
  EXPECT_THAT(ask, HasSubstr("/points (sensor_msgs/PointCloud2, 5), /points_b (sensor_msgs/PointCloud2, 1)"));
  FrameSourceOptions options;
  options.topic = "/points";
  EXPECT_EQ(open_messages(messages, Wire::cdr_little, report, options)->size(), 5U);
  options.topic = "/pionts";
  EXPECT_THAT(error_of([&] { open_messages(messages, Wire::cdr_little, report, options); }),
              HasSubstr("Set topic=/points"));
  options.topic = "/imu/a";
  EXPECT_THAT(error_of([&] { open_messages(messages, Wire::cdr_little, report, options); }),
              HasSubstr("sensor_msgs/Imu"));
  // Units are optional: none is taken where there are several.
  Report units;
  EXPECT_EQ(open_messages(two_units, Wire::cdr_little, units)->inertial(), nullptr);
  EXPECT_THAT(units.warnings, Contains(HasSubstr("/imu/a (sensor_msgs/Imu, 100), /imu/b")));
  options = {};
  options.imu = "/imu/b";
  EXPECT_EQ(open_messages(two_units, Wire::cdr_little, report, options)->inertial()->name, "/imu/b");
  options.imu = "none";
  EXPECT_EQ(open_messages(two_units, Wire::cdr_little, report, options)->inertial(), nullptr);
  options.imu = "/imu/c";
  EXPECT_THAT(error_of([&] { open_messages(two_units, Wire::cdr_little, report, options); }),
              HasSubstr("no topic '/imu/c'"));
}

TEST(BagSource, ClocksThatDifferAndAxesOfARobotAreFound) {
  const auto none = [](std::int64_t) { return std::vector<CloudColumn>{}; };
  Report report;
  open_messages(with_imu(clouds(Wire::ros1, none), Wire::ros1, "/imu", 9.81, 50'000'000'000), Wire::ros1, report);
  EXPECT_THAT(report.findings, Contains(testing::Field(&Finding::code, "imu_clock_differs")));
  Report other;
  open_messages({{"/p", "sensor_msgs/PointCloud2", start_ns,
                  cloud_message(Wire::ros1, start_ns, coordinates(f64), {1, 2880}, "base_link")}},
                Wire::ros1, other);
  EXPECT_THAT(other.findings, Contains(testing::Field(&Finding::code, "axes_not_of_sensor")));
}

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

double azimuth_deg(const Eigen::Vector3f& p) { return std::atan2(-p.y(), p.x()) * 180 / std::numbers::pi; }

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
          {frame.positions[i].norm(), frame.positions[i].z(), azimuth_deg(frame.positions[i]), frame.ring[i]});
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
      const double ahead = std::remainder(azimuth_deg(p) - q->azimuth, 360);
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

TEST(BagSource, CutMessagesAreErrorsOrWhatTheyHold) {
  const auto whole = clouds(Wire::cdr_little, [](std::int64_t) { return std::vector<CloudColumn>{}; });
  for (const std::size_t bytes : {0U, 3U, 20U, 90U, 150U}) {
    EXPECT_THROW(parse_cloud(bytes_of(whole[0].bytes.substr(0, bytes)), MessageEncoding::cdr), Error) << bytes;
    EXPECT_THROW(parse_imu(bytes_of(whole[0].bytes.substr(0, bytes)), MessageEncoding::ros1), Error) << bytes;
  }
  // The last message is cut: its frame is an error, the others are read.
  auto messages = whole;
  messages[2].bytes.resize(messages[2].bytes.size() / 2);
  Report report;
  const auto source = open_messages(messages, Wire::cdr_little, report);
  ScanFrame frame;
  EXPECT_THAT(error_of([&] { source->read(2, frame); }), HasSubstr("frame 2"));
  source->read(4, frame);
  EXPECT_EQ(frame.size(), rings * columns);
}

std::vector<CloudColumn> seconds_from_start(std::int64_t) { return {{"time", f32, offset_s}}; }

TEST(BagSource, APointSlightlyBeforeTheStampDoesNotMoveTheStart) {
  const auto early = [](std::int64_t) {
    return std::vector<CloudColumn>{{"time", f32, [](std::size_t i) { return offset_s(i) - (i == 0 ? 2e-5 : 0); }}};
  };
  Report report;
  const auto source = open_messages(clouds(Wire::ros1, early), Wire::ros1, report);
  ScanFrame frame;
  source->read(1, frame);
  EXPECT_NEAR(frame.start_time_s, 1e-9 * (start_ns + period_ns), 2e-6);
  EXPECT_NEAR(frame.time_offset_s[0], -2e-5, 1e-7);
  EXPECT_NEAR(frame.time_offset_s[rings], offset_s(rings), 1e-7);
}

TEST(BagSource, TagsOfLivoxPointsTellNoiseAndReturns) {
  for (const bool from_one : {false, true}) {
    std::vector<Message> messages;
    for (int k = 0; k < 3; ++k) {
      std::vector<LivoxTestPoint> points;
      for (std::uint32_t i = 0; i < 99; ++i)
        points.push_back({i * 1'000'000, 2.F + static_cast<float>(i), 1, -1, 5,
                          static_cast<std::uint8_t>((i % 3 + (from_one ? 1 : 0)) << 4 | (i == 7   ? 1
                                                                                         : i == 8 ? 4
                                                                                                  : 0)),
                          0});
      messages.push_back({"/livox/lidar", "livox_ros_driver/CustomMsg", start_ns + k * period_ns + 100'000'000,
                          livox_message(Wire::ros1, start_ns + k * period_ns, points)});
    }
    Report report;
    const auto source = open_messages(messages, Wire::ros1, report);
    ScanFrame frame;
    source->read(1, frame);
    ASSERT_EQ(frame.size(), 97U);
    EXPECT_EQ(frame.positions[7].x(), 11.F);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(frame.return_number[i], i % 3 + 1);
  }
}

TEST(BagSource, LivoxCloudsWithoutTimesAreTimedByTheirOrder) {
  std::vector<Message> messages;
  for (int k = 0; k < 4; ++k) {
    const auto stamp = start_ns + k * period_ns;
    messages.push_back({"/livox/lidar", "sensor_msgs/PointCloud2", stamp + period_ns,
                        cloud_message(Wire::ros1, stamp,
                                      {{"x", f32, [](std::size_t i) { return 5 + 0.01 * static_cast<double>(i); }},
                                       {"y", f32, [](std::size_t) { return 0.1; }},
                                       {"z", f32, [](std::size_t) { return 0.2; }},
                                       {"tag", u8, [](std::size_t) { return 16.0; }},
                                       {"line", u8, [](std::size_t i) { return static_cast<double>(i % 6); }}},
                                      {1, 1000})});
  }
  Report report;
  const auto source = open_messages(messages, Wire::ros1, report);
  EXPECT_EQ(source->pattern(), ScanPattern::rosette);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("order of the points")));
  ScanFrame frame;
  source->read(2, frame);
  ASSERT_EQ(frame.size(), 1000U);
  EXPECT_NEAR(frame.start_time_s, 1e-9 * (start_ns + 2 * period_ns), 1e-6);
  EXPECT_NEAR(frame.time_offset_s[0], 0, 1e-7);
  EXPECT_NEAR(frame.time_offset_s[500], 0.05, 1e-6);
  EXPECT_EQ(source->frame_time_s(2), frame.start_time_s);
}

TEST(BagSource, CloudsThatAreMissingOrThereTwiceAreCounted) {
  auto messages = clouds(Wire::ros1, seconds_from_start, {1, rings * columns}, 105'000'000, 12);
  auto twice = messages;
  twice.insert(twice.end(), messages.begin(), messages.end());
  Report doubled;
  EXPECT_EQ(open_messages(twice, Wire::ros1, doubled)->size(), 12U);
  EXPECT_EQ(doubled.counts.at("duplicate_messages"), 12);
  messages.erase(messages.begin() + 3);
  messages.erase(messages.begin() + 6, messages.begin() + 8);
  Report holes;
  EXPECT_EQ(open_messages(messages, Wire::ros1, holes)->size(), 9U);
  EXPECT_EQ(holes.counts.at("missing_messages"), 3);
  EXPECT_THAT(holes.findings, Contains(testing::Field(&Finding::code, "messages_missing")));
}

TEST(BagSource, AClockThatIsSetDuringTheRecordingStartsFramesAtTheirStamps) {
  for (const double apart_s : {1.6e9, 3.0}) {
    const auto jumping = [&](std::int64_t stamp) {
      const double own_s = 1e-9 * static_cast<double>(stamp) - (stamp < start_ns + 6 * period_ns ? apart_s : 0);
      return std::vector<CloudColumn>{{"timestamp", f64, [=](std::size_t i) { return own_s + offset_s(i); }}};
    };
    Report report;
    const auto source =
        open_messages(clouds(Wire::ros1, jumping, {1, rings * columns}, 105'000'000, 10), Wire::ros1, report);
    for (std::size_t k = 0; k < 10; ++k)
      EXPECT_NEAR(source->frame_time_s(k), 1e-9 * start_ns + 0.1 * static_cast<double>(k), 1e-5) << k;
    ASSERT_EQ(report.findings.size(), 1U);
    EXPECT_THAT(report.findings[0].text, HasSubstr("jumps"));
  }
}

TEST(BagSource, IntensitiesOfOusterCloudsAreTheReflectivities) {
  const auto more = [](std::int64_t) {
    return std::vector<CloudColumn>{{"reflectivity", u16, [](std::size_t i) { return static_cast<double>(i % 50); }},
                                    {"ambient", u16, [](std::size_t) { return 9.0; }}};
  };
  Report report;
  const auto source = open_messages(clouds(Wire::ros1, more), Wire::ros1, report);
  ScanFrame frame;
  source->read(0, frame);
  EXPECT_EQ(frame.intensity[149], 49.F);
}

TEST(BagSource, InertialMessagesThatAreNoNumbersOrRepeatedAreTold) {
  auto messages = clouds(Wire::ros1, seconds_from_start);
  for (int k = 0; k < 100; ++k) {
    const auto stamp = start_ns + (k == 5 ? 4 : k) * 5'000'000;
    const double rate = k == 3 ? std::numeric_limits<double>::quiet_NaN() : 0.01;
    messages.push_back({"/imu", "sensor_msgs/Imu", start_ns + k * 5'000'000,
                        imu_message(Wire::ros1, stamp, {rate, 0, 0}, {0, 0, 9.81})});
  }
  Report report;
  const auto source = open_messages(messages, Wire::ros1, report);
  ASSERT_NE(source->inertial(), nullptr);
  EXPECT_EQ(source->inertial()->samples.size(), 98U);
  EXPECT_THAT(report.findings, Contains(testing::Field(&Finding::text, HasSubstr("1 of 100 messages of /imu"))));
  EXPECT_THAT(report.warnings, Contains(HasSubstr("have the time of the one before")));
}

TEST(BagSource, AnInertialUnitThatCoversAPartIsFound) {
  const auto scan = clouds(Wire::ros1, seconds_from_start, {1, rings * columns}, 105'000'000, 40);
  Report report;
  open_messages(with_imu(scan, Wire::ros1, "/imu", 9.81), Wire::ros1, report);  // 0.5 s of 4 s
  EXPECT_THAT(report.findings, Contains(testing::Field(&Finding::code, "imu_covers_part")));
}

TEST(BagSource, TopicsAreDescribed) {
  const auto messages = with_imu(clouds(Wire::cdr_little, [](std::int64_t) { return std::vector<CloudColumn>{}; }),
                                 Wire::cdr_little, "/imu", 9.81);
  McapWriter writer;
  const auto file = writer.write(messages);
  const auto topics = describe_topics(*open_bag(bytes_of(file), "a"));
  ASSERT_EQ(topics.size(), 2U);
  EXPECT_EQ(topics[0].use, "scan");
  EXPECT_THAT(topics[0].fields,
              testing::ElementsAre("x float32", "y float32", "z float32", "intensity float32", "ring uint16"));
  EXPECT_EQ(topics[1].use, "imu");
  EXPECT_EQ(topics[1].topic.messages, 100);
}

TEST(BagSource, OtherScansHaveNoTopics) {
  const TempDir dir;
  write_file(dir / "0.bin", std::string(1600, '\0'));
  FrameSourceOptions options;
  options.topic = "/points";
  EXPECT_THAT(error_of([&] { open_frame_source(dir.path(), options); }), HasSubstr("has no topics"));
}

}  // namespace
}  // namespace bole::io
