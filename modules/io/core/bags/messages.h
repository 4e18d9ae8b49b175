// The ROS messages that are read. Texts and blocks point into the message, and are valid as long as it is.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/core/bags/bag.h"

namespace bole::io {

namespace message_type {
inline constexpr std::string_view cloud = "sensor_msgs/PointCloud2";
inline constexpr std::string_view velodyne = "velodyne_msgs/VelodyneScan";
inline constexpr std::string_view livox = "livox_ros_driver/CustomMsg", livox2 = "livox_ros_driver2/CustomMsg";
inline constexpr std::string_view livox_interfaces = "livox_interfaces/CustomMsg";
inline constexpr std::string_view ouster = "ouster_sensor_msgs/PacketMsg", ouster_ros = "ouster_ros/PacketMsg";
inline constexpr std::string_view text = "std_msgs/String";
inline constexpr std::string_view imu = "sensor_msgs/Imu";
}  // namespace message_type

struct MessageHeader {
  std::int64_t stamp_ns = 0;
  std::string_view frame_id;
};

enum class FieldType : std::uint8_t { int8 = 1, uint8, int16, uint16, int32, uint32, float32, float64 };
std::string_view field_type_name(FieldType type);  // "float32"

struct CloudField {
  std::string name;
  std::uint32_t offset = 0;
  FieldType type{};
  std::uint32_t count = 1;
  bool operator==(const CloudField&) const = default;
};

// sensor_msgs/PointCloud2. Fields that do not fit in a point are left out.
struct CloudMessage {
  MessageHeader header;
  std::uint32_t height = 0, width = 0;
  std::vector<CloudField> fields;
  bool big_endian = false;
  std::uint32_t point_step = 0, row_step = 0;
  Bytes data;
  std::size_t declared = 0;  // points by the header

  // Points that the data hold, and the first byte of one.
  std::size_t size() const { return held_; }
  const std::uint8_t* point(std::size_t index) const {
    return data.data() + (padded_ ? index / width * row_step + index % width * point_step : index * point_step);
  }
  // The values of a field as numbers of another type.
  template <class T>
  void values(const CloudField& field, std::vector<T>& out) const;

 private:
  friend CloudMessage parse_cloud(Bytes message, MessageEncoding encoding);
  std::size_t held_ = 0;
  bool padded_ = false;  // rows have bytes behind their points
};
CloudMessage parse_cloud(Bytes message, MessageEncoding encoding);
// The stamp of any message that begins with a header.
std::int64_t parse_stamp_ns(Bytes message, MessageEncoding encoding);

extern template void CloudMessage::values(const CloudField&, std::vector<float>&) const;
extern template void CloudMessage::values(const CloudField&, std::vector<double>&) const;
extern template void CloudMessage::values(const CloudField&, std::vector<std::int64_t>&) const;

// CustomMsg of the Livox drivers.
struct LivoxPoint {
  std::uint32_t offset_ns = 0;  // after LivoxMessage::timebase_ns
  Eigen::Vector3f position;
  std::uint8_t reflectivity = 0, tag = 0, line = 0;
};
struct LivoxMessage {
  MessageHeader header;
  std::uint64_t timebase_ns = 0;
  std::vector<LivoxPoint> points;
};
void parse_livox(Bytes message, MessageEncoding encoding, LivoxMessage& out);

// velodyne_msgs/VelodyneScan
struct StampedPacket {
  std::int64_t time_ns = 0;
  Bytes bytes;
};
void parse_velodyne_scan(Bytes message, MessageEncoding encoding, std::vector<StampedPacket>& out);

// PacketMsg of the Ouster drivers: one packet, without the byte that older drivers put behind it.
Bytes parse_ouster_packet(Bytes message, MessageEncoding encoding);

// std_msgs/String
std::string_view parse_text(Bytes message, MessageEncoding encoding);

// sensor_msgs/Imu
struct ImuMessage {
  MessageHeader header;
  Eigen::Vector3d angular_rate, acceleration;
};
ImuMessage parse_imu(Bytes message, MessageEncoding encoding);

}  // namespace bole::io
