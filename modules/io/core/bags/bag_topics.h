// The topics of a bag as a person sees them, and the choice among them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/core/bags/bag.h"

namespace bole::io {

bool holds_scan(const Bag& bag, std::size_t topic);
bool holds_imu(const BagTopic& topic);
bool holds_ouster_packets(const BagTopic& topic);  // lidar and inertial ones, on topics of their own

// The topic that is read as the scan: the one named, or the only one with a type that can be read. Throws
// Error{bad_input} that lists the topics with their types and counts, with the nearest name where it is misspelt.
std::size_t choose_scan_topic(const Bag& bag, const std::string& name);

// Of the inertial unit: the one named, or the only one. Nothing where there is none. With several, and none named, it
// is nothing too, and `several` lists them.
std::optional<std::size_t> choose_imu_topic(const Bag& bag, const std::string& name, std::string& several);

struct TopicDescription {
  BagTopic topic;
  std::string use;                  // "scan", "imu", or empty: not read
  std::vector<std::string> fields;  // of a cloud: "x float32"
};

// For bole info.
std::vector<TopicDescription> describe_topics(const Bag& bag, const Run& run = {});

}  // namespace bole::io
