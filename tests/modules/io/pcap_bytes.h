// Captures as bytes: UDP datagrams of any length over Ethernet, whole or in IPv4 fragments.
#pragma once

#include <algorithm>
#include <string>

namespace bole::testing_io {

class PcapBytes {
 public:
  explicit PcapBytes(std::size_t mtu = 65535) : mtu_(mtu) {
    little(0xA1B2C3D4, 4);
    little(2, 2);
    little(4, 2);
    little(0, 4);
    little(0, 4);
    little(262144, 4);
    little(1, 4);  // Ethernet
  }

  void add(const std::string& payload, double time_s, unsigned port) {
    std::string udp;
    big(udp, 7000, 2);
    big(udp, port, 2);
    big(udp, payload.size() + 8, 2);
    big(udp, 0, 2);
    udp += payload;
    ++identification_;
    const std::size_t piece = (mtu_ - 20) / 8 * 8;
    for (std::size_t at = 0; at < udp.size(); at += piece) {
      const auto part = udp.substr(at, piece);
      const bool more = at + piece < udp.size();
      std::string frame(12, '\2');
      big(frame, 0x0800, 2);
      big(frame, 0x4500, 2);
      big(frame, part.size() + 20, 2);
      big(frame, identification_, 2);
      big(frame, (more ? 0x2000 : 0) | at / 8, 2);
      big(frame, 0x4011, 2);
      big(frame, 0, 2);
      big(frame, 0x0A000001, 4);
      big(frame, 0x0A000002, 4);
      frame += part;
      little(static_cast<std::uint64_t>(time_s), 4);
      little(static_cast<std::uint64_t>((time_s - static_cast<double>(static_cast<std::uint64_t>(time_s))) * 1e6), 4);
      little(frame.size(), 4);
      little(frame.size(), 4);
      bytes_ += frame;
    }
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void little(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  }
  static void big(std::string& out, std::uint64_t value, int bytes) {
    for (int i = bytes; i-- > 0;) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
  }

  std::size_t mtu_;
  unsigned identification_ = 0;
  std::string bytes_;
};

}  // namespace bole::testing_io
