#include "io/core/bags/bag_source.h"

#include <gmock/gmock.h>

#include "bag_sweeps.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::Contains;
using testing::HasSubstr;

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

}  // namespace
}  // namespace bole::io
