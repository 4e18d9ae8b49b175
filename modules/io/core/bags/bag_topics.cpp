#include "io/core/bags/bag_topics.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/option.h"
#include "io/core/bags/messages.h"

namespace bole::io {
namespace {

constexpr std::array scan_types{message_type::cloud,     message_type::velodyne,         message_type::livox,
                                message_type::livox2,    message_type::livox_interfaces, message_type::ouster,
                                message_type::ouster_ros};
constexpr std::size_t ouster_imu_bytes = 48;

template <class Fits>
std::string listed(const Bag& bag, Fits&& fits) {
  std::string out;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const auto& topic = bag.topics()[i];
    if (fits(i))
      out += (out.empty() ? "" : ", ") + topic.name + " (" + topic.type + ", " + std::to_string(topic.messages) + ")";
  }
  return out.empty() ? "no topics" : out;
}

std::string all_topics(const Bag& bag) {
  return listed(bag, [](std::size_t) { return true; });
}
std::string scan_topics(const Bag& bag) {
  return listed(bag, [&bag](std::size_t i) { return holds_scan(bag, i); });
}
std::string imu_topics(const Bag& bag) {
  return listed(bag, [&bag](std::size_t i) { return holds_imu(bag.topics()[i]); });
}

// The topic of this name with messages, or the nearest names as an error.
std::size_t topic_named(const Bag& bag, const std::string& name, std::string_view option) {
  const auto& topics = bag.topics();
  std::vector<std::string> names;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    names.push_back(topics[i].name);
    const bool same = topics[i].name == name || topics[i].name == "/" + name;
    if (same && (!found || topics[i].messages > topics[*found].messages)) found = i;
  }
  if (found) return *found;
  const auto nearest = nearest_names(name, names, 1);
  throw bad_input("the recording has no topic '" + name + "'", "one of " + all_topics(bag),
                  nearest.empty() ? "" : "Set " + std::string(option) + "=" + nearest.front());
}

}  // namespace

bool holds_ouster_packets(const BagTopic& topic) {
  return topic.messages > 0 && topic.encoding != MessageEncoding::other &&
         (topic.type == message_type::ouster || topic.type == message_type::ouster_ros);
}

bool holds_scan(const Bag& bag, std::size_t index) {
  const auto& topic = bag.topics()[index];
  if (topic.messages == 0 || topic.encoding == MessageEncoding::other ||
      std::ranges::find(scan_types, topic.type) == scan_types.end())
    return false;
  if (!holds_ouster_packets(topic)) return true;
  try {
    const auto messages = bag.index(index, {});
    return !messages.empty() &&
           parse_ouster_packet(bag.read(messages.front()), topic.encoding).size() > ouster_imu_bytes;
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    return false;  // its packets cannot be read
  }
}

bool holds_imu(const BagTopic& topic) {
  return topic.messages > 0 && topic.encoding != MessageEncoding::other && topic.type == message_type::imu;
}

std::size_t choose_scan_topic(const Bag& bag, const std::string& name) {
  const auto& topics = bag.topics();
  if (!name.empty()) {
    const auto chosen = topic_named(bag, name, "topic");
    if (!holds_scan(bag, chosen))
      throw bad_input("topic " + topics[chosen].name + " holds " + std::to_string(topics[chosen].messages) +
                          " messages of type " + topics[chosen].type,
                      "point clouds or packets of a scanner: " + scan_topics(bag));
    return chosen;
  }
  std::optional<std::size_t> only;
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if (!holds_scan(bag, i)) continue;
    if (only)
      throw bad_input("the recording has more than one scan: " + scan_topics(bag), "one of them",
                      "Set topic=" + topics[*only].name + " or another one");
    only = i;
  }
  if (only) return *only;
  std::string types;
  for (const auto type : scan_types) types += (types.empty() ? "" : ", ") + std::string(type);
  throw bad_input("the recording holds no scan: " + all_topics(bag), "a topic with messages of type " + types);
}

std::optional<std::size_t> choose_imu_topic(const Bag& bag, const std::string& name, std::string& several) {
  const auto& topics = bag.topics();
  if (!name.empty()) {
    const auto chosen = topic_named(bag, name, "imu");
    if (!holds_imu(topics[chosen]))
      throw bad_input("topic " + topics[chosen].name + " holds messages of type " + topics[chosen].type,
                      "measurements of an inertial unit: " + imu_topics(bag));
    return chosen;
  }
  const auto count = std::ranges::count_if(topics, holds_imu);
  if (count > 1) several = imu_topics(bag);
  if (count != 1) return {};
  return static_cast<std::size_t>(std::ranges::find_if(topics, holds_imu) - topics.begin());
}

std::vector<TopicDescription> describe_topics(const Bag& bag, const Run& run) {
  std::vector<TopicDescription> out;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    TopicDescription description{bag.topics()[i], {}, {}};
    if (holds_scan(bag, i)) description.use = "scan";
    if (holds_imu(description.topic)) description.use = "imu";
    if (description.use == "scan" && description.topic.type == message_type::cloud) try {
        const auto messages = bag.index(i, run);
        if (!messages.empty())
          for (const auto& field : parse_cloud(bag.read(messages.front()), description.topic.encoding).fields)
            description.fields.push_back(field.name + " " + std::string(field_type_name(field.type)));
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::bad_input) throw;
        description.use.clear();  // its first message cannot be read
      }
    out.push_back(std::move(description));
  }
  return out;
}

}  // namespace bole::io
