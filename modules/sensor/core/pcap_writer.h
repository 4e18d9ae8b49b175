// Writes sensor packets into a pcap file as they would come over Ethernet, so that any viewer of the maker opens it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

namespace bole::sensor {

class PcapWriter {
 public:
  // Creates the file (classic pcap, microseconds, Ethernet). Throws Error{failed} when it cannot be written.
  explicit PcapWriter(const std::filesystem::path& path, std::uint16_t udp_port = 2368);

  // One UDP datagram from 192.168.1.201 to the broadcast address, seen at `time_s` (seconds since the Unix epoch).
  // Throws Error{failed} when the disk refuses it or the payload exceeds 1400 bytes.
  void write(std::span<const std::uint8_t> payload, double time_s);

  // Closes the file; throws Error{failed} when something could not be written. The destructor closes without a word.
  void close();

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::uint16_t port_;
};

}  // namespace bole::sensor
