#include "io/core/bags/mcap_bag.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "io/core/bags/record_reader.h"

namespace bole::io {
namespace {

constexpr std::string_view mcap_magic("\x89MCAP0\r\n", 8);
constexpr std::uint32_t outside_chunks = std::numeric_limits<std::uint32_t>::max();
enum McapOperation {
  footer = 2,
  schema_record = 3,
  channel_record = 4,
  message_record = 5,
  chunk_record = 6,
  message_index = 7,
  chunk_index = 8,
  statistics = 11,
  data_end = 15
};

}  // namespace

bool is_mcap(Bytes file) { return text_of(file).starts_with(mcap_magic.substr(0, 5)); }

McapBag::McapBag(Bytes file, const std::string& name, const Run& run) : file_(file), name_(name) {
  if (!is_mcap(file)) throw bad_input("'" + name + "' is no MCAP file", "an MCAP file");
  if (!text_of(file).starts_with(mcap_magic))
    throw bad_input("'" + name + "' is an MCAP file of another version", "MCAP version 0");
  if (read_summary()) return;
  topics_.clear();
  chunks_.clear();
  schemas_.clear();
  topic_of_channel_.clear();
  store_ = {};
  if (ending_ == Ending::missing)
    note_damage("the file has no usable summary (not closed, or cut off): its records were gone through");
  scan(run);
}

McapBag::Record McapBag::record_at(Bytes bytes, std::size_t at) {
  Record record;
  RecordReader reader(bytes.subspan(std::min(at, bytes.size())));
  record.operation = reader.get<std::uint8_t>();
  const auto length = reader.get<std::uint64_t>();
  if (!reader.ok()) return record;
  const std::size_t room = bytes.size() - at - reader.at();
  record.whole = length <= room;
  record.data = bytes.subspan(at + reader.at(), static_cast<std::size_t>(std::min<std::uint64_t>(length, room)));
  record.end = at + reader.at() + record.data.size();
  return record;
}

void McapBag::add_schema(Bytes data) {
  RecordReader reader(data);
  const auto id = reader.get<std::uint16_t>();
  const auto name = reader.text();
  if (reader.ok()) schemas_[id] = std::string(name);
}

void McapBag::add_channel(Bytes data) {
  RecordReader reader(data);
  const auto id = reader.get<std::uint16_t>(), schema = reader.get<std::uint16_t>();
  const auto topic = reader.text(), encoding = reader.text();
  if (!reader.ok()) return;
  const auto known = schemas_.find(schema);
  topic_of_channel_[id] = topic_of(topic, known == schemas_.end() ? "" : known->second,
                                   encoding == "cdr"    ? MessageEncoding::cdr
                                   : encoding == "ros1" ? MessageEncoding::ros1
                                                        : MessageEncoding::other);
}

bool McapBag::add_statistics(Bytes data) {
  RecordReader reader(data);
  reader.get<std::uint64_t>();
  reader.get<std::uint16_t>();
  for (int i = 0; i < 4; ++i) reader.get<std::uint32_t>();
  const auto first = static_cast<std::int64_t>(reader.get<std::uint64_t>()),
             last = static_cast<std::int64_t>(reader.get<std::uint64_t>());
  RecordReader counts(reader.block());
  if (!reader.ok()) return false;
  while (!counts.at_end()) {
    const auto channel = counts.get<std::uint16_t>();
    const auto messages = static_cast<std::int64_t>(counts.get<std::uint64_t>());
    const auto topic = topic_of_channel_.find(channel);
    if (!counts.ok() || topic == topic_of_channel_.end() || messages < 0) return false;
    count(topic->second, messages, first, last);
  }
  return true;
}

void McapBag::add_chunk_index(Bytes data) {
  RecordReader reader(data);
  reader.take(2 * sizeof(std::uint64_t));
  const auto begin = reader.get<std::uint64_t>(), length = reader.get<std::uint64_t>();
  RecordReader offsets(reader.block());
  const auto index_length = reader.get<std::uint64_t>();
  if (!reader.ok() || begin > file_.size() || length > file_.size() - begin) return;
  Chunk chunk;
  while (!offsets.at_end() && offsets.ok()) {
    chunk.channels.push_back(offsets.get<std::uint16_t>());
    offsets.get<std::uint64_t>();
  }
  const auto record = record_at(file_, static_cast<std::size_t>(begin));
  if (record.end != begin + length || !open_chunk(record, chunk)) return;
  chunk.index_at = record.end;
  chunk.index_end =
      chunk.index_at + static_cast<std::size_t>(std::min<std::uint64_t>(index_length, file_.size() - chunk.index_at));
  chunk.indexed = !chunk.channels.empty();
  chunks_.push_back(std::move(chunk));
}

bool McapBag::open_chunk(const Record& record, Chunk& chunk) {
  if (record.operation != chunk_record) return false;
  RecordReader reader(record.data);
  reader.take(2 * sizeof(std::uint64_t));
  const auto size = reader.get<std::uint64_t>();
  reader.get<std::uint32_t>();
  const auto name = reader.text();
  const auto length = reader.get<std::uint64_t>();
  if (!reader.ok()) return false;
  const auto compression = compression_named(name);
  if (compression == Compression::unknown || compression == Compression::bz2) {
    note_damage("chunks compressed with '" + std::string(name) + "' cannot be read");
    return false;
  }
  const auto left = record.data.subspan(reader.at());
  chunk.part =
      store_.add(compression, left.first(static_cast<std::size_t>(std::min<std::uint64_t>(length, left.size()))), size);
  return true;
}

bool McapBag::read_summary() {
  constexpr std::size_t footer_bytes = 1 + 8 + 8 + 8 + 4;
  if (file_.size() < 2 * mcap_magic.size() + footer_bytes || !text_of(file_).ends_with(mcap_magic)) return false;
  const auto end = file_.size() - mcap_magic.size() - footer_bytes;
  const auto last = record_at(file_, end);
  const auto begin = RecordReader(last.data).get<std::uint64_t>();
  if (last.operation == footer && begin == 0) ending_ = Ending::whole;  // written without a summary
  if (last.operation != footer || begin < mcap_magic.size() || begin >= end) return false;
  std::vector<Record> records;
  for (auto at = static_cast<std::size_t>(begin); at < end;) {
    records.push_back(record_at(file_, at));
    if (!records.back().whole) return false;
    at = records.back().end;
  }
  const auto each = [&records](McapOperation operation, auto&& use) {
    for (const auto& record : records)
      if (record.operation == operation) use(record.data);
  };
  each(schema_record, [this](Bytes data) { add_schema(data); });
  each(channel_record, [this](Bytes data) { add_channel(data); });
  bool counted = false;
  std::size_t declared = 0;
  each(statistics, [&](Bytes data) { counted = add_statistics(data); });
  each(chunk_index, [&](Bytes data) {
    ++declared;
    add_chunk_index(data);
  });
  if (chunks_.size() != declared || overlapping_indices()) return false;
  ending_ = Ending::whole;
  // Without repeated channels, counts or chunks the summary does not say where messages are.
  return counted && !topic_of_channel_.empty() && declared > 0;
}

// Each index belongs to one chunk: no entry is there twice.
bool McapBag::overlapping_indices() const {
  std::vector<std::pair<std::size_t, std::size_t>> ranges;
  for (const auto& chunk : chunks_) ranges.emplace_back(chunk.index_at, chunk.index_end);
  std::ranges::sort(ranges);
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i].first < ranges[i - 1].second || ranges[i].first == ranges[i - 1].first) return true;
  return false;
}

