#include "sensor/core/pcap_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/error.h"

namespace bole::sensor {
namespace {

constexpr std::size_t ethernet = 14, ip = 20, udp = 8;
constexpr std::size_t max_payload = 65507;  // of a UDP datagram
constexpr std::size_t max_piece = 1480;     // of IP data in an Ethernet frame, a multiple of 8
constexpr std::uint16_t do_not_fragment = 0x4000, more_fragments = 0x2000;

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

std::array<std::uint8_t, ethernet + ip> frame_headers(std::size_t content, std::uint16_t identification,
                                                      std::uint16_t fragment) {
  std::array<std::uint8_t, ethernet + ip> h{0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0x60,
                                            0x76, 0x88, 0x00, 0x00, 0x00, 0x08, 0x00};
  std::uint8_t* p = h.data() + ethernet;
  p[0] = 0x45;
  put16_network(p + 2, ip + content);
  put16_network(p + 4, identification);
  put16_network(p + 6, fragment);
  p[8] = 0xFF;  // time to live
  p[9] = 17;    // UDP
  constexpr std::array<std::uint8_t, 8> addresses{192, 168, 1, 201, 255, 255, 255, 255};
  std::memcpy(p + 12, addresses.data(), addresses.size());
  put16_network(p + 10, checksum(p, ip));
  return h;
}

std::vector<std::uint8_t> udp_datagram(std::span<const std::uint8_t> payload, std::uint16_t port) {
  std::vector<std::uint8_t> out(udp);
  put16_network(out.data(), port);
  put16_network(out.data() + 2, port);
  put16_network(out.data() + 4, udp + payload.size());  // a checksum of 0 means none
  out.insert(out.end(), payload.begin(), payload.end());
  return out;
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
  const auto datagram = udp_datagram(payload, port_);
  const bool whole = datagram.size() <= max_piece;
  if (!whole) ++identification_;
  for (std::size_t at = 0; at < datagram.size(); at += max_piece) {
    const auto piece = std::min(max_piece, datagram.size() - at);
    const bool last = at + piece == datagram.size();
    const auto fragment = static_cast<std::uint16_t>(whole ? do_not_fragment : at / 8 | (last ? 0 : more_fragments));
    const auto length = static_cast<std::uint32_t>(ethernet + ip + piece);
    const std::array<std::uint32_t, 4> record{static_cast<std::uint32_t>(microseconds / 1'000'000),
                                              static_cast<std::uint32_t>(microseconds % 1'000'000), length, length};
    append(file_, record);
    append(file_, frame_headers(piece, whole ? 0 : identification_, fragment));
    file_.write(reinterpret_cast<const char*>(datagram.data() + at), static_cast<std::streamsize>(piece));
  }
  if (!file_) throw failure("cannot write to '" + path_.string() + "'", "space on the disk");
}

void PcapWriter::close() {
  file_.close();
  if (!file_) throw failure("cannot write to '" + path_.string() + "'", "space on the disk");
}

}  // namespace bole::sensor
