#include "io/core/bags/ros1_bag.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/file_pages.h"
#include "io/core/bags/record_reader.h"

namespace bole::io {
namespace {

constexpr std::string_view ros1_magic = "#ROSBAG V2.0\n";
enum Ros1Operation { message_data = 2, bag_header = 3, index_data = 4, chunk_data = 5, chunk_info = 6, connection = 7 };

std::int64_t nanoseconds(std::uint32_t seconds, std::uint32_t rest) {
  return std::int64_t{seconds} * 1'000'000'000 + rest;
}

std::int64_t time_field(Bytes value) {
  RecordReader reader(value);
  const auto seconds = reader.get<std::uint32_t>();
  return nanoseconds(seconds, reader.get<std::uint32_t>());
}

}  // namespace

bool is_ros1_bag(Bytes file) {
  const auto head = text_of(file);
  return head.starts_with("#ROSBAG V") || head.starts_with("#ROSRECORD V") || head.starts_with("#ROSLOG V");
}

Ros1Bag::Ros1Bag(Bytes file, const std::string& name, const Run& run) : file_(file), name_(name) {
  const auto head = text_of(file);
  if (!head.starts_with(ros1_magic))
    throw bad_input("'" + name + "' is " +
                        (is_ros1_bag(file) ? "a bag of version '" + std::string(head.substr(0, head.find('\n'))) + "'"
                                           : "no ROS 1 bag"),
                    "a bag of version 2.0", is_ros1_bag(file) ? "Convert it with rosbag migrate" : "");
  const auto header = record_at(file_, ros1_magic.size());
  const auto position = header.whole ? number<std::uint64_t>(header.header, "index_pos") : std::nullopt;
  if (position && *position > header.end && read_index(*position)) return;
  topics_.clear();
  chunks_.clear();
  topic_of_connection_.clear();
  store_ = {};
  if (position && *position == 0)
    note_damage("the bag was not closed and has no index: its records were gone through");
  else
    note_damage("the index of the bag is damaged: its records were gone through");
  scan(run);
}

Ros1Bag::Record Ros1Bag::record_at(Bytes bytes, std::size_t at) {
  Record record;
  record.begin = at;
  RecordReader reader(bytes.subspan(std::min(at, bytes.size())));
  record.header = reader.block();
  const auto length = reader.get<std::uint32_t>();
  if (!reader.ok()) return record;
  const auto room = bytes.size() - at - reader.at();
  record.whole = length <= room;
  record.data = bytes.subspan(at + reader.at(), std::min<std::size_t>(length, room));
  record.end = at + reader.at() + record.data.size();
  return record;
}

Bytes Ros1Bag::field(Bytes header, std::string_view name) {
  RecordReader reader(header);
  while (!reader.at_end() && reader.ok()) {
    const auto entry = reader.block();
    const auto text = text_of(entry);
    if (text.size() > name.size() && text.starts_with(name) && text[name.size()] == '=')
      return entry.subspan(name.size() + 1);
  }
  return {};
}

template <class T>
std::optional<T> Ros1Bag::number(Bytes header, std::string_view name) {
  const auto value = field(header, name);
  if (value.size() != sizeof(T)) return {};
  return RecordReader(value).get<T>();
}

int Ros1Bag::operation(const Record& record) { return number<std::uint8_t>(record.header, "op").value_or(0); }

void Ros1Bag::add_connection(const Record& record) {
  const auto id = number<std::uint32_t>(record.header, "conn");
  const auto topic = text_of(field(record.header, "topic")), type = text_of(field(record.data, "type"));
  if (!id || topic.empty()) return;
  topic_of_connection_[*id] = topic_of(topic, type, MessageEncoding::ros1);
}

std::optional<Ros1Bag::Chunk> Ros1Bag::open_chunk(const Record& record) {
  if (operation(record) != chunk_data) return {};
  const auto name = text_of(field(record.header, "compression"));
  const auto compression = compression_named(name);
  if (compression == Compression::unknown || compression == Compression::zstd) {
    note_damage("chunks compressed with '" + std::string(name) + "' cannot be read");
    return {};
  }
  Chunk chunk;
  auto size = number<std::uint32_t>(record.header, "size").value_or(0);
  if (size == 0 && !record.data.empty()) size = std::numeric_limits<std::uint32_t>::max();  // not filled in
  chunk.part = store_.add(compression, record.data, compression == Compression::none ? record.data.size() : size);
  chunk.begin = record.begin;
  chunk.index_at = record.end;
  chunk.index_end = file_.size();
  return chunk;
}

bool Ros1Bag::read_index(std::uint64_t position) {
  const auto header = record_at(file_, ros1_magic.size());
  const auto chunk_count = number<std::uint32_t>(header.header, "chunk_count");
  for (auto at = static_cast<std::size_t>(std::min<std::uint64_t>(position, file_.size())); at < file_.size();) {
    const auto record = record_at(file_, at);
    if (!record.whole) return false;
    at = record.end;
    if (operation(record) == connection) add_connection(record);
    if (operation(record) != chunk_info) continue;
    const auto where = number<std::uint64_t>(record.header, "chunk_pos");
    if (!where || *where >= position) return false;
    auto chunk = open_chunk(record_at(file_, static_cast<std::size_t>(*where)));
    if (!chunk) return false;
    const auto first = time_field(field(record.header, "start_time")),
               last = time_field(field(record.header, "end_time"));
    RecordReader counts(record.data);
    while (!counts.at_end() && counts.ok()) {
      const auto id = counts.get<std::uint32_t>();
      const auto messages = counts.get<std::uint32_t>();
      const auto topic = topic_of_connection_.find(id);
      if (!counts.ok() || topic == topic_of_connection_.end()) return false;
      chunk->messages[id] += messages;
      count(topic->second, messages, first, last);
    }
    chunks_.push_back(std::move(*chunk));
  }
  return (!chunk_count || *chunk_count == chunks_.size()) && bound_indices(static_cast<std::size_t>(position));
}

// The index of a chunk ends at the next chunk. False where chunks overlap: then no index is to be trusted.
bool Ros1Bag::bound_indices(std::size_t end) {
  std::vector<Chunk*> order;
  for (auto& chunk : chunks_) order.push_back(&chunk);
  std::ranges::sort(order, {}, &Chunk::begin);
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i]->index_end = i + 1 < order.size() ? order[i + 1]->begin : end;
    if (order[i]->index_at > order[i]->index_end) return false;
  }
  return true;
}