void McapBag::count_message(std::uint16_t channel, std::int64_t time_ns) {
  if (const auto topic = topic_of_channel_.find(channel); topic != topic_of_channel_.end())
    count(topic->second, 1, time_ns, time_ns);
}

void McapBag::scan(const Run& run) {
  std::size_t at = mcap_magic.size();
  while (at < file_.size()) {
    run.check_cancel();
    run.report(static_cast<double>(at) / static_cast<double>(file_.size()), "looking for messages");
    const auto record = record_at(file_, at);
    if (record.end == 0) break;
    if (record.operation == schema_record && record.whole) add_schema(record.data);
    if (record.operation == channel_record && record.whole) add_channel(record.data);
    if (record.operation == message_record && record.whole) {
      RecordReader reader(record.data);
      const auto channel = reader.get<std::uint16_t>();
      reader.get<std::uint32_t>();
      const auto time_ns = static_cast<std::int64_t>(reader.get<std::uint64_t>());
      count_message(channel, time_ns);
      loose_[channel].push_back({time_ns, 0, outside_chunks, at});
    }
    if (Chunk chunk; open_chunk(record, chunk)) {
      chunk.index_at = chunk.index_end = record.end;
      if (!count_by_index(chunk)) scan_chunk(chunk);
      chunks_.push_back(std::move(chunk));
    }
    if (record.operation == data_end || record.operation == footer) return;
    if (!record.whole) break;
    at = record.end;
  }
  lost_share_ = 1 - static_cast<double>(at) / static_cast<double>(file_.size());
  note_damage("the file is cut off or damaged at byte " + std::to_string(at) + " of " + std::to_string(file_.size()) +
              ": what comes before is read");
}

