#include "io/core/bags/bag_source.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "bag_sweeps.h"
#include "cloud/known_facts.h"
#include "io/core/bags/bag_topics.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

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

}  // namespace
}  // namespace bole::io