// The recorder fills in the length of a chunk when the chunk is full.
bool Ros1Bag::is_unfinished(const Record& record) const {
  if (operation(record) != chunk_data || !record.data.empty() || record.end >= file_.size()) return false;
  const int next = operation(record_at(file_, record.end));
  return next != index_data && next != chunk_data && next != chunk_info;
}

void Ros1Bag::scan(const Run& run) {
  std::size_t at = ros1_magic.size();
  while (at < file_.size()) {
    run.check_cancel();
    run.report(static_cast<double>(at) / static_cast<double>(file_.size()), "looking for messages");
    auto record = record_at(file_, at);
    if (record.end == 0) break;
    const bool unfinished = is_unfinished(record);
    if (unfinished) {
      record.data = file_.subspan(record.end);
      record.end = file_.size();
      note_damage("the last chunk of the bag was not finished: what it holds is read");
    }
    if (operation(record) == connection) add_connection(record);
    if (auto chunk = open_chunk(record)) {
      scan_chunk(*chunk);
      chunks_.push_back(std::move(*chunk));
    }
    if (!record.whole) break;
    at = record.end;
  }
  if (at >= file_.size()) return;
  lost_share_ = 1 - static_cast<double>(at) / static_cast<double>(file_.size());
  note_damage("the bag is cut off or damaged at byte " + std::to_string(at) + " of " + std::to_string(file_.size()) +
              ": what comes before is read");
}

