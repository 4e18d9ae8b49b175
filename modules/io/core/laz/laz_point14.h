// The state and the models of the point of formats 6 to 10, for its decoder and its encoder: nine layers, with separate
// models for each scanner channel.
#pragma once

#include <array>
#include <cstdint>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_gps_time.h"
#include "io/core/laz/laz_integer.h"
#include "io/core/laz/laz_returns.h"

namespace bole::io::laz {

// Names of layers and of changes are in a namespace of their own, because they are words of many things.
namespace point14 {

enum FieldLayer : std::size_t {
  returns_xy,
  z,
  classification,
  flags,
  intensity,
  scan_angle,
  user_data,
  point_source,
  gps_time,
  layer_count
};

// Bits of Point14Channel::changed; the lowest two say how the return number changes.
enum Change : unsigned {
  returns_count_changed = 4,
  scan_angle_changed = 8,
  gps_time_changed = 16,
  point_source_changed = 32,
  channel_changed = 64
};

inline constexpr std::size_t time_at = 22;  // where the time lies in a record

}  // namespace point14

struct Point14State {
  std::int32_t x = 0, y = 0, z = 0;
  std::uint16_t intensity = 0, source = 0;
  std::int16_t scan_angle = 0;
  unsigned r = 0, n = 0;  // return number, number of returns
  unsigned flags = 0;     // class flags (4 bits), scan direction, edge of flight line
  std::uint8_t classification = 0, user_data = 0;
  std::int64_t time = 0;  // bit pattern
  bool time_changed = false;

  static Point14State from(const std::uint8_t* p) {
    Point14State s;
    s.x = las::load<std::int32_t>(p + las::field::x);
    s.y = las::load<std::int32_t>(p + las::field::y);
    s.z = las::load<std::int32_t>(p + las::field::z);
    s.intensity = las::load<std::uint16_t>(p + las::field::intensity);
    s.r = p[las::field::returns] & 15U;
    s.n = p[las::field::returns] >> 4U;
    s.flags = (p[las::field::extended::flags] & 15U) | (p[las::field::extended::flags] >> 6U) << 4U;
    s.classification = p[las::field::extended::classification];
    s.user_data = p[las::field::extended::user_data];
    s.scan_angle = las::load<std::int16_t>(p + las::field::extended::scan_angle);
    s.source = las::load<std::uint16_t>(p + las::field::extended::point_source_id);
    s.time = las::load<std::int64_t>(p + point14::time_at);
    return s;
  }

  void write(std::uint8_t* p, unsigned channel) const {
    las::store(p + las::field::x, x);
    las::store(p + las::field::y, y);
    las::store(p + las::field::z, z);
    las::store(p + las::field::intensity, intensity);
    p[las::field::returns] = static_cast<std::uint8_t>(r | n << 4U);
    p[las::field::extended::flags] = static_cast<std::uint8_t>((flags & 15U) | channel << 4U | (flags >> 4U) << 6U);
    p[las::field::extended::classification] = classification;
    p[las::field::extended::user_data] = user_data;
    las::store(p + las::field::extended::scan_angle, scan_angle);
    las::store(p + las::field::extended::point_source_id, source);
    las::store(p + point14::time_at, time);
  }

  // 1: first of several, 2: last of several, 3: the only one, 0: in between.
  unsigned place() const { return (r == 1 ? 1U : 0U) + (r >= n ? 2U : 0U); }
};

template <std::size_t Count>
std::array<SymbolModel, Count> like_models(unsigned symbols) {
  std::array<SymbolModel, Count> out;
  out.fill(SymbolModel(symbols));
  return out;
}

// The state of one scanner channel.
struct Point14Channel {
  explicit Point14Channel(const Point14State& start) : last(start), times(false, start.time) {
    last.time_changed = false;
    heights.fill(start.z);
    intensities.fill(start.intensity);
  }

  Point14State last;
  std::array<SymbolModel, 8> changed = like_models<8>(128);
  SymbolModel channel_step{3}, return_step{13};
  std::array<SymbolModel, 16> number_of_returns = like_models<16>(16), return_number = like_models<16>(16);
  std::array<RunningMedian, 12> dx, dy;
  IntegerCoder x{32, 2}, y{32, 22}, height{32, 20};
  std::array<std::int32_t, 8> heights{};
  std::array<SymbolModel, 64> classes = like_models<64>(256), flag_sets = like_models<64>(64),
                              user_bytes = like_models<64>(256);
  std::array<std::uint16_t, 8> intensities{};
  IntegerCoder strength{16, 4}, angle{16, 2}, source{16};
  GpsTimeCoder times;
};

}  // namespace bole::io::laz
