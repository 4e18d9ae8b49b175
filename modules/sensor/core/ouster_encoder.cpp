#include "sensor/core/ouster_encoder.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "sensor/core/little_endian_writer.h"

namespace bole::sensor {
namespace {

constexpr std::size_t packet_header_bytes = 32, packet_footer_bytes = 32, column_header_bytes = 12;
constexpr int columns_in_packet = 16;
constexpr std::uint64_t serial_number = 122'000'000'001;

std::size_t pixel_bytes(bool dual) { return dual ? 16 : 12; }

// Range in millimetres (19 bits); 0 is no return.
std::uint32_t range_bits(const LaserEcho& echo) {
  constexpr double max_counts = 0x7FFFF;
  const double counts = std::nearbyint(1e3 * static_cast<double>(echo.range_m));
  return counts >= 1 && counts <= max_counts ? static_cast<std::uint32_t>(counts) : 0;
}

// "OS1-128" is the product line OS-1-128.
std::string product_line(const SensorModel& model) {
  auto name = model.id;
  std::ranges::replace(name, '_', '-');
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name.size() > 2 ? "OS-" + name.substr(2) : name;
}

nlohmann::json row_major(std::initializer_list<double> numbers) { return std::vector<double>(numbers); }

}  // namespace

OusterEncoder::OusterEncoder(SensorModel model, double rotation_hz, bool dual, Sink sink)
    : model_(std::move(model)), rotation_hz_(rotation_hz), dual_(dual), sink_(std::move(sink)) {
  if (model_.packet != PacketFormat::ouster)
    throw bad_input("the sensor " + model_.name + " does not send Ouster packets", "an Ouster sensor");
  const double columns = 1 / (rotation_hz * model_.sequence_period_s);
  columns_ = static_cast<int>(std::lround(columns));
  if (columns_ < columns_in_packet || columns_ > 8192 || std::abs(columns - columns_) > 1e-6 ||
      columns_ % columns_in_packet != 0)
    throw bad_input("a turn of the " + model_.name + " at " + number_text(rotation_hz) +
                        " revolutions per second has " + number_text(columns) + " columns",
                    "a multiple of 16, as with 5, 10 or 20 revolutions per second");
}

std::string OusterEncoder::metadata() const {
  std::vector<double> elevations_deg, azimuths_deg;
  for (const auto& c : model_.channels) {
    elevations_deg.push_back(degrees(c.elevation_rad));
    azimuths_deg.push_back(degrees(c.azimuth_offset_rad));
  }
  const auto lines = model_.channels.size();
  const std::string mode = std::to_string(columns_) + "x" + number_text(rotation_hz_);
  const nlohmann::json root{
      {"beam_intrinsics",
       {{"beam_altitude_angles", elevations_deg},
        {"beam_azimuth_angles", azimuths_deg},
        {"lidar_origin_to_beam_origin_mm", 0.0},
        {"beam_to_lidar_transform", row_major({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})}}},
      {"lidar_data_format",
       {{"columns_per_frame", columns_},
        {"columns_per_packet", columns_in_packet},
        {"column_window", {0, columns_ - 1}},
        {"pixels_per_column", lines},
        {"pixel_shift_by_row", std::vector<int>(lines)},
        {"fps", static_cast<int>(std::lround(rotation_hz_))},
        {"udp_profile_lidar", dual_ ? "RNG19_RFL8_SIG16_NIR16_DUAL" : "RNG19_RFL8_SIG16_NIR16"},
        {"udp_profile_imu", "LEGACY"}}},
      {"lidar_intrinsics",
       {{"lidar_to_sensor_transform", row_major({-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})}}},
      {"imu_intrinsics", {{"imu_to_sensor_transform", row_major({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})}}},
      {"sensor_info",
       {{"prod_line", product_line(model_)},
        {"prod_sn", std::to_string(serial_number)},
        {"status", "RUNNING"},
        {"build_rev", "v3.0.0"}}},
      {"config_params",
       {{"lidar_mode", mode},
        {"udp_port_lidar", lidar_port},
        {"udp_profile_lidar", dual_ ? "RNG19_RFL8_SIG16_NIR16_DUAL" : "RNG19_RFL8_SIG16_NIR16"}}}};
  return root.dump(1) + "\n";
}

void OusterEncoder::start_packet(int first_column, double time_s) {
  const std::size_t column_bytes = column_header_bytes + model_.channels.size() * pixel_bytes(dual_);
  packet_.assign(packet_header_bytes + columns_in_packet * column_bytes + packet_footer_bytes, 0);
  put_little(packet_, 0, 1, 2);  // a lidar packet
  put_little(packet_, 2, frame_id_, 2);
  put_little(packet_, 7, serial_number, 5);
  for (int i = 0; i < columns_in_packet; ++i)
    put_little(packet_, packet_header_bytes + static_cast<std::size_t>(i) * column_bytes + 8,
               static_cast<std::uint64_t>(first_column + i), 2);
  first_column_ = first_column;
  packet_time_s_ = time_s;
}

void OusterEncoder::put_pixel(std::size_t at, LaserEcho first, LaserEcho second) {
  const auto range = range_bits(first);
  put_little(packet_, at, range, 3);
  if (!dual_) {
    put_little(packet_, at + 4, first.intensity, 1);
    put_little(packet_, at + 6, first.intensity, 2);  // the signal
    return;
  }
  put_little(packet_, at + 3, first.intensity, 1);
  put_little(packet_, at + 8, first.intensity, 2);
  const auto other = range_bits(second);
  if (other == 0 || other == range) return;
  put_little(packet_, at + 4, other, 3);
  put_little(packet_, at + 7, second.intensity, 1);
  put_little(packet_, at + 10, second.intensity, 2);
}

void OusterEncoder::add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
                        std::span<const LaserEcho> second) {
  const std::size_t lasers = model_.channels.size();
  if (strongest.size() != lasers || (dual_ && second.size() != lasers))
    throw failure("a column of " + std::to_string(strongest.size()) + " echoes",
                  std::to_string(lasers) + ", one per laser of the " + model_.name);
  // Columns count from the axis behind the sensor.
  const double turns = azimuth_rad / (2 * std::numbers::pi) + 0.5;
  const int column = static_cast<int>(std::lround((turns - std::floor(turns)) * columns_)) % columns_;
  const int first_column = column / columns_in_packet * columns_in_packet;
  const bool next_turn = last_column_ >= 0 && column <= last_column_;
  if (first_column_ >= 0 && (first_column != first_column_ || next_turn)) flush();
  if (next_turn) ++frame_id_;
  if (first_column_ < 0) start_packet(first_column, time_s);
  last_column_ = column;
  const std::size_t column_bytes = column_header_bytes + lasers * pixel_bytes(dual_);
  const std::size_t at = packet_header_bytes + static_cast<std::size_t>(column - first_column) * column_bytes;
  put_little(packet_, at, static_cast<std::uint64_t>(std::llround(time_s * 1e9)), 8);
  put_little(packet_, at + 10, 1, 2);  // valid
  for (std::size_t i = 0; i < lasers; ++i)
    put_pixel(at + column_header_bytes + i * pixel_bytes(dual_), strongest[i], dual_ ? second[i] : LaserEcho{});
}

void OusterEncoder::flush() {
  if (first_column_ < 0) return;
  sink_(packet_, packet_time_s_);
  first_column_ = -1;
}

}  // namespace bole::sensor