void Ros1Bag::scan_chunk(Chunk& chunk) {
  struct Seen {
    std::int64_t messages = 0, first_ns = 0, last_ns = 0;
  };
  std::map<std::uint32_t, Seen> seen;
  const auto see = [&seen](std::uint32_t id, const BagMessage& message) {
    auto& s = seen[id];
    s.first_ns = s.messages == 0 ? message.time_ns : std::min(s.first_ns, message.time_ns);
    s.last_ns = s.messages == 0 ? message.time_ns : std::max(s.last_ns, message.time_ns);
    ++s.messages;
  };
  const auto known = [&] {
    return std::ranges::all_of(seen, [&](const auto& s) { return topic_of_connection_.contains(s.first); });
  };
  if (!visit_index(chunk, see) || !known()) {
    const auto content = store_.bytes(chunk.part);
    for (std::size_t at = 0; at < content.size();) {
      const auto record = record_at(content, at);
      if (!record.whole) break;
      if (operation(record) == connection) add_connection(record);
      at = record.end;
    }
    seen.clear();
    visit_content(chunk, see);
  }
  for (const auto& [id, s] : seen) {
    const auto topic = topic_of_connection_.find(id);
    if (topic == topic_of_connection_.end()) continue;
    chunk.messages[id] = s.messages;
    count(topic->second, s.messages, s.first_ns, s.last_ns);
  }
}

template <class Visit>
bool Ros1Bag::visit_index(const Chunk& chunk, Visit&& visit) const {
  bool found = false;
  for (std::size_t at = chunk.index_at; at < chunk.index_end;) {
    const auto record = record_at(file_, at);
    const auto id = number<std::uint32_t>(record.header, "conn");
    if (!record.whole || record.end > chunk.index_end || operation(record) != index_data || !id) break;
    at = record.end;
    found = true;
    RecordReader entries(record.data);
    while (!entries.at_end()) {
      const auto seconds = entries.get<std::uint32_t>(), rest = entries.get<std::uint32_t>(),
                 offset = entries.get<std::uint32_t>();
      if (!entries.ok()) break;
      visit(*id, BagMessage{nanoseconds(seconds, rest), 0, chunk.part, offset});
    }
  }
  return found;
}

template <class Visit>
void Ros1Bag::visit_content(const Chunk& chunk, Visit&& visit) const {
  bool whole = true;
  const auto content = store_.bytes(chunk.part, &whole);
  for (std::size_t at = 0; at < content.size();) {
    const auto record = record_at(content, at);
    if (!record.whole) {
      whole = false;
      break;
    }
    if (operation(record) == message_data)
      if (const auto id = number<std::uint32_t>(record.header, "conn"))
        visit(*id, BagMessage{time_field(field(record.header, "time")), 0, chunk.part, at});
    at = record.end;
  }
  if (!whole) note_damage("a chunk of the bag is damaged: the messages before the damage are read");
}

std::vector<BagMessage> Ros1Bag::index(std::size_t topic, const Run& run) const {
  std::vector<BagMessage> out;
  for (const auto& chunk : chunks_) {
    run.check_cancel();
    std::int64_t declared = 0;
    for (const auto& [id, messages] : chunk.messages)
      if (topic_of_connection_.at(id) == topic) declared += messages;
    if (declared == 0) continue;
    const auto take = [&](std::uint32_t id, const BagMessage& message) {
      const auto found = topic_of_connection_.find(id);
      if (found != topic_of_connection_.end() && found->second == topic) out.push_back(message);
    };
    const auto before = out.size();
    if (!visit_index(chunk, take) || static_cast<std::int64_t>(out.size() - before) != declared) {
      out.resize(before);
      visit_content(chunk, take);
      if (const auto held = static_cast<std::int64_t>(out.size() - before); held != declared)
        note_damage("a chunk has " + std::to_string(held) + " messages of " + topics_[topic].name +
                    ", and the bag declares " + std::to_string(declared));
    }
  }
  std::ranges::stable_sort(out, {}, &BagMessage::time_ns);
  return out;
}

Bytes Ros1Bag::read(const BagMessage& message) const {
  const auto content = store_.bytes(message.part);
  const auto record = record_at(content, static_cast<std::size_t>(message.offset));
  if (!record.whole || operation(record) != message_data)
    throw bad_input("a message of '" + name_ + "' cannot be read: its chunk is damaged", "a whole chunk",
                    "Copy the bag again from where it was recorded");
  return record.data;
}

}  // namespace bole::io
