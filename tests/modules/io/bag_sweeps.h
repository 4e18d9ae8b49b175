// Sweeps of a small scanner as messages of a recording in memory, and how to open them.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bag_files.h"
#include "io/core/bags/bag_source.h"
#include "io_test_tools.h"

namespace bole::testing_bags {

inline constexpr std::int64_t start_ns = 1'700'000'000'000'000'000;
inline constexpr std::int64_t period_ns = 100'000'000;
inline constexpr std::uint32_t rings = 16, columns = 180;

// A sweep of 16 rings over 180 columns: the point in column c has turned by 2 c degrees.
inline Eigen::Vector3d point(std::size_t i) {
  const double elevation = (static_cast<double>(i % rings) - 7.5) * 2 * std::numbers::pi / 180;
  const double azimuth = 2.0 * static_cast<double>(i / rings) * std::numbers::pi / 180;
  return 10 * Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth),
                              std::sin(elevation));
}
inline double offset_s(std::size_t i) { return 0.1 * static_cast<double>(i / rings) / columns; }

inline std::vector<CloudColumn> coordinates(int type = f32) {
  return {{"x", type, [](std::size_t i) { return point(i).x(); }},
          {"y", type, [](std::size_t i) { return point(i).y(); }},
          {"z", type, [](std::size_t i) { return point(i).z(); }},
          {"intensity", f32, [](std::size_t i) { return static_cast<double>(i % 200); }},
          {"ring", u16, [](std::size_t i) { return static_cast<double>(i % rings); }}};
}

// `more(stamp)` gives the columns beside the coordinates; messages are recorded `delay_ns` after their stamp.
inline std::vector<Message> clouds(Wire wire, const std::function<std::vector<CloudColumn>(std::int64_t)>& more,
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

inline std::shared_ptr<const FrameSource> open_messages(const std::vector<Message>& messages, Wire wire, Report& report,
                                                        io::FrameSourceOptions options = {}) {
  static std::vector<std::unique_ptr<std::string>> files;  // a bag in memory must outlive its source
  McapWriter writer;
  writer.encoding = wire == Wire::ros1 ? "ros1" : "cdr";
  files.push_back(std::make_unique<std::string>(writer.write(messages)));
  return io::open_bag_source(
      std::shared_ptr<const io::Bag>(io::open_bag(testing_io::bytes_of(*files.back()), "walk.mcap")), "walk.mcap",
      options, {}, report);
}

// Times of the points in seconds after the stamp.
inline std::vector<CloudColumn> seconds_from_start(std::int64_t) { return {{"time", f32, offset_s}}; }

// The messages and, beside them, a hundred of an inertial unit.
inline std::vector<Message> with_imu(std::vector<Message> messages, Wire wire, const std::string& topic, double gravity,
                                     std::int64_t shift_ns = 0) {
  for (int k = 0; k < 100; ++k) {
    const auto stamp = start_ns + shift_ns + (k ^ 1) * 5'000'000;  // neighbours change places
    messages.push_back({topic, "sensor_msgs/msg/Imu", start_ns + k * 5'000'000,
                        imu_message(wire, stamp, {0.01, 0.02, 0.001 * (k ^ 1)}, {0, 0.1, gravity})});
  }
  return messages;
}

}  // namespace bole::testing_bags
