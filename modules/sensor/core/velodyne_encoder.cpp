#include "sensor/core/velodyne_encoder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"

namespace bole::sensor {
namespace {

constexpr std::uint16_t unused_block = 0;

std::uint16_t centidegrees(double azimuth_rad) {
  const double turn = std::nearbyint(azimuth_rad * 18000 / std::numbers::pi);
  const auto wrapped = static_cast<int>(turn - 36000 * std::floor(turn / 36000));
  return static_cast<std::uint16_t>(wrapped % 36000);
}

}  // namespace

VelodyneEncoder::VelodyneEncoder(SensorModel model, VelodyneReturnMode mode, Sink sink)
    : model_(std::move(model)), mode_(mode), sink_(std::move(sink)) {
  if (model_.packet != PacketFormat::velodyne)
    throw bad_input("the sensor " + model_.name + " does not send Velodyne packets", "a Velodyne sensor");
  if (mode == VelodyneReturnMode::dual && !model_.dual_return)
    throw bad_input("the sensor " + model_.name + " has no dual return", "strongest or last");
  packet_.return_mode = static_cast<std::uint8_t>(mode);
  packet_.product_id = model_.product_id.value_or(0);
}

void VelodyneEncoder::fill(VelodyneBlock& block, int first_record, std::span<const LaserEcho> echoes) const {
  for (std::size_t i = 0; i < echoes.size(); ++i) {
    const double counts = std::nearbyint(echoes[i].range_m / model_.range_quantum_m);
    const bool fits = counts >= 1 && counts <= 65535;
    block.records[static_cast<std::size_t>(first_record) + i] =
        fits ? VelodyneRecord{static_cast<std::uint16_t>(counts), echoes[i].intensity} : VelodyneRecord{};
  }
}

void VelodyneEncoder::add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
                          std::span<const LaserEcho> last) {
  const std::size_t lasers = model_.channels.size();
  const bool dual = mode_ == VelodyneReturnMode::dual;
  if (strongest.size() != lasers || (dual && last.size() != lasers))
    throw failure("a firing sequence of " + std::to_string(strongest.size()) + " echoes",
                  std::to_string(lasers) + ", one per laser of the " + model_.name);
  if (block_ == 0 && sequence_ == 0) packet_time_s_ = time_s;
  advance_rad_ = std::remainder(azimuth_rad - last_azimuth_rad_, 2 * std::numbers::pi);
  last_azimuth_rad_ = azimuth_rad;
  last_time_s_ = time_s;
  constexpr std::array flags{velodyne_upper_block, velodyne_lower_block, velodyne_third_block, velodyne_fourth_block};
  const std::size_t banks = std::max<std::size_t>(1, lasers / velodyne_records);
  const std::size_t in_bank = lasers / banks;
  const int record = sequence_ * static_cast<int>(lasers);
  int block = block_;
  for (std::size_t bank = 0; bank < banks; ++bank)
    for (int echo = dual ? 0 : 1; echo < 2; ++echo) {  // dual: the last return, then the strongest
      auto& b = packet_.blocks[static_cast<std::size_t>(block++)];
      if (sequence_ == 0) {
        b.flag = flags[bank];
        b.azimuth_centideg = centidegrees(azimuth_rad);
      }
      fill(b, record, (echo == 0 ? last : strongest).subspan(bank * in_bank, in_bank));
    }
  if (++sequence_ < model_.sequences_per_block) return;
  sequence_ = 0;
  const int blocks = block - block_;
  block_ = block;
  if (block_ + blocks <= velodyne_blocks) return;
  for (; block_ < velodyne_blocks; ++block_)  // a firing sequence does not go on in the next packet
    packet_.blocks[static_cast<std::size_t>(block_)] = VelodyneBlock{.flag = unused_block, .records = {}};
  send();
}

void VelodyneEncoder::send() {
  const double past_hour_s = packet_time_s_ - 3600 * std::floor(packet_time_s_ / 3600);
  packet_.time_us = static_cast<std::uint32_t>(std::llround(past_hour_s * 1e6) % 3'600'000'000LL);
  sink_(pack_velodyne_packet(packet_), packet_time_s_);
  block_ = 0;
  sequence_ = 0;
}

void VelodyneEncoder::flush() {
  const std::vector<LaserEcho> nothing(model_.channels.size());
  const double advance_rad = advance_rad_;
  while (block_ != 0 || sequence_ != 0)
    add(last_time_s_ + model_.sequence_period_s, last_azimuth_rad_ + advance_rad, nothing, nothing);
}

}  // namespace bole::sensor
