// Writers of ROS messages and bags for tests: small, and independent of the readers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bole::testing_bags {

enum class Wire { ros1, cdr_little, cdr_big };

class MessageWriter {
 public:
  explicit MessageWriter(Wire wire) : wire_(wire) {
    if (wire != Wire::ros1) out_ = {'\0', wire == Wire::cdr_little ? '\1' : '\0', '\0', '\0'};
  }
  template <class T>
  MessageWriter& put(T value) {
    if (wire_ != Wire::ros1)
      while ((out_.size() - 4) % sizeof(T) != 0) out_ += '\0';
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (wire_ == Wire::cdr_big) std::reverse(bytes.begin(), bytes.end());
    out_.append(bytes.data(), bytes.size());
    return *this;
  }
  MessageWriter& text(std::string_view text) {
    const bool ended = wire_ != Wire::ros1;
    put(static_cast<std::uint32_t>(text.size() + (ended ? 1 : 0)));
    out_ += text;
    if (ended) out_ += '\0';
    return *this;
  }
  MessageWriter& blob(std::string_view bytes) {
    put(static_cast<std::uint32_t>(bytes.size()));
    out_ += bytes;
    return *this;
  }
  MessageWriter& raw(std::string_view bytes) {
    out_ += bytes;
    return *this;
  }
  MessageWriter& time(std::int64_t ns) {
    put(static_cast<std::uint32_t>(ns / 1'000'000'000));
    return put(static_cast<std::uint32_t>(ns % 1'000'000'000));
  }
  MessageWriter& header(std::int64_t stamp_ns, std::string_view frame = "lidar") {
    if (wire_ == Wire::ros1) put(std::uint32_t{7});
    return time(stamp_ns).text(frame);
  }
  const std::string& bytes() const { return out_; }

 private:
  Wire wire_;
  std::string out_;
};

// A field of a cloud: name, type as in PointField, and its value for point i.
struct CloudColumn {
  std::string name;
  int type;
  std::function<double(std::size_t)> value;
};
enum PointFieldType { u8 = 2, u16 = 4, u32 = 6, f32 = 7, f64 = 8 };

struct CloudShape {
  std::uint32_t height = 1, width = 0;
  std::size_t padding = 0;  // bytes behind each row
  bool big_endian = false;
};

inline std::string cloud_message(Wire wire, std::int64_t stamp_ns, const std::vector<CloudColumn>& columns,
                                 const CloudShape& shape, std::string_view frame = "lidar") {
  const auto size_of = [](int type) {
    return type == f64 ? 8U : type == f32 || type == u32 ? 4U : type == u16 ? 2U : 1U;
  };
  MessageWriter out(wire);
  out.header(stamp_ns, frame).put(shape.height).put(shape.width).put(static_cast<std::uint32_t>(columns.size()));
  std::uint32_t step = 0;
  for (const auto& c : columns) {
    out.text(c.name).put(step).put(static_cast<std::uint8_t>(c.type)).put(std::uint32_t{1});
    step += size_of(c.type);
  }
  std::string data;
  const auto add = [&](auto value) {
    std::array<char, sizeof(value)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(value));
    if (shape.big_endian) std::reverse(bytes.begin(), bytes.end());
    data.append(bytes.data(), bytes.size());
  };
  for (std::uint32_t row = 0; row < shape.height; ++row) {
    for (std::uint32_t k = 0; k < shape.width; ++k)
      for (const auto& c : columns) {
        const double v = c.value(std::size_t{row} * shape.width + k);
        switch (c.type) {
          case u8:
            add(static_cast<std::uint8_t>(v));
            break;
          case u16:
            add(static_cast<std::uint16_t>(v));
            break;
          case u32:
            add(static_cast<std::uint32_t>(v));
            break;
          case f32:
            add(static_cast<float>(v));
            break;
          default:
            add(v);
        }
      }
    data.append(shape.padding, '\xAA');
  }
  const auto row_step = static_cast<std::uint32_t>(shape.width * step + shape.padding);
  out.put(static_cast<std::uint8_t>(shape.big_endian)).put(step).put(row_step).blob(data).put(std::uint8_t{1});
  return out.bytes();
}

inline std::string imu_message(Wire wire, std::int64_t stamp_ns, std::array<double, 3> rate,
                               std::array<double, 3> force) {
  MessageWriter out(wire);
  out.header(stamp_ns, "imu");
  for (int i = 0; i < 4 + 9; ++i) out.put(0.25 * i);
  for (const double v : rate) out.put(v);
  for (int i = 0; i < 9; ++i) out.put(-1.0 * i);
  for (const double v : force) out.put(v);
  for (int i = 0; i < 9; ++i) out.put(0.0);
  return out.bytes();
}

struct LivoxTestPoint {
  std::uint32_t offset_ns;
  float x, y, z;
  std::uint8_t reflectivity, tag, line;
};
inline std::string livox_message(Wire wire, std::int64_t stamp_ns, const std::vector<LivoxTestPoint>& points) {
  MessageWriter out(wire);
  out.header(stamp_ns, "livox")
      .put(static_cast<std::uint64_t>(stamp_ns))
      .put(static_cast<std::uint32_t>(points.size()));
  for (int i = 0; i < 4; ++i) out.put(static_cast<std::uint8_t>(i));
  out.put(static_cast<std::uint32_t>(points.size()));
  for (const auto& p : points)
    out.put(p.offset_ns).put(p.x).put(p.y).put(p.z).put(p.reflectivity).put(p.tag).put(p.line);
  return out.bytes();
}

inline std::string velodyne_message(Wire wire, std::int64_t stamp_ns,
                                    const std::vector<std::pair<std::int64_t, std::string>>& packets) {
  MessageWriter out(wire);
  out.header(stamp_ns, "velodyne").put(static_cast<std::uint32_t>(packets.size()));
  for (const auto& [time_ns, bytes] : packets) out.time(time_ns).raw(bytes);
  return out.bytes();
}

// What a bag holds, in order of recording.
struct Message {
  std::string topic, type;
  std::int64_t time_ns;
  std::string bytes;
};

using Compress = std::function<std::string(const std::string&)>;

template <class T>
void append(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

// Version 2.0, little-endian.
class Ros1Writer {
 public:
  std::string compression = "none";
  Compress compress = [](const std::string& s) { return s; };
  std::size_t messages_per_chunk = 3;
  bool closed = true;         // else: no index at the end
  bool chunk_indices = true;  // the index behind each chunk

  std::string write(const std::vector<Message>& messages) const {
    std::map<std::string, std::uint32_t> id_of;
    std::string connections, infos, body;
    const std::string magic = "#ROSBAG V2.0\n";
    constexpr std::size_t header_bytes = 4096;
    const std::size_t start = magic.size() + header_bytes;
    std::uint32_t chunks = 0;
    for (std::size_t first = 0; first < messages.size(); first += messages_per_chunk, ++chunks) {
      std::string content, counts;
      std::map<std::uint32_t, std::string> entries;
      const auto end = std::min(first + messages_per_chunk, messages.size());
      for (std::size_t i = first; i < end; ++i) {
        const auto& m = messages[i];
        if (!id_of.contains(m.topic)) {
          const auto id = static_cast<std::uint32_t>(id_of.size());
          id_of[m.topic] = id;
          const auto record =
              this->record({{"op", "\7"}, {"conn", number(id)}, {"topic", m.topic}},
                           fields({{"topic", m.topic}, {"type", m.type}, {"md5sum", "*"}, {"message_definition", ""}}));
          connections += record;
          content += record;
        }
        const auto id = id_of[m.topic];
        append(entries[id], static_cast<std::uint32_t>(m.time_ns / 1'000'000'000));
        append(entries[id], static_cast<std::uint32_t>(m.time_ns % 1'000'000'000));
        append(entries[id], static_cast<std::uint32_t>(content.size()));
        content += record({{"op", "\2"}, {"conn", number(id)}, {"time", time(m.time_ns)}}, m.bytes);
      }
      const auto position = static_cast<std::uint64_t>(start + body.size());
      body += record(
          {{"op", "\5"}, {"compression", compression}, {"size", number(static_cast<std::uint32_t>(content.size()))}},
          compress(content));
      for (const auto& [id, data] : entries) {
        const auto count = static_cast<std::uint32_t>(data.size() / 12);
        if (chunk_indices)
          body += record({{"op", "\4"}, {"ver", number(1U)}, {"conn", number(id)}, {"count", number(count)}}, data);
        counts += number(id) + number(count);
      }
      infos += record({{"op", "\6"},
                       {"ver", number(1U)},
                       {"chunk_pos", number(position)},
                       {"start_time", time(messages[first].time_ns)},
                       {"end_time", time(messages[end - 1].time_ns)},
                       {"count", number(static_cast<std::uint32_t>(entries.size()))}},
                      counts);
    }
    const auto index_pos = closed ? static_cast<std::uint64_t>(start + body.size()) : 0;
    const auto head = fields({{"op", "\3"},
                              {"index_pos", number(index_pos)},
                              {"conn_count", number(static_cast<std::uint32_t>(id_of.size()))},
                              {"chunk_count", number(chunks)}});
    std::string out = magic;
    append(out, static_cast<std::uint32_t>(head.size()));
    out += head;
    append(out, static_cast<std::uint32_t>(header_bytes - 8 - head.size()));
    out.resize(start, ' ');
    return out + body + (closed ? connections + infos : "");
  }

 private:
  using Fields = std::vector<std::pair<std::string, std::string>>;
  template <class T>
  static std::string number(T value) {
    std::string out;
    append(out, value);
    return out;
  }
  static std::string time(std::int64_t ns) {
    return number(static_cast<std::uint32_t>(ns / 1'000'000'000)) +
           number(static_cast<std::uint32_t>(ns % 1'000'000'000));
  }
  static std::string fields(const Fields& list) {
    std::string out;
    for (const auto& [name, value] : list)
      out += number(static_cast<std::uint32_t>(name.size() + 1 + value.size())) + name + "=" + value;
    return out;
  }
  std::string record(const Fields& header, const std::string& data) const {
    const auto head = fields(header);
    return number(static_cast<std::uint32_t>(head.size())) + head + number(static_cast<std::uint32_t>(data.size())) +
           data;
  }
};

class McapWriter {
 public:
  std::string compression;
  Compress compress = [](const std::string& s) { return s; };
  std::size_t messages_per_chunk = 3;  // 0: no chunks
  std::string encoding = "cdr";
  bool summary = true, message_indices = true;

  std::string write(const std::vector<Message>& messages) const {
    const std::string magic("\x89MCAP0\r\n", 8);
    std::string out = magic + record(1, text("ros2") + text("test"));
    std::map<std::string, std::uint16_t> id_of;
    std::map<std::uint16_t, std::uint64_t> counts;
    std::string definitions, chunk_records;
    std::uint32_t chunks = 0;
    const auto step = messages_per_chunk == 0 ? std::max<std::size_t>(1, messages.size()) : messages_per_chunk;
    for (std::size_t first = 0; first < messages.size(); first += step) {
      std::string content;
      std::map<std::uint16_t, std::string> entries;
      const auto end = std::min(first + step, messages.size());
      for (std::size_t i = first; i < end; ++i) {
        const auto& m = messages[i];
        if (!id_of.contains(m.topic)) {
          const auto id = static_cast<std::uint16_t>(id_of.size() + 1);
          id_of[m.topic] = id;
          const auto both = record(3, number(id) + text(m.type) + text("ros2msg") + text("")) +
                            record(4, number(id) + number(id) + text(m.topic) + text(encoding) + text(""));
          definitions += both;
          content += both;
        }
        const auto id = id_of[m.topic];
        ++counts[id];
        entries[id] +=
            number(static_cast<std::uint64_t>(m.time_ns)) + number(static_cast<std::uint64_t>(content.size()));
        content += record(5, number(id) + number(static_cast<std::uint32_t>(i)) +
                                 number(static_cast<std::uint64_t>(m.time_ns)) +
                                 number(static_cast<std::uint64_t>(m.time_ns)) + m.bytes);
      }
      if (messages_per_chunk == 0) {
        out += content;
        continue;
      }
      ++chunks;
      const auto stored = compress(content);
      const auto times = number(static_cast<std::uint64_t>(messages[first].time_ns)) +
                         number(static_cast<std::uint64_t>(messages[end - 1].time_ns));
      const auto begin = static_cast<std::uint64_t>(out.size());
      out += record(6, times + number(static_cast<std::uint64_t>(content.size())) + number(0U) + text(compression) +
                           number(static_cast<std::uint64_t>(stored.size())) + stored);
      const auto length = static_cast<std::uint64_t>(out.size()) - begin;
      const auto index_at = static_cast<std::uint64_t>(out.size());
      std::string offsets;
      for (const auto& [id, list] : entries) {
        if (!message_indices) break;
        offsets += number(id) + number(static_cast<std::uint64_t>(out.size()));
        out += record(7, number(id) + number(static_cast<std::uint32_t>(list.size())) + list);
      }
      chunk_records +=
          record(8, times + number(begin) + number(length) + number(static_cast<std::uint32_t>(offsets.size())) +
                        offsets + number(static_cast<std::uint64_t>(out.size()) - index_at) + text(compression) +
                        number(static_cast<std::uint64_t>(stored.size())) +
                        number(static_cast<std::uint64_t>(content.size())));
    }
    out += record(15, number(0U));
    const auto summary_at = static_cast<std::uint64_t>(summary ? out.size() : 0);
    if (summary) {
      std::string channel_counts;
      for (const auto& [id, count] : counts) channel_counts += number(id) + number(count);
      const auto first = messages.empty() ? 0 : messages.front().time_ns,
                 last = messages.empty() ? 0 : messages.back().time_ns;
      out +=
          definitions +
          record(11, number(static_cast<std::uint64_t>(messages.size())) +
                         number(static_cast<std::uint16_t>(id_of.size())) +
                         number(static_cast<std::uint32_t>(id_of.size())) + number(0U) + number(0U) + number(chunks) +
                         number(static_cast<std::uint64_t>(first)) + number(static_cast<std::uint64_t>(last)) +
                         number(static_cast<std::uint32_t>(channel_counts.size())) + channel_counts) +
          chunk_records;
    }
    return out + record(2, number(summary_at) + number(std::uint64_t{0}) + number(0U)) + magic;
  }

 private:
  template <class T>
  static std::string number(T value) {
    std::string out;
    append(out, value);
    return out;
  }
  static std::string text(const std::string& value) { return number(static_cast<std::uint32_t>(value.size())) + value; }
  static std::string record(int operation, const std::string& data) {
    return std::string(1, static_cast<char>(operation)) + number(static_cast<std::uint64_t>(data.size())) + data;
  }
};

}  // namespace bole::testing_bags
