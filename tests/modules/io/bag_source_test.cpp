#include "io/core/bags/bag_source.h"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "bag_sweeps.h"
#include "io/core/bags/messages.h"

namespace bole::io {
namespace {

using namespace testing_io;
using namespace testing_bags;
using testing::Contains;
using testing::HasSubstr;

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

TEST(BagSource, RecordingTimesThatNoClockShowsAreTold) {
  auto messages = clouds(Wire::ros1, seconds_from_start, {1, rings * columns}, 105'000'000, 12);
  messages[4].time_ns = std::numeric_limits<std::int64_t>::min();  // 2^63 of the unsigned numbers in the file
  messages[8].time_ns = -1;
  Report report;
  EXPECT_EQ(open_messages(messages, Wire::ros1, report)->size(), 12U);
  EXPECT_EQ(report.counts.at("untimed_messages"), 2);
  EXPECT_THAT(report.findings, Contains(testing::Field(&Finding::code, "input_damaged")));
  EXPECT_EQ(report.counts.at("missing_messages"), 2);
  messages[4].time_ns = messages[8].time_ns = std::numeric_limits<std::int64_t>::max();
  Report far;
  EXPECT_EQ(open_messages(messages, Wire::ros1, far)->size(), 12U);
  EXPECT_GT(far.counts.at("missing_messages"), 1'000'000);
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

}  // namespace
}  // namespace bole::io
