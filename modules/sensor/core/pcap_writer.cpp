#include "sensor/core/pcap_writer.h"

#include <array>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace bole::sensor {
namespace {

constexpr std::size_t ethernet = 14, ip = 20, udp = 8;
constexpr std::size_t headers = ethernet + ip + udp;
constexpr std::size_t max_payload = 1400;

void put16_network(std::uint8_t* p, std::size_t value) {
  p[0] = static_cast<std::uint8_t>(value >> 8 & 0xFF);
  p[1] = static_cast<std::uint8_t>(value & 0xFF);
}

// RFC 1071.
std::uint16_t checksum(const std::uint8_t* p, std::size_t bytes) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i + 1 < bytes; i += 2) sum += static_cast<std::uint32_t>(p[i] << 8 | p[i + 1]);
  while (sum >> 16 != 0) sum = (sum & 0xFFFF) + (sum >> 16);
  return static_cast<std::uint16_t>(~sum & 0xFFFF);
}

std::array<std::uint8_t, headers> frame_headers(std::size_t payload, std::uint16_t port) {
  std::array<std::uint8_t, headers> h{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x60,
                                      0x76, 0x88, 0x00, 0x00, 0x00, 0x08, 0x00};
  std::uint8_t* p = h.data() + ethernet;
  p[0] = 0x45;
  put16_network(p + 2, ip + udp + payload);
  p[6] = 0x40;  // do not fragment
  p[8] = 0xFF;  // time to live
  p[9] = 17;    // UDP
  constexpr std::array<std::uint8_t, 8> addresses{192, 168, 1, 201, 255, 255, 255, 255};
  std::memcpy(p + 12, addresses.data(), addresses.size());
  put16_network(p + 10, checksum(p, ip));
  p += ip;
  put16_network(p, port);
  put16_network(p + 2, port);
  put16_network(p + 4, udp + payload);  // a UDP checksum of 0 means none
  return h;
}

template <class T>
void append(std::ofstream& file, const T& value) {
  file.write(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

PcapWriter::PcapWriter(const std::filesystem::path& path, std::uint16_t udp_port)
    : path_(path), file_(path, std::ios::binary), port_(udp_port) {
  if (!file_) throw failure("cannot write '" + path.string() + "'", "a folder that exists and may be written to");
  constexpr std::array<std::uint32_t, 6> header{0xA1B2C3D4, 2 | 4 << 16, 0,
                                                0,          65535,       1};  // version 2.4, link type Ethernet
  append(file_, header);
}

void PcapWriter::write(std::span<const std::uint8_t> payload, double time_s) {
  if (payload.size() > max_payload)
    throw failure("a datagram of " + std::to_string(payload.size()) + " bytes",
                  "at most " + std::to_string(max_payload));
  const auto microseconds = static_cast<std::int64_t>(std::llround(time_s * 1e6));
  const auto length = static_cast<std::uint32_t>(headers + payload.size());
  const std::array<std::uint32_t, 4> record{static_cast<std::uint32_t>(microseconds / 1'000'000),
                                            static_cast<std::uint32_t>(microseconds % 1'000'000), length, length};
  append(file_, record);
  append(file_, frame_headers(payload.size(), port_));
  file_.write(reinterpret_cast<const char*>(payload.data()), static_cast<std::streamsize>(payload.size()));
  if (!file_) throw failure("cannot write to '" + path_.string() + "'", "space on the disk");
}

void PcapWriter::close() {
  file_.close();
  if (!file_) throw failure("cannot write to '" + path_.string() + "'", "space on the disk");
}

}  // namespace bole::sensor
