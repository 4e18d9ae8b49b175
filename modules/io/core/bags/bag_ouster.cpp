#include "io/core/bags/bag_ouster.h"

#include <algorithm>

#include "base/error.h"
#include "io/core/bags/bag_topics.h"
#include "io/core/bags/messages.h"
#include "io/core/scans/beside_capture.h"

namespace bole::io {
namespace {

namespace fs = std::filesystem;

// "/ouster/lidar_packets" is "/ouster".
std::string_view name_space(std::string_view topic) { return topic.substr(0, topic.rfind('/')); }

std::vector<fs::path> metadata_files_beside(const fs::path& bag) {
  std::vector<fs::path> files;
  std::error_code ignored;
  const auto folder = fs::is_directory(bag, ignored) ? bag
                      : bag.parent_path().empty()    ? fs::path(".")
                                                     : bag.parent_path();
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json" &&
        sensor::looks_like_ouster_metadata(small_file_text(entry.path(), max_metadata_bytes)))
      files.push_back(entry.path());
  const auto same = std::ranges::find(files, bag.stem(), [](const fs::path& p) { return p.stem(); });
  if (same != files.end()) return {*same};
  std::ranges::sort(files);
  return files;
}

}  // namespace

sensor::OusterMetadata find_ouster_metadata(const Bag& bag, const fs::path& path, const std::string& sensor_option,
                                            const Run& run, std::string& found) {
  if (sensor_option != "auto") {
    const auto text = small_file_text(sensor_option, max_metadata_bytes);
    if (!sensor::looks_like_ouster_metadata(text))
      throw bad_input("the bag holds packets of an Ouster sensor, and the option sensor is '" + sensor_option + "'",
                      "the JSON file of the sensor, with its beams and its packet layout");
    found = sensor_option;
    return sensor::parse_ouster_metadata(text);
  }
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const auto& topic = bag.topics()[i];
    if (topic.type != message_type::text || !topic.name.ends_with("metadata") || topic.messages == 0) continue;
    const auto messages = bag.index(i, run);
    if (messages.empty()) continue;
    const auto text = parse_text(bag.read(messages.back()), topic.encoding);
    if (!sensor::looks_like_ouster_metadata(text)) continue;
    found = "topic " + topic.name;
    return sensor::parse_ouster_metadata(text);
  }
  const auto files = metadata_files_beside(path);
  if (files.size() == 1) {
    found = files.front().filename().string();
    return sensor::parse_ouster_metadata(small_file_text(files.front(), max_metadata_bytes));
  }
  throw bad_input(
      "the bag has no topic 'metadata' with the beams of the Ouster sensor, and there " +
          (files.empty() ? std::string("is no JSON file") : "are " + std::to_string(files.size()) + " JSON files") +
          " of a sensor beside it",
      "one JSON file of the sensor", "Name it with the option sensor");
}

std::vector<std::size_t> ouster_topics(const Bag& bag, std::size_t lidar_topic) {
  std::vector<std::size_t> out{lidar_topic};
  const auto& lidar = bag.topics()[lidar_topic];
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const auto& topic = bag.topics()[i];
    if (i != lidar_topic && holds_ouster_packets(topic) && name_space(topic.name) == name_space(lidar.name) &&
        !holds_scan(bag, i))
      out.push_back(i);
  }
  return out;
}

}  // namespace bole::io
