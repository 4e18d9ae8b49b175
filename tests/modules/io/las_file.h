// LAS files made byte by byte for the tests, so that every lie of a header can be told.
#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "io/core/las/las_bytes.h"
#include "io/core/las/las_format.h"

namespace bole::test {

struct LasFile {
  int minor = 2, format = 1;
  int extra = 0;  // bytes behind each point
  double scale = 0.01;
  Eigen::Vector3d offset{1000, 2000, 0};
  std::vector<std::vector<std::uint8_t>> vlrs;
  std::vector<std::uint8_t> records;
  std::size_t points = 0;

  std::size_t stride() const { return static_cast<std::size_t>(io::las::point_layout(format).size + extra); }

  // A zeroed record at the integer coordinate; the caller fills in the rest.
  std::uint8_t* add(std::int32_t x, std::int32_t y, std::int32_t z) {
    records.resize(++points * stride());
    std::uint8_t* at = &records[(points - 1) * stride()];
    io::las::store(at, x);
    io::las::store(at + 4, y);
    io::las::store(at + 8, z);
    return at;
  }

  void add_vlr(const std::string& user, int id, const std::vector<std::uint8_t>& data) {
    std::vector<std::uint8_t> vlr(54);
    io::las::store_text(&vlr[2], 16, user);
    io::las::store(&vlr[18], static_cast<std::uint16_t>(id));
    io::las::store(&vlr[20], static_cast<std::uint16_t>(data.size()));
    vlr.insert(vlr.end(), data.begin(), data.end());
    vlrs.push_back(vlr);
  }

  std::vector<std::uint8_t> bytes() const {
    const std::size_t header = minor >= 4 ? 375 : minor == 3 ? 235 : 227;
    std::vector<std::uint8_t> out(header);
    std::memcpy(out.data(), "LASF", 4);
    out[24] = 1;
    out[25] = static_cast<std::uint8_t>(minor);
    io::las::store_text(&out[58], 32, "the tests");
    io::las::store(&out[94], static_cast<std::uint16_t>(header));
    for (const auto& vlr : vlrs) out.insert(out.end(), vlr.begin(), vlr.end());
    io::las::store(&out[96], static_cast<std::uint32_t>(out.size()));
    io::las::store(&out[100], static_cast<std::uint32_t>(vlrs.size()));
    out[104] = static_cast<std::uint8_t>(format);
    io::las::store(&out[105], static_cast<std::uint16_t>(stride()));
    if (minor >= 4)
      io::las::store(&out[247], std::uint64_t{points});
    else
      io::las::store(&out[107], static_cast<std::uint32_t>(points));
    for (std::size_t k = 0; k < 3; ++k) {
      io::las::store(&out[131 + 8 * k], scale);
      io::las::store(&out[155 + 8 * k], offset[static_cast<Eigen::Index>(k)]);
    }
    out.insert(out.end(), records.begin(), records.end());
    return out;
  }
};

}  // namespace bole::test