// The index behind a chunk saves its decompression where all its channels are known.
bool McapBag::count_by_index(Chunk& chunk) {
  while (chunk.index_end < file_.size()) {
    const auto record = record_at(file_, chunk.index_end);
    if (!record.whole || record.operation != message_index) break;
    chunk.index_end = record.end;
  }
  chunk.indexed = chunk.index_end > chunk.index_at;
  std::vector<std::pair<std::uint16_t, std::int64_t>> seen;
  const auto see = [&seen](std::uint16_t channel, const BagMessage& m) { seen.emplace_back(channel, m.time_ns); };
  const auto known = [this](const auto& s) { return topic_of_channel_.contains(s.first); };
  // A file that was cut off behind a chunk may have a part of its index.
  const bool ends_here = chunk.index_end >= file_.size() || !record_at(file_, chunk.index_end).whole;
  chunk.indexed = chunk.indexed && !ends_here && visit_index(chunk, see);
  if (!chunk.indexed || !std::ranges::all_of(seen, known)) return false;
  for (const auto& [channel, time_ns] : seen) {
    if (std::ranges::find(chunk.channels, channel) == chunk.channels.end()) chunk.channels.push_back(channel);
    count_message(channel, time_ns);
  }
  return true;
}

void McapBag::scan_chunk(Chunk& chunk) {
  const auto content = store_.bytes(chunk.part);
  for (std::size_t at = 0; at < content.size();) {
    const auto record = record_at(content, at);
    if (!record.whole) break;
    if (record.operation == schema_record) add_schema(record.data);
    if (record.operation == channel_record) add_channel(record.data);
    at = record.end;
  }
  visit_records(content, chunk.part, [&](std::uint16_t channel, const BagMessage& message) {
    if (std::ranges::find(chunk.channels, channel) == chunk.channels.end()) chunk.channels.push_back(channel);
    count_message(channel, message.time_ns);
  });
}

template <class Visit>
bool McapBag::visit_index(const Chunk& chunk, Visit&& visit) const {
  if (!chunk.indexed) return false;
  for (auto at = chunk.index_at; at < chunk.index_end;) {
    const auto record = record_at(file_, at);
    if (!record.whole || record.operation != message_index) return false;
    RecordReader reader(record.data);
    const auto channel = reader.get<std::uint16_t>();
    RecordReader entries(reader.block());
    while (!entries.at_end()) {
      const auto time_ns = static_cast<std::int64_t>(entries.get<std::uint64_t>());
      const auto offset = entries.get<std::uint64_t>();
      if (!entries.ok()) return false;
      visit(channel, BagMessage{time_ns, 0, chunk.part, offset});
    }
    at = record.end;
  }
  return true;
}

template <class Visit>
void McapBag::visit_records(Bytes bytes, std::uint32_t part, Visit&& visit) const {
  bool whole = true;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto record = record_at(bytes, at);
    if (!record.whole) {
      whole = false;
      break;
    }
    if (record.operation == message_record) {
      RecordReader reader(record.data);
      const auto channel = reader.get<std::uint16_t>();
      reader.get<std::uint32_t>();
      visit(channel, BagMessage{static_cast<std::int64_t>(reader.get<std::uint64_t>()), 0, part, at});
    }
    at = record.end;
  }
  if (!whole) note_damage("a chunk of the file is damaged: the messages before the damage are read");
}

std::vector<BagMessage> McapBag::index(std::size_t topic, const Run& run) const {
  std::vector<BagMessage> out;
  const auto belongs = [&](std::uint16_t channel) {
    const auto found = topic_of_channel_.find(channel);
    return found != topic_of_channel_.end() && found->second == topic;
  };
  const auto take = [&](std::uint16_t channel, const BagMessage& message) {
    if (belongs(channel)) out.push_back(message);
  };
  for (const auto& [channel, messages] : loose_)
    if (belongs(channel)) out.insert(out.end(), messages.begin(), messages.end());
  for (const auto& chunk : chunks_) {
    run.check_cancel();
    if (!chunk.channels.empty() && std::ranges::none_of(chunk.channels, belongs)) continue;
    const auto before = out.size();
    if (visit_index(chunk, take)) continue;
    out.resize(before);
    visit_records(store_.bytes(chunk.part), chunk.part, take);
  }
  std::ranges::stable_sort(out, {}, &BagMessage::time_ns);
  if (static_cast<std::int64_t>(out.size()) != topics_[topic].messages)
    note_damage("topic " + topics_[topic].name + " has " + std::to_string(out.size()) +
                " messages, and the file declares " + std::to_string(topics_[topic].messages));
  return out;
}

Bytes McapBag::read(const BagMessage& message) const {
  const auto content = message.part == outside_chunks ? file_ : store_.bytes(message.part);
  const auto record = record_at(content, static_cast<std::size_t>(message.offset));
  constexpr std::size_t header_bytes = 2 + 4 + 8 + 8;
  if (!record.whole || record.operation != message_record || record.data.size() < header_bytes)
    throw bad_input("a message of '" + name_ + "' cannot be read: its chunk is damaged", "a whole chunk",
                    "Copy the file again from where it was recorded");
  return whole_message(record.data.subspan(header_bytes), name_, decompressed_);
}

}  // namespace bole::io
