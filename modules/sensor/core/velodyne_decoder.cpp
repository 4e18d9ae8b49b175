#include "sensor/core/velodyne_decoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace bole::sensor {
namespace {

constexpr int full_turn = 36000;
constexpr double radians_per_centideg = std::numbers::pi / 18000;
// A block lasts at most 111 us, in which a rotor at 60 Hz turns by 2.4 degrees. A larger step is a damaged block.
constexpr double max_advance_centideg = 300;

struct Direction {
  float cos, sin;
};

// Cosine and sine of every hundredth of a degree.
const std::vector<Direction>& directions() {
  static const std::vector<Direction> table = [] {
    std::vector<Direction> t(full_turn);
    for (int i = 0; i < full_turn; ++i)
      t[static_cast<std::size_t>(i)] = {static_cast<float>(std::cos(i * radians_per_centideg)),
                                        static_cast<float>(std::sin(i * radians_per_centideg))};
    return t;
  }();
  return table;
}

// A first-order step from the nearest entry; the error is below 4e-9.
Direction direction(double azimuth_centideg) {
  const double nearest = std::nearbyint(azimuth_centideg);
  const int wrapped = static_cast<int>(nearest) % full_turn;
  const auto& d = directions()[static_cast<std::size_t>(wrapped < 0 ? wrapped + full_turn : wrapped)];
  const auto step = static_cast<float>((azimuth_centideg - nearest) * radians_per_centideg);
  return {d.cos - step * d.sin, d.sin + step * d.cos};
}

double signed_turn(double from_centideg, double to_centideg) {
  return std::remainder(to_centideg - from_centideg, full_turn);
}

}  // namespace

VelodyneDecoder::VelodyneDecoder(SensorModel model) : model_(std::move(model)) {
  if (model_.packet != PacketFormat::velodyne)
    throw bad_input("the sensor " + model_.name + " does not send Velodyne packets", "a Velodyne sensor");
  for (const auto& c : model_.channels)
    beams_.push_back({static_cast<float>(std::cos(c.elevation_rad)), static_cast<float>(std::sin(c.elevation_rad)),
                      c.azimuth_offset_rad / radians_per_centideg, c.firing_time_s,
                      static_cast<std::uint16_t>(c.ring)});
}

int VelodyneDecoder::blocks_per_firing(bool dual) const {
  return beams_.size() > velodyne_records || (dual && model_.dual_return) ? 2 : 1;
}

double VelodyneDecoder::packet_period_s(bool dual) const {
  return firing_period_s() * velodyne_blocks / blocks_per_firing(dual);
}

std::vector<VelodyneFiring> VelodyneDecoder::firings(const VelodynePacket& packet) const {
  std::vector<VelodyneFiring> out;
  firings(packet, out);
  return out;
}

void VelodyneDecoder::firings(const VelodynePacket& packet, std::vector<VelodyneFiring>& out) const {
  const int step = blocks_per_firing(packet.is_dual());
  out.clear();
  for (int b = 0; b < velodyne_blocks; b += step) {
    const auto& block = packet.blocks[static_cast<std::size_t>(b)];
    out.push_back({b, block.valid(), static_cast<double>(block.azimuth_centideg), 0,
                   static_cast<double>(out.size()) * firing_period_s()});
  }
  double sum = 0;
  int sane = 0;
  const auto turn_after = [&](std::size_t i) {
    return signed_turn(out[i].azimuth_centideg, out[i + 1].azimuth_centideg);
  };
  const auto is_sane = [&](std::size_t i) {
    return i + 1 < out.size() && out[i].valid && out[i + 1].valid && std::abs(turn_after(i)) <= max_advance_centideg;
  };
  for (std::size_t i = 0; i < out.size(); ++i)
    if (is_sane(i)) {
      sum += turn_after(i);
      ++sane;
    }
  const double mean = sane > 0 ? sum / sane : 0;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].advance_centideg = is_sane(i) ? turn_after(i) : mean;
  if (mean > 0 && sane + 2 == static_cast<int>(out.size()) && std::ranges::all_of(out, &VelodyneFiring::valid))
    shift_behind_blind_sector(mean, out);
}

