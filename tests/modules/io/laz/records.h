// Point records of every kind that the LAZ encoder must bring back.
#pragma once

#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_chunk_encoder.h"

namespace bole::testing_io {

struct Records {
  int format = 6;
  std::size_t length = 30;
  std::vector<std::uint8_t> bytes;
  std::size_t count() const { return bytes.size() / length; }
  std::uint8_t* operator[](std::size_t i) { return &bytes[i * length]; }
};

inline Records empty_records(int format, std::size_t extra, std::size_t count) {
  Records out;
  out.format = format;
  out.length = static_cast<std::size_t>(io::las::point_layout(format).size) + extra;
  out.bytes.resize(count * out.length);
  return out;
}

// Every byte is noise: all fields in their full range.
inline Records noise(int format, std::size_t extra, std::size_t count, unsigned seed) {
  auto out = empty_records(format, extra, count);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> byte(0, 255);
  for (auto& b : out.bytes) b = static_cast<std::uint8_t>(byte(random));
  return out;
}

// All points are the same.
inline Records constant(int format, std::size_t extra, std::size_t count, unsigned seed) {
  auto out = noise(format, extra, count, seed);
  for (std::size_t i = 1; i < count; ++i) std::memcpy(out[i], out[0], out.length);
  return out;
}

// A walk through the whole range of coordinates, with returns, channels and times that change by turns.
inline Records walk(int format, std::size_t extra, std::size_t count, unsigned seed) {
  using io::las::load;
  using io::las::store;
  auto out = noise(format, extra, count, seed);
  std::mt19937 random(seed + 1);
  const auto& layout = io::las::point_layout(format);
  const auto draw = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  for (std::size_t i = 1; i < count; ++i) {
    std::uint8_t* const p = out[i];
    const std::uint8_t* const last = out[i - 1];
    // Most bytes behind the coordinates stay as they were.
    for (std::size_t k = 12; k < out.length; ++k)
      if (draw(0, 9) != 0) p[k] = last[k];
    for (std::size_t k = 0; k < 12; k += 4) {
      const auto step =
          draw(0, 200) == 0 ? static_cast<std::uint32_t>(random()) : static_cast<std::uint32_t>(draw(-900, 900));
      store(p + k, load<std::uint32_t>(last + k) + step);
    }
    if (layout.time >= 0) {
      // Four interleaved clocks, pulses, and now and then a leap.
      const auto time = static_cast<std::size_t>(layout.time);
      double seconds = 1e5 * static_cast<double>(i % 4) + 3e-6 * static_cast<double>(i) * draw(1, 4);
      if (draw(0, 150) == 0) seconds = std::numeric_limits<double>::lowest();
      if (draw(0, 150) == 0) seconds = std::numeric_limits<double>::quiet_NaN();
      if (draw(0, 2) == 0)
        std::memcpy(p + time, last + time, sizeof seconds);
      else
        store(p + time, seconds);
    }
  }
  return out;
}

inline std::vector<std::uint8_t> decoded(const io::laz::Packing& packing, const Records& like,
                                         const std::vector<std::uint8_t>& chunk) {
  io::laz::ChunkDecoder decoder(packing, static_cast<int>(like.length));
  std::vector<std::uint8_t> out(like.bytes.size());
  if (decoder.start(chunk, like.count()) != like.count()) return {};
  if (decoder.decode(out.data(), like.count()) != like.count()) return {};
  if (decoder.length() != chunk.size()) return {};
  return out;
}

}  // namespace bole::testing_io
