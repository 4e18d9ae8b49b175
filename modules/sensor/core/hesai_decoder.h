// Decodes the data packets of Hesai's PandarXT-32 and Pandar40P.
// Source: Hesai PandarXT-32 and Pandar40P user manuals, "Point Cloud Data Packet" and the appendices on firing times.
#pragma once

#include <array>
#include <string_view>

#include "sensor/core/packet_decoder.h"

namespace bole::sensor {

// Where a packet of one of the sensors keeps what.
struct HesaiLayout {
  const char* sensor;                 // in resources/sensors
  std::size_t bytes, optional_bytes;  // of a packet; it may have a sequence number behind it
  std::size_t first_block, block_bytes, block_header, azimuth_in_block, unit_bytes;
  int blocks, lasers;
  std::size_t return_mode_at, date_at, time_us_at;
  // A packet is stamped this much after the start of its last firing.
  double stamp_after_last_firing_s;
  // A block's azimuth is that of the rotor this much after the start of the firing.
  double azimuth_after_start_s;
};

inline constexpr double hesai_metres_per_count = 0.004;

// The layout of a packet, or null where it is none.
const HesaiLayout* hesai_layout(std::span<const std::uint8_t> payload);

// The layout of the sensor with so many lasers, or null.
const HesaiLayout* hesai_layout_of(int lasers);

// Elevation and azimuth offset of each channel from the maker's correction file ("Laser id,Elevation,Azimuth", degrees)
// into the beams of a model. Throws Error{bad_input} where the text is no such table for the sensor.
void apply_hesai_correction(std::string_view csv, SensorModel& model);
bool looks_like_hesai_correction(std::string_view csv);

class HesaiPackets : public PacketDecoder {
 public:
  // Throws Error{bad_input} where the model is none of the sensor's.
  HesaiPackets(const HesaiLayout& layout, SensorModel model);

  const SensorModel& model() const override { return model_; }
  bool take(std::span<const std::uint8_t> payload) override;
  bool dual() const override;
  const char* return_mode() const override;
  std::uint32_t past_hour_us() const override { return past_hour_us_; }
  void firings(std::vector<VelodyneFiring>& out) const override;
  void decode(const std::vector<VelodyneFiring>& firings, std::size_t first, std::size_t last,
              std::vector<VelodyneReturn>& out) const override;
  double firing_period_s() const override { return model_.sequence_period_s; }
  double packet_period_s() const override { return firing_period_s() * layout_->blocks / blocks_per_firing(); }

 private:
  int blocks_per_firing() const { return dual() ? 2 : 1; }
  std::size_t unit_at(int block, int laser) const;

  const HesaiLayout* layout_;
  SensorModel model_;
  SpinningBeams beams_;
  std::vector<std::uint8_t> packet_;
  std::uint32_t past_hour_us_ = 0;
};

}  // namespace bole::sensor
