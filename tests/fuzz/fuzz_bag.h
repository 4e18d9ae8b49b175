// What the fuzz targets of ROS bags share.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "../modules/io/bag_files.h"
#include "fuzz_target.h"
#include "io/core/bags/bag.h"
#include "io/core/bags/bag_source.h"
#include "io/core/bags/bag_topics.h"

namespace bole::fuzz {

// Three sweeps of 128 points with their times, three messages of a Livox and four of an inertial unit.
inline std::vector<testing_bags::Message> bag_messages(testing_bags::Wire wire, bool livox) {
  using namespace testing_bags;
  std::vector<Message> out;
  for (int k = 0; k < 4; ++k) {
    const std::int64_t stamp = 1'700'000'000'000'000'000 + k * 100'000'000;
    out.push_back({"/imu", "sensor_msgs/msg/Imu", stamp, imu_message(wire, stamp, {0.1, 0, 0}, {0, 0, 9.81})});
    if (k == 3) break;
    if (livox) {
      std::vector<LivoxTestPoint> points;
      for (std::uint32_t i = 0; i < 8; ++i)
        points.push_back({i * 10'000'000, 3, static_cast<float>(i), 1, 9, 0x10, static_cast<std::uint8_t>(i % 4)});
      out.push_back({"/livox", "livox_ros_driver/CustomMsg", stamp + 1, livox_message(wire, stamp, points)});
      continue;
    }
    const auto turn = [](std::size_t i) { return 0.4 * static_cast<double>(i / 8); };
    out.push_back({"/points", "sensor_msgs/msg/PointCloud2", stamp + 1,
                   cloud_message(wire, stamp,
                                 {{"x", f32, [=](std::size_t i) { return 5 * std::cos(turn(i)); }},
                                  {"y", f32, [=](std::size_t i) { return -5 * std::sin(turn(i)); }},
                                  {"z", f32, [](std::size_t i) { return static_cast<double>(i % 8) - 3.5; }},
                                  {"ring", u8, [](std::size_t i) { return static_cast<double>(i % 8); }},
                                  {"t", u32, [](std::size_t i) { return static_cast<double>(i) * 7e5; }}},
                                 {1, 128})});
  }
  return out;
}

// Everything that a bag offers, as far as it can be read.
inline void read_bag(const std::shared_ptr<const io::Bag>& bag) {
  constexpr std::size_t most = 8;
  for (std::size_t t = 0; t < std::min(bag->topics().size(), most); ++t) {
    const auto messages = bag->index(t, {});
    for (std::size_t i = 0; i < std::min(messages.size(), most); ++i) allow_bad_input([&] { bag->read(messages[i]); });
  }
  allow_bad_input([&] { io::describe_topics(*bag); });
  for (std::size_t t = 0; t < bag->topics().size(); ++t) {
    const auto& topic = bag->topics()[t];
    if (!io::holds_scan(*bag, t)) continue;
    allow_bad_input([&] {
      io::FrameSourceOptions options;
      options.topic = topic.name;
      Report report;
      const auto source = io::open_bag_source(bag, "fuzz", options, {}, report);
      ScanFrame frame;
      for (std::size_t i = 0; i < std::min(source->size(), most); ++i) {
        source->frame_time_s(i);
        allow_bad_input([&] { source->read(i, frame); });
      }
      source->inertial();
    });
    break;
  }
}

}  // namespace bole::fuzz
