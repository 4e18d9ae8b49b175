#include "sensor/core/packet_decoder.h"

namespace bole::sensor {

bool VelodynePackets::take(std::span<const std::uint8_t> payload) {
  const auto packet = parse_velodyne_packet(payload);
  if (packet) packet_ = *packet;
  return packet.has_value();
}

const char* VelodynePackets::return_mode() const {
  if (packet_.is_dual()) return "dual";
  return packet_.return_mode == static_cast<std::uint8_t>(VelodyneReturnMode::last) ? "last" : "strongest";
}

}  // namespace bole::sensor
