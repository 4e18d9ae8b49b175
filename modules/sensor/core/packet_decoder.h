// What the reader of a recording needs from the packets of a sensor that turns, whoever made it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sensor/core/spinning_beams.h"
#include "sensor/core/velodyne_decoder.h"

namespace bole::sensor {

class PacketDecoder {
 public:
  virtual ~PacketDecoder() = default;
  virtual const SensorModel& model() const = 0;

  // Takes a data packet; the functions below speak of the last one. False, and nothing changes, where it is none.
  virtual bool take(std::span<const std::uint8_t> payload) = 0;

  virtual bool dual() const = 0;
  virtual const char* return_mode() const = 0;     // "strongest", "last", "dual", ...
  virtual std::uint32_t past_hour_us() const = 0;  // of the first firing
  virtual void firings(std::vector<VelodyneFiring>& out) const = 0;
  virtual void decode(const std::vector<VelodyneFiring>& firings, std::size_t first, std::size_t last,
                      std::vector<VelodyneReturn>& out) const = 0;
  virtual double firing_period_s() const = 0;
  virtual double packet_period_s() const = 0;  // from the first firing of a packet to that of the next
};

class VelodynePackets : public PacketDecoder {
 public:
  explicit VelodynePackets(SensorModel model) : decoder_(std::move(model)) {}

  const SensorModel& model() const override { return decoder_.model(); }
  bool take(std::span<const std::uint8_t> payload) override;
  bool dual() const override { return packet_.is_dual(); }
  const char* return_mode() const override;
  std::uint32_t past_hour_us() const override { return packet_.time_us; }
  void firings(std::vector<VelodyneFiring>& out) const override { decoder_.firings(packet_, out); }
  void decode(const std::vector<VelodyneFiring>& firings, std::size_t first, std::size_t last,
              std::vector<VelodyneReturn>& out) const override {
    decoder_.decode(packet_, firings, first, last, out);
  }
  double firing_period_s() const override { return decoder_.firing_period_s(); }
  double packet_period_s() const override { return decoder_.packet_period_s(packet_.is_dual()); }

 private:
  VelodyneDecoder decoder_;
  VelodynePacket packet_;
};

}  // namespace bole::sensor
