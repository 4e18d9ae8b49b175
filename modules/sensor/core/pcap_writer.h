// Writes sensor packets into a pcap file, as they are sent over Ethernet, so that the maker's viewer opens it.
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

  // One UDP datagram from 192.168.1.201 to the broadcast address, seen at `time_s` (seconds since the Unix epoch). One
  // of more than 1472 bytes goes in fragments. Throws Error{failed} where it cannot be written or exceeds 65507 bytes.
  void write(std::span<const std::uint8_t> payload, double time_s);

  // Closes the file. Throws Error{failed} where something could not be written. The destructor does not report it.
  void close();

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  std::uint16_t port_;
  std::uint16_t identification_ = 0;  // of the last datagram in fragments
};

}  // namespace bole::sensor
