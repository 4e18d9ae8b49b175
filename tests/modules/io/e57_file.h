// E57 files made byte by byte for the tests and the fuzz target, so that every lie can be told.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "io/core/e57/e57_pages.h"

namespace bole::test {

struct E57Field {
  std::string name;
  unsigned bits = 64;  // 64: double; 32: float; fewer: an integer from `minimum` on
  std::int64_t minimum = 0;
  double scale = 0;  // of a scaled integer; 0: a plain one
};

struct E57Scan {
  std::vector<E57Field> fields;
  std::vector<std::vector<double>> rows;  // by record the values of the fields
  std::string xml;                        // further elements: a pose, limits
};

class E57File {
 public:
  static constexpr std::size_t page = 1024, data = 1020;

  std::vector<E57Scan> scans;
  std::string xml;  // further elements of the root
  std::size_t records_per_packet = 100;
  std::uint64_t declared_more = 0;  // records that are not there

  std::vector<std::uint8_t> bytes() const {
    std::vector<std::uint8_t> out(48);
    std::string text = "<?xml version=\"1.0\"?><e57Root type=\"Structure\"><data3D type=\"Vector\">";
    for (const auto& scan : scans) {
      const std::size_t begin = out.size();
      write_points(scan, out);
      text += "<vectorChild type=\"Structure\">" + scan.xml + "<points type=\"CompressedVector\" fileOffset=\"" +
              std::to_string(physical(begin)) + "\" recordCount=\"" + std::to_string(scan.rows.size() + declared_more) +
              "\"><prototype type=\"Structure\">";
      for (const auto& f : scan.fields) text += described(f);
      text += "</prototype><codecs type=\"Vector\"/></points></vectorChild>";
    }
    text += "</data3D>" + xml + "</e57Root>";
    const std::size_t at = out.size();
    out.insert(out.end(), text.begin(), text.end());
    const std::size_t pages = (out.size() + data - 1) / data;
    std::memcpy(out.data(), "ASTM-E57", 8);
    put32(&out[8], 1);
    put64(&out[16], pages * page);
    put64(&out[24], physical(at));
    put64(&out[32], text.size());
    put64(&out[40], page);
    return paged(out);
  }

  static std::uint64_t physical(std::uint64_t logical) { return logical / data * page + logical % data; }

