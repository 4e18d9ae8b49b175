// A recording of ROS messages as topics and an index by time. Messages are read by their place, so that a bag of any
// size opens at once and streams.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/run.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// How the fields of a message are written. other: neither of the two, not readable here.
enum class MessageEncoding { ros1, cdr, other };

struct BagTopic {
  std::string name;  // "/os_cloud_node/points"
  std::string type;  // "sensor_msgs/PointCloud2", without the "/msg/" of ROS 2
  MessageEncoding encoding = MessageEncoding::other;
  std::int64_t messages = 0;
  std::int64_t first_ns = 0, last_ns = 0;  // recording times, since the Unix epoch
};

// Place of a message. `part` and `offset` have the meaning that the back end gives them.
struct BagMessage {
  std::int64_t time_ns = 0;  // when it was recorded
  std::uint32_t file = 0;
  std::uint32_t part = 0;
  std::uint64_t offset = 0;
};

// May be read from one thread at a time.
class Bag {
 public:
  virtual ~Bag() = default;

  // In the order of the file. Topics without messages are listed too.
  const std::vector<BagTopic>& topics() const { return topics_; }
  // All messages of a topic in order of recording time.
  virtual std::vector<BagMessage> index(std::size_t topic, const Run& run) const = 0;
  // The bytes of a message, valid until the next call. Throws Error{bad_input} where they cannot be read.
  virtual Bytes read(const BagMessage& message) const = 0;
  // What is missing or damaged, one sentence each: for the report. More may come with index().
  const std::vector<std::string>& damage() const { return damage_; }
  // Of the bytes or messages that the recording should have, 0 to 1.
  double lost_share() const { return lost_share_; }
  // What was lost before the bag got its bytes.
  void note_loss(double share, const std::string& text);

 protected:
  // The topic with this name, type and encoding, added where there is none.
  std::size_t topic_of(std::string_view name, std::string_view type, MessageEncoding encoding);
  void count(std::size_t topic, std::int64_t messages, std::int64_t first_ns, std::int64_t last_ns);
  void note_damage(const std::string& text) const;  // each text once

  std::vector<BagTopic> topics_;
  double lost_share_ = 0;

 private:
  mutable std::vector<std::string> damage_;
};

// Opens a bag by its content: ROS 1, MCAP, SQLite, or a folder of ROS 2. Throws Error{bad_input}.
std::unique_ptr<Bag> open_bag(const std::filesystem::path& path, const Run& run = {});

// The same of bytes in memory, which must outlive the bag.
std::unique_ptr<Bag> open_bag(Bytes file, const std::string& name, const Run& run = {});

// Probes for the table of formats.
bool is_ros1_bag(Bytes file);
bool is_mcap(Bytes file);
bool is_sqlite(Bytes file);
bool is_bag_folder(const std::filesystem::path& folder);  // holds files of rosbag2

}  // namespace bole::io
