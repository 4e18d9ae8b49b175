#include "sensor/core/velodyne_decoder.h"

#include <algorithm>
#include <array>

#include "base/error.h"

namespace bole::sensor {
namespace {

// The flags of the blocks of one firing, 32 lasers each.
constexpr std::array<std::uint16_t, 4> bank_flags{velodyne_upper_block, velodyne_lower_block, velodyne_third_block,
                                                  velodyne_fourth_block};

// The bank of a block, or nothing where the sensor has no such bank.
std::optional<std::size_t> bank_of(const VelodyneBlock& block, std::size_t banks) {
  const auto flag = std::ranges::find(bank_flags, block.flag);
  const auto bank = static_cast<std::size_t>(flag - bank_flags.begin());
  if (bank >= banks || !block.valid()) return {};
  return bank;
}

}  // namespace

VelodyneDecoder::VelodyneDecoder(SensorModel model) : model_(std::move(model)), beams_(model_) {
  if (model_.packet != PacketFormat::velodyne)
    throw bad_input("the sensor " + model_.name + " does not send Velodyne packets", "a Velodyne sensor");
  banks_ = std::max<std::size_t>(1, beams_.size() / velodyne_records);
}

int VelodyneDecoder::blocks_per_firing(bool dual) const {
  return static_cast<int>(banks_) * (dual && model_.dual_return ? 2 : 1);
}

double VelodyneDecoder::packet_period_s(bool dual) const {
  const int firings = velodyne_blocks / blocks_per_firing(dual);
  return firing_period_s() * firings;
}

std::vector<VelodyneFiring> VelodyneDecoder::firings(const VelodynePacket& packet) const {
  std::vector<VelodyneFiring> out;
  firings(packet, out);
  return out;
}

void VelodyneDecoder::firings(const VelodynePacket& packet, std::vector<VelodyneFiring>& out) const {
  const int step = blocks_per_firing(packet.is_dual());
  out.clear();
  for (int b = 0; b + step <= velodyne_blocks; b += step) {
    const auto& block = packet.blocks[static_cast<std::size_t>(b)];
    out.push_back({b, block.valid(), static_cast<double>(block.azimuth_centideg), 0,
                   static_cast<double>(out.size()) * firing_period_s()});
  }
  beams_.set_advances(firing_period_s(), out);
}

void VelodyneDecoder::append(const VelodyneRecord& record, std::size_t beam, const VelodyneFiring& firing,
                             double sequence_time_s, std::uint8_t firing_index, std::uint8_t return_number,
                             std::vector<VelodyneReturn>& out) const {
  if (record.range_counts == 0) return;
  beams_.append(static_cast<float>(record.range_counts * model_.range_quantum_m), record.intensity, beam, firing,
                firing_period_s(), sequence_time_s, firing_index, return_number, out);
}

// A pair of blocks of a dual return: the last return, then the strongest. One of them may be damaged.
void VelodyneDecoder::append_pair(const VelodyneBlock& block, const VelodyneBlock* strongest, std::size_t record,
                                  std::size_t beam, const VelodyneFiring& firing, double sequence_time_s,
                                  std::uint8_t index, std::vector<VelodyneReturn>& out) const {
  const auto& last = block.records[record];
  if (strongest != nullptr) append(strongest->records[record], beam, firing, sequence_time_s, index, 1, out);
  const bool same = strongest != nullptr && strongest->records[record].range_counts == last.range_counts;
  const bool alone = strongest == nullptr || strongest->records[record].range_counts == 0;
  if (!same) append(last, beam, firing, sequence_time_s, index, alone ? 1 : 2, out);
}

void VelodyneDecoder::decode(const VelodynePacket& packet, std::vector<VelodyneReturn>& out) const {
  const auto all = firings(packet);
  decode(packet, all, 0, all.size(), out);
}

void VelodyneDecoder::decode_banks(const VelodynePacket& packet, const VelodyneFiring& firing, std::uint8_t index,
                                   std::vector<VelodyneReturn>& out) const {
  const bool dual = packet.is_dual() && model_.dual_return;
  const int step = dual ? 2 : 1;
  const int end = firing.first_block + blocks_per_firing(packet.is_dual());
  for (int b = firing.first_block; b < end; b += step) {
    const auto& block = packet.blocks[static_cast<std::size_t>(b)];
    const auto* strongest = dual ? &packet.blocks[static_cast<std::size_t>(b) + 1] : nullptr;
    const auto bank = bank_of(block, banks_);
    if (!bank) continue;
    if (strongest != nullptr && bank_of(*strongest, banks_) != bank) strongest = nullptr;
    for (std::size_t r = 0; r < velodyne_records; ++r) {
      const std::size_t beam = *bank * velodyne_records + r;
      if (dual)
        append_pair(block, strongest, r, beam, firing, 0, index, out);
      else
        append(block.records[r], beam, firing, 0, index, 1, out);
    }
  }
}

void VelodyneDecoder::decode(const VelodynePacket& packet, const std::vector<VelodyneFiring>& firings,
                             std::size_t first, std::size_t last, std::vector<VelodyneReturn>& out) const {
  const bool dual = packet.is_dual() && model_.dual_return;
  for (std::size_t f = first; f < std::min(last, firings.size()); ++f) {
    const auto& firing = firings[f];
    if (!firing.valid) continue;
    const auto index = static_cast<std::uint8_t>(f);
    if (banks_ > 1) {
      decode_banks(packet, firing, index, out);
      continue;
    }
    const auto& block = packet.blocks[static_cast<std::size_t>(firing.first_block)];
    const auto* strongest = dual ? &packet.blocks[static_cast<std::size_t>(firing.first_block) + 1] : nullptr;
    if (strongest != nullptr && !strongest->valid()) strongest = nullptr;
    for (std::size_t r = 0; r < velodyne_records; ++r) {
      const std::size_t beam = r % beams_.size(), sequence = r / beams_.size();
      const double sequence_time_s = static_cast<double>(sequence) * model_.sequence_period_s;
      if (dual)
        append_pair(block, strongest, r, beam, firing, sequence_time_s, index, out);
      else
        append(block.records[r], beam, firing, sequence_time_s, index, 1, out);
    }
  }
}

std::optional<SensorModel> recognise_velodyne(const VelodynePacket& packet) {
  std::size_t banks = 1;
  for (const auto& block : packet.blocks)
    if (const auto bank = bank_of(block, bank_flags.size())) banks = std::max(banks, *bank + 1);
  const std::size_t lasers = banks <= 2 ? banks * velodyne_records : 4 * velodyne_records;
  for (const auto& name : sensor_model_names()) {
    auto model = load_sensor_model(name);
    if (model.packet != PacketFormat::velodyne) continue;
    const bool same =
        banks == 1 ? model.product_id && *model.product_id == packet.product_id : model.channels.size() == lasers;
    if (same) return model;
  }
  return std::nullopt;
}

}  // namespace bole::sensor