  // Right checksums for all whole pages.
  static void seal(std::vector<std::uint8_t>& file) {
    for (std::size_t at = 0; at + page <= file.size(); at += page) {
      const std::uint32_t crc = io::e57::crc32c({&file[at], data});
      for (std::size_t i = 0; i < 4; ++i) file[at + data + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    }
  }

 private:
  static void put32(std::uint8_t* at, std::uint32_t v) { std::memcpy(at, &v, 4); }
  static void put64(std::uint8_t* at, std::uint64_t v) { std::memcpy(at, &v, 8); }

  static std::string described(const E57Field& f) {
    if (f.bits >= 32 && f.scale == 0)
      return "<" + f.name + " type=\"Float\"" + (f.bits == 32 ? " precision=\"single\"" : "") + "/>";
    const auto largest = f.minimum + static_cast<std::int64_t>((std::uint64_t{1} << f.bits) - 1);
    return "<" + f.name + " type=\"" + (f.scale == 0 ? "Integer" : "ScaledInteger") + "\" minimum=\"" +
           std::to_string(f.minimum) + "\" maximum=\"" + std::to_string(largest) + "\"" +
           (f.scale == 0 ? "" : " scale=\"" + std::to_string(f.scale) + "\"") + "/>";
  }

  static std::uint64_t stored(const E57Field& f, double value) {
    if (f.scale == 0 && f.bits == 64) return std::bit_cast<std::uint64_t>(value);
    if (f.scale == 0 && f.bits == 32) return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    return static_cast<std::uint64_t>(std::llround(f.scale == 0 ? value : value / f.scale) - f.minimum);
  }

  // The bits of a stream run on from packet to packet; each packet takes the whole bytes that are there.
  void write_points(const E57Scan& scan, std::vector<std::uint8_t>& out) const {
    const std::size_t begin = out.size();
    out.resize(begin + 32);
    out[begin] = 1;
    put64(&out[begin + 16], physical(begin + 32));
    std::vector<std::vector<std::uint8_t>> streams(scan.fields.size());
    std::vector<std::size_t> bit(scan.fields.size());
    for (std::size_t first = 0; first < scan.rows.size(); first += records_per_packet) {
      const std::size_t last = std::min(scan.rows.size(), first + records_per_packet);
      for (std::size_t i = first; i < last; ++i)
        for (std::size_t f = 0; f < scan.fields.size(); ++f) {
          const auto value = stored(scan.fields[f], scan.rows[i][f]);
          for (unsigned b = 0; b < scan.fields[f].bits; ++b, ++bit[f]) {
            if (bit[f] / 8 >= streams[f].size()) streams[f].push_back(0);
            streams[f][bit[f] / 8] = static_cast<std::uint8_t>(streams[f][bit[f] / 8] | (value >> b & 1) << bit[f] % 8);
          }
        }
      write_packet(streams, bit, last == scan.rows.size(), out);
    }
    put64(&out[begin + 8], out.size() - begin);
  }

  static void write_packet(std::vector<std::vector<std::uint8_t>>& streams, std::vector<std::size_t>& bit, bool last,
                           std::vector<std::uint8_t>& out) {
    const std::size_t begin = out.size();
    out.resize(begin + 6 + 2 * streams.size());
    out[begin] = 1;
    out[begin + 4] = static_cast<std::uint8_t>(streams.size());
    for (std::size_t f = 0; f < streams.size(); ++f) {
      const std::size_t whole = last ? streams[f].size() : bit[f] / 8;
      out[begin + 6 + 2 * f] = static_cast<std::uint8_t>(whole);
      out[begin + 7 + 2 * f] = static_cast<std::uint8_t>(whole >> 8);
      out.insert(out.end(), streams[f].begin(), streams[f].begin() + static_cast<std::ptrdiff_t>(whole));
      streams[f].erase(streams[f].begin(), streams[f].begin() + static_cast<std::ptrdiff_t>(whole));
      bit[f] -= 8 * std::min(whole, bit[f] / 8);
    }
    while ((out.size() - begin) % 4 != 0) out.push_back(0);
    const std::size_t length = out.size() - begin - 1;
    out[begin + 2] = static_cast<std::uint8_t>(length);
    out[begin + 3] = static_cast<std::uint8_t>(length >> 8);
  }

  static std::vector<std::uint8_t> paged(const std::vector<std::uint8_t>& logical) {
    std::vector<std::uint8_t> out;
    for (std::size_t at = 0; at < logical.size(); at += data) {
      const std::size_t n = std::min(data, logical.size() - at);
      out.insert(out.end(), logical.begin() + static_cast<std::ptrdiff_t>(at),
                 logical.begin() + static_cast<std::ptrdiff_t>(at + n));
      out.resize(out.size() + page - n);
    }
    seal(out);
    return out;
  }
};

// Cartesian doubles, 10-bit intensities from -4 on, a 1-bit state and a scaled integer, on a ring about the scanner.
inline E57Scan ring_scan(std::size_t points, const std::string& xml = {}) {
  E57Scan scan;
  scan.fields = {{"cartesianX", 64},
                 {"cartesianY", 32},
                 {"cartesianZ", 20, -1000, 0.001},
                 {"intensity", 10, -4},
                 {"cartesianInvalidState", 1}};
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = 0.1 * static_cast<double>(i);
    scan.rows.push_back({5 * std::cos(angle), 5 * std::sin(angle), 0.001 * static_cast<double>(i % 1000),
                         static_cast<double>(i % 1000) - 4, i % 10 == 9 ? 1.0 : 0.0});
  }
  scan.xml = xml;
  return scan;
}

inline std::string pose_xml(double x, double y, double z, double turn_about_z_rad = 0) {
  const double w = std::cos(turn_about_z_rad / 2), s = std::sin(turn_about_z_rad / 2);
  return "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">" + std::to_string(w) +
         "</w><x type=\"Float\"/><y type=\"Float\"/><z type=\"Float\">" + std::to_string(s) +
         "</z></rotation><translation type=\"Structure\"><x type=\"Float\">" + std::to_string(x) +
         "</x><y type=\"Float\">" + std::to_string(y) + "</y><z type=\"Float\">" + std::to_string(z) +
         "</z></translation></pose>";
}

}  // namespace bole::test
