#include "io/core/bags/messages.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "io/core/bags/message_reader.h"

namespace bole::io {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::array<std::size_t, 9> type_bytes{0, 1, 1, 2, 2, 4, 4, 4, 8};

MessageHeader header_of(MessageReader& reader) {
  if (reader.ros1()) reader.get<std::uint32_t>();  // running number
  MessageHeader header;
  header.stamp_ns = reader.time_ns();
  header.frame_id = reader.text();
  return header;
}

Eigen::Vector3d vector_of(MessageReader& reader) {
  const auto x = reader.get<double>(), y = reader.get<double>(), z = reader.get<double>();
  return {x, y, z};
}

// A number that the other type can hold. What is no number stays one where the type has it, else it is 0.
template <class T>
T converted(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    return std::abs(value) < 9e18 ? static_cast<T>(value) : T{0};
  }
}

template <class From, class To>
void convert(const CloudMessage& message, const CloudField& field, std::vector<To>& out) {
  for (std::size_t i = 0; i < message.size(); ++i) {
    const auto value = load<From>(message.point(i) + field.offset, message.big_endian);
    if constexpr (std::is_floating_point_v<From>)
      out[i] = converted<To>(value);
    else
      out[i] = static_cast<To>(value);  // NOLINT(bugprone-signed-char-misuse): a field of int8 holds numbers
  }
}

}  // namespace

std::string_view field_type_name(FieldType type) {
  constexpr std::array<std::string_view, 9> names{"none",  "int8",   "uint8",   "int16",  "uint16",
                                                  "int32", "uint32", "float32", "float64"};
  return names[static_cast<std::size_t>(type)];
}

template <class T>
void CloudMessage::values(const CloudField& field, std::vector<T>& out) const {
  out.assign(size(), T{});
  switch (field.type) {
    case FieldType::int8:
      return convert<std::int8_t>(*this, field, out);
    case FieldType::uint8:
      return convert<std::uint8_t>(*this, field, out);
    case FieldType::int16:
      return convert<std::int16_t>(*this, field, out);
    case FieldType::uint16:
      return convert<std::uint16_t>(*this, field, out);
    case FieldType::int32:
      return convert<std::int32_t>(*this, field, out);
    case FieldType::uint32:
      return convert<std::uint32_t>(*this, field, out);
    case FieldType::float32:
      return convert<float>(*this, field, out);
    case FieldType::float64:
      return convert<double>(*this, field, out);
  }
}

template void CloudMessage::values(const CloudField&, std::vector<float>&) const;
template void CloudMessage::values(const CloudField&, std::vector<double>&) const;
template void CloudMessage::values(const CloudField&, std::vector<std::int64_t>&) const;

std::int64_t parse_stamp_ns(Bytes message, MessageEncoding encoding) {
  MessageReader reader(message, encoding);
  return header_of(reader).stamp_ns;
}

CloudMessage parse_cloud(Bytes message, MessageEncoding encoding) {
  MessageReader reader(message, encoding);
  CloudMessage out;
  out.header = header_of(reader);
  out.height = reader.get<std::uint32_t>();
  out.width = reader.get<std::uint32_t>();
  std::vector<CloudField> fields(reader.length(13));
  for (auto& field : fields) {
    field.name = std::string(reader.text());
    field.offset = reader.get<std::uint32_t>();
    field.type = static_cast<FieldType>(reader.get<std::uint8_t>());
    field.count = reader.get<std::uint32_t>();
  }
  out.big_endian = reader.get<std::uint8_t>() != 0;
  out.point_step = reader.get<std::uint32_t>();
  out.row_step = reader.get<std::uint32_t>();
  out.data = reader.byte_sequence();
  for (auto& field : fields) {
    const auto type = static_cast<std::size_t>(field.type);
    if (type == 0 || type >= type_bytes.size()) continue;
    if (std::uint64_t{field.offset} + type_bytes[type] <= out.point_step) out.fields.push_back(std::move(field));
  }
  const std::uint64_t row_bytes = std::uint64_t{out.width} * out.point_step;
  out.declared = static_cast<std::size_t>(std::uint64_t{out.width} * out.height);
  if (out.point_step == 0 || out.width == 0) return out;
  out.padded_ = out.height > 1 && out.row_step > row_bytes;
  if (out.padded_) {
    const auto rows = std::min<std::uint64_t>(out.height, out.data.size() / out.row_step);
    const auto rest = rows < out.height
                          ? std::min<std::uint64_t>(out.width, (out.data.size() - rows * out.row_step) / out.point_step)
                          : 0;
    out.held_ = static_cast<std::size_t>(rows * out.width + rest);
  } else {
    out.held_ = std::min(out.declared, out.data.size() / out.point_step);
  }
  return out;
}

void parse_livox(Bytes message, MessageEncoding encoding, LivoxMessage& out) {
  MessageReader reader(message, encoding);
  out.header = header_of(reader);
  out.timebase_ns = reader.get<std::uint64_t>();
  reader.get<std::uint32_t>();  // number of points, as the length below
  reader.take(4);               // unit and three reserved bytes
  constexpr std::size_t point_bytes = 19;
  out.points.resize(reader.length(point_bytes));
  for (auto& point : out.points) {
    point.offset_ns = reader.get<std::uint32_t>();
    for (int axis = 0; axis < 3; ++axis) point.position[axis] = reader.get<float>();
    point.reflectivity = reader.get<std::uint8_t>();
    point.tag = reader.get<std::uint8_t>();
    point.line = reader.get<std::uint8_t>();
  }
}

void parse_velodyne_scan(Bytes message, MessageEncoding encoding, std::vector<StampedPacket>& out) {
  constexpr std::size_t packet_bytes = 1206;
  MessageReader reader(message, encoding);
  header_of(reader);
  out.resize(reader.length(8 + packet_bytes));
  for (auto& packet : out) {
    packet.time_ns = reader.time_ns();
    packet.bytes = reader.take(packet_bytes);
  }
}

ImuMessage parse_imu(Bytes message, MessageEncoding encoding) {
  MessageReader reader(message, encoding);
  ImuMessage out;
  out.header = header_of(reader);
  constexpr int covariance = 9, quaternion = 4;
  for (int i = 0; i < quaternion + covariance; ++i) reader.get<double>();
  out.angular_rate = vector_of(reader);
  for (int i = 0; i < covariance; ++i) reader.get<double>();
  out.acceleration = vector_of(reader);
  return out;
}

Bytes parse_ouster_packet(Bytes message, MessageEncoding encoding) {
  const auto packet = MessageReader(message, encoding).byte_sequence();
  return packet.first(packet.size() / 4 * 4);
}

std::string_view parse_text(Bytes message, MessageEncoding encoding) { return MessageReader(message, encoding).text(); }

}  // namespace bole::io
