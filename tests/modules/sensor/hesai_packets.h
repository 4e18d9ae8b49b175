// Data packets of Hesai sensors, written from the makers' manuals (PandarXT-32: "3.1.2 UDP Data", Pandar40P: "3.1 Point
// Cloud Data Packet"): the tests do not use the table of the decoder.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace bole::testing_hesai {

struct Unit {
  std::uint16_t distance_counts = 0;  // of 4 mm
  std::uint8_t reflectivity = 0;
};

struct Block {
  unsigned azimuth_centideg = 0;
  std::vector<Unit> units;
};

struct Stamp {
  int minute = 0, second = 0;
  std::uint32_t microseconds = 0;
};

inline void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
}

inline void put_date(std::string& out, const Stamp& stamp) {
  for (const int v : {122, 6, 15, 9, stamp.minute, stamp.second}) put(out, static_cast<std::uint64_t>(v), 1);
}

// Pre-header 6, header 6, body 8 * 130, tail 24, sequence number 4.
inline std::string xt32_packet(const std::vector<Block>& blocks, std::uint8_t return_mode, const Stamp& stamp) {
  std::string out("\xEE\xFF\x06\x01\0\0\x20\x08\0\x04\x02\x01", 12);
  for (const auto& b : blocks) {
    put(out, b.azimuth_centideg, 2);
    for (const auto& u : b.units) {
      put(out, u.distance_counts, 2);
      put(out, u.reflectivity, 1);
      put(out, 0, 1);
    }
  }
  out.append(10, 'r');
  put(out, return_mode, 1);
  put(out, 600, 2);
  put_date(out, stamp);
  put(out, stamp.microseconds, 4);
  put(out, 0x42, 1);
  put(out, 77, 4);
  return out;
}

// Body 10 * 124, additional information 22.
inline std::string pandar40p_packet(const std::vector<Block>& blocks, std::uint8_t return_mode, const Stamp& stamp) {
  std::string out;
  for (const auto& b : blocks) {
    out += "\xFF\xEE";
    put(out, b.azimuth_centideg, 2);
    for (const auto& u : b.units) {
      put(out, u.distance_counts, 2);
      put(out, u.reflectivity, 1);
    }
  }
  out.append(5, 'r');
  put(out, 0, 1);  // high temperature flag
  out.append(2, 'r');
  put(out, 600, 2);
  put(out, stamp.microseconds, 4);
  put(out, return_mode, 1);
  put(out, 0x42, 1);
  put_date(out, stamp);
  return out;
}

}  // namespace bole::testing_hesai
