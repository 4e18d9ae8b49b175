#include "sensor/core/hesai_encoder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "sensor/core/little_endian_writer.h"

namespace bole::sensor {
namespace {

constexpr std::uint8_t strongest_mode = 0x37, last_and_strongest_mode = 0x39;

// The constant bytes by which a packet is known.
void put_preamble(const HesaiLayout& layout, std::vector<std::uint8_t>& packet) {
  if (layout.lasers == 40) {
    for (int b = 0; b < layout.blocks; ++b)
      put_little(packet, layout.first_block + static_cast<std::size_t>(b) * layout.block_bytes, 0xEEFF, 2);
    return;
  }
  put_little(packet, 0, 0xFFEE, 2);
  packet[2] = 6;  // protocol 6.1
  packet[3] = 1;
  packet[6] = static_cast<std::uint8_t>(layout.lasers);
  packet[7] = static_cast<std::uint8_t>(layout.blocks);
  packet[9] = 4;  // millimetres per count
  packet[10] = 2;
}

}  // namespace

HesaiEncoder::HesaiEncoder(SensorModel model, double rotation_hz, bool dual, Sink sink)
    : model_(std::move(model)),
      layout_(model_.packet == PacketFormat::hesai ? hesai_layout_of(model_.rings()) : nullptr),
      turn_rad_s_(2 * std::numbers::pi * rotation_hz),
      dual_(dual),
      sink_(std::move(sink)) {
  if (layout_ == nullptr)
    throw bad_input("the sensor " + model_.name + " does not send Hesai packets that are known",
                    "a PandarXT-32 or Pandar40P");
}

std::string HesaiEncoder::correction() const {
  std::string csv = "Laser id,Elevation,Azimuth\n";
  for (std::size_t i = 0; i < model_.channels.size(); ++i)
    csv += std::to_string(i + 1) + "," + number_text(degrees(model_.channels[i].elevation_rad)) + "," +
           number_text(degrees(model_.channels[i].azimuth_offset_rad)) + "\n";
  return csv;
}

void HesaiEncoder::put_block(int block, double azimuth_rad, std::span<const LaserEcho> echoes) {
  const double turns = (azimuth_rad + turn_rad_s_ * layout_->azimuth_after_start_s) / (2 * std::numbers::pi);
  const auto azimuth = static_cast<std::uint64_t>(std::llround((turns - std::floor(turns)) * 36000)) % 36000;
  const std::size_t at = layout_->first_block + static_cast<std::size_t>(block) * layout_->block_bytes;
  put_little(packet_, at + layout_->azimuth_in_block, azimuth, 2);
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    const double counts = std::nearbyint(static_cast<double>(echoes[i].range_m) / hesai_metres_per_count);
    if (!(counts >= 1 && counts <= 65535)) continue;
    const std::size_t unit = at + layout_->block_header + i * layout_->unit_bytes;
    put_little(packet_, unit, static_cast<std::uint64_t>(counts), 2);
    packet_[unit + 2] = echoes[i].intensity;
  }
}

void HesaiEncoder::add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
                       std::span<const LaserEcho> last) {
  const std::size_t lasers = model_.channels.size();
  if (strongest.size() != lasers || (dual_ && last.size() != lasers))
    throw failure("a firing of " + std::to_string(strongest.size()) + " echoes",
                  std::to_string(lasers) + ", one per laser of the " + model_.name);
  if (block_ == 0) {
    packet_.assign(layout_->bytes, 0);
    put_preamble(*layout_, packet_);
    packet_time_s_ = time_s;
  }
  if (dual_) put_block(block_++, azimuth_rad, last);
  put_block(block_++, azimuth_rad, strongest);
  last_time_s_ = time_s;
  last_azimuth_rad_ = azimuth_rad;
  if (block_ == layout_->blocks) send();
}

// A packet is stamped after its last firing, in UTC.
void HesaiEncoder::send() {
  const auto stamp_us = std::llround(1e6 * (last_time_s_ + layout_->stamp_after_last_firing_s));
  const std::chrono::sys_time<std::chrono::microseconds> stamp{std::chrono::microseconds(stamp_us)};
  const auto day = std::chrono::floor<std::chrono::days>(stamp);
  const std::chrono::year_month_day date{day};
  const std::chrono::hh_mm_ss clock{stamp - day};
  const auto put_byte = [&](std::size_t at, std::int64_t value) { packet_[at] = static_cast<std::uint8_t>(value); };
  put_byte(layout_->date_at, static_cast<int>(date.year()) - 1900);
  put_byte(layout_->date_at + 1, static_cast<unsigned>(date.month()));
  put_byte(layout_->date_at + 2, static_cast<unsigned>(date.day()));
  put_byte(layout_->date_at + 3, clock.hours().count());
  put_byte(layout_->date_at + 4, clock.minutes().count());
  put_byte(layout_->date_at + 5, clock.seconds().count());
  put_little(packet_, layout_->time_us_at, static_cast<std::uint64_t>(clock.subseconds().count()), 4);
  packet_[layout_->return_mode_at] = dual_ ? last_and_strongest_mode : strongest_mode;
  sink_(packet_, packet_time_s_);
  block_ = 0;
}

void HesaiEncoder::flush() {
  const std::vector<LaserEcho> nothing(model_.channels.size());
  while (block_ != 0)
    add(last_time_s_ + model_.sequence_period_s, last_azimuth_rad_ + turn_rad_s_ * model_.sequence_period_s, nothing,
        nothing);
}

}  // namespace bole::sensor
