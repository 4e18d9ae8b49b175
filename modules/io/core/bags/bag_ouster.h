// What belongs to the packets of an Ouster sensor in a bag: its metadata, and its inertial packets.
#pragma once

#include <string>
#include <vector>

#include "io/core/bags/bag.h"
#include "sensor/core/ouster_metadata.h"

namespace bole::io {

// The JSON file that the option sensor names; else the text of the topic `metadata` (std_msgs/String); else the JSON
// file beside the bag. `found` says which. Throws Error{bad_input} where there is none.
sensor::OusterMetadata find_ouster_metadata(const Bag& bag, const std::filesystem::path& path,
                                            const std::string& sensor_option, const Run& run, std::string& found);

// The topic of the lidar packets, and that of the inertial packets beside it.
std::vector<std::size_t> ouster_topics(const Bag& bag, std::size_t lidar_topic);

}  // namespace bole::io