void VelodyneDecoder::shift_behind_blind_sector(double mean_advance_centideg,
                                                std::vector<VelodyneFiring>& firings) const {
  for (std::size_t i = 0; i + 1 < firings.size(); ++i) {
    const double turn = std::fmod(firings[i + 1].azimuth_centideg - firings[i].azimuth_centideg + full_turn, full_turn);
    if (turn <= max_advance_centideg || turn >= full_turn - max_advance_centideg) continue;
    const double skipped_s = (turn / mean_advance_centideg - 1) * firing_period_s();
    for (std::size_t k = i + 1; k < firings.size(); ++k) firings[k].time_offset_s += skipped_s;
  }
}

void VelodyneDecoder::append(const VelodyneRecord& record, std::size_t beam, const VelodyneFiring& firing,
                             double sequence_time_s, std::uint8_t firing_index, std::uint8_t return_number,
                             std::vector<VelodyneReturn>& out) const {
  if (record.range_counts == 0) return;
  const auto& b = beams_[beam];
  const double time_s = sequence_time_s + b.time_s;
  const Direction d =
      direction(firing.azimuth_centideg + firing.advance_centideg * time_s / firing_period_s() + b.offset_centideg);
  const auto range = static_cast<float>(record.range_counts * model_.range_quantum_m);
  const float horizontal = range * b.cos_elevation;
  // The rotor turns clockwise seen from above, y points to the left.
  out.push_back({{horizontal * d.cos, -horizontal * d.sin, range * b.sin_elevation},
                 range,
                 static_cast<float>(firing.time_offset_s + time_s),
                 static_cast<std::uint16_t>(beam),
                 b.ring,
                 firing_index,
                 record.intensity,
                 return_number});
}

void VelodyneDecoder::decode(const VelodynePacket& packet, std::vector<VelodyneReturn>& out) const {
  const auto all = firings(packet);
  decode(packet, all, 0, all.size(), out);
}

void VelodyneDecoder::decode(const VelodynePacket& packet, const std::vector<VelodyneFiring>& firings,
                             std::size_t first, std::size_t last, std::vector<VelodyneReturn>& out) const {
  const bool two_banks = beams_.size() > velodyne_records;
  const bool dual = packet.is_dual() && model_.dual_return && !two_banks;
  for (std::size_t f = first; f < std::min(last, firings.size()); ++f) {
    const auto& firing = firings[f];
    if (!firing.valid) continue;
    const auto index = static_cast<std::uint8_t>(f);
    const auto& block = packet.blocks[static_cast<std::size_t>(firing.first_block)];
    const auto* partner =
        dual || two_banks ? &packet.blocks[static_cast<std::size_t>(firing.first_block) + 1] : nullptr;
    if (partner != nullptr && !partner->valid()) partner = nullptr;
    for (std::size_t r = 0; r < velodyne_records; ++r) {
      const std::size_t beam = beams_.size() < velodyne_records ? r % beams_.size() : r;
      const std::size_t sequence = r / beams_.size();
      const double sequence_time_s = static_cast<double>(sequence) * model_.sequence_period_s;
      if (two_banks) {
        append(block.records[r], block.flag == velodyne_lower_block ? r + velodyne_records : r, firing, 0, index, 1,
               out);
        if (partner != nullptr)
          append(partner->records[r], partner->flag == velodyne_lower_block ? r + velodyne_records : r, firing, 0,
                 index, 1, out);
      } else if (dual) {
        if (partner != nullptr) append(partner->records[r], beam, firing, sequence_time_s, index, 1, out);
        const bool same = partner != nullptr && partner->records[r].range_counts == block.records[r].range_counts;
        const bool alone = partner == nullptr || partner->records[r].range_counts == 0;
        if (!same) append(block.records[r], beam, firing, sequence_time_s, index, alone ? 1 : 2, out);
      } else {
        append(block.records[r], beam, firing, sequence_time_s, index, 1, out);
      }
    }
  }
}

std::optional<SensorModel> recognise_velodyne(const VelodynePacket& packet) {
  const bool two_banks =
      std::ranges::any_of(packet.blocks, [](const VelodyneBlock& b) { return b.flag == velodyne_lower_block; });
  // The VLS-128 has two more kinds of blocks.
  if (std::ranges::any_of(packet.blocks, [](const VelodyneBlock& b) { return b.flag == 0xCCFF || b.flag == 0xBBFF; }))
    return std::nullopt;
  for (const auto& name : sensor_model_names()) {
    auto model = load_sensor_model(name);
    if (model.packet != PacketFormat::velodyne) continue;
    const bool same = model.product_id ? !two_banks && *model.product_id == packet.product_id : two_banks;
    if (same) return model;
  }
  return std::nullopt;
}

}  // namespace bole::sensor
