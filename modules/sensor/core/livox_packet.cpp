#include "sensor/core/livox_packet.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "sensor/core/little_endian.h"

namespace bole::sensor {
namespace {

using Bytes = std::span<const std::uint8_t>;
using Coordinates = LivoxLayout::Coordinates;

std::uint32_t little32(Bytes p, std::size_t at) {
  return static_cast<std::uint32_t>(p[at]) | static_cast<std::uint32_t>(p[at + 1]) << 8 |
         static_cast<std::uint32_t>(p[at + 2]) << 16 | static_cast<std::uint32_t>(p[at + 3]) << 24;
}

double little_float(Bytes p, std::size_t at) { return std::bit_cast<float>(little32(p, at)); }

Eigen::Vector3d on_sphere(double range_m, std::uint16_t zenith_centideg, std::uint16_t azimuth_centideg) {
  constexpr double radians_per_centideg = std::numbers::pi / 18000;
  const double zenith = zenith_centideg * radians_per_centideg, azimuth = azimuth_centideg * radians_per_centideg;
  return range_m *
         Eigen::Vector3d(std::sin(zenith) * std::cos(azimuth), std::sin(zenith) * std::sin(azimuth), std::cos(zenith));
}

// The return `r` of a firing: x, y, z, reflectivity, tag per return; or the angles once (before the returns where there
// are several), with range, reflectivity and tag per return.
Eigen::Vector3d place_of(const LivoxLayout& layout, Bytes firing, std::size_t r, std::size_t& reflectivity_at) {
  const std::size_t tag = layout.tags ? 1 : 0;
  switch (layout.coordinates) {
    case Coordinates::cartesian_cm:
      reflectivity_at = 6;
      return 0.01 * Eigen::Vector3d(static_cast<std::int16_t>(little16(firing, 0)),
                                    static_cast<std::int16_t>(little16(firing, 2)),
                                    static_cast<std::int16_t>(little16(firing, 4)));
    case Coordinates::spherical: {
      if (layout.returns == 1) {
        reflectivity_at = 8;
        return on_sphere(1e-3 * little32(firing, 0), little16(firing, 4), little16(firing, 6));
      }
      const std::size_t at = 4 + r * 6;
      reflectivity_at = at + 4;
      return on_sphere(1e-3 * little32(firing, at), little16(firing, 0), little16(firing, 2));
    }
    default: {
      const std::size_t at = r * (13 + tag);
      reflectivity_at = at + 12;
      return 1e-3 * Eigen::Vector3d(static_cast<std::int32_t>(little32(firing, at)),
                                    static_cast<std::int32_t>(little32(firing, at + 4)),
                                    static_cast<std::int32_t>(little32(firing, at + 8)));
    }
  }
}

}  // namespace

// Two groups of bits tell noise, by the strength of the return and by its surroundings: 1 is sure, 2 and 3 are less.
bool is_livox_noise(std::uint8_t tag) { return (tag & 3) == 1 || (tag >> 2 & 3) == 1; }

int livox_return(std::uint8_t tag) { return tag >> 4 & 3; }

std::optional<LivoxLayout> livox_layout(std::uint8_t data_type, bool lvx2) {
  static constexpr std::array lvx1{LivoxLayout{13, 1, Coordinates::cartesian_mm, false, 100},
                                   LivoxLayout{9, 1, Coordinates::spherical, false, 100},
                                   LivoxLayout{14, 1, Coordinates::cartesian_mm, true, 96},
                                   LivoxLayout{10, 1, Coordinates::spherical, true, 96},
                                   LivoxLayout{28, 2, Coordinates::cartesian_mm, true, 48},
                                   LivoxLayout{16, 2, Coordinates::spherical, true, 48},
                                   LivoxLayout{24, 0, Coordinates::inertial, false, 1},
                                   LivoxLayout{42, 3, Coordinates::cartesian_mm, true, 30},
                                   LivoxLayout{22, 3, Coordinates::spherical, true, 30}};
  static constexpr std::array second{
      LivoxLayout{24, 0, Coordinates::inertial, false, 1}, LivoxLayout{14, 1, Coordinates::cartesian_mm, true, 0},
      LivoxLayout{8, 1, Coordinates::cartesian_cm, true, 0}, LivoxLayout{10, 1, Coordinates::spherical, true, 0}};
  if (lvx2) return data_type < second.size() ? std::optional(second[data_type]) : std::nullopt;
  return data_type < lvx1.size() ? std::optional(lvx1[data_type]) : std::nullopt;
}

void decode_livox_points(const LivoxLayout& layout, Bytes data, std::vector<LivoxPoint>& out) {
  if (layout.coordinates == Coordinates::inertial) return;
  const std::size_t firings = data.size() / layout.firing_bytes;
  for (std::size_t i = 0; i < firings; ++i) {
    const auto firing = data.subspan(i * layout.firing_bytes, layout.firing_bytes);
    std::uint8_t number = 0;
    Eigen::Vector3d previous = Eigen::Vector3d::Zero();
    for (int r = 0; r < layout.returns; ++r) {
      std::size_t reflectivity_at = 0;
      const auto place = place_of(layout, firing, static_cast<std::size_t>(r), reflectivity_at);
      if (place.isZero() || (r > 0 && place == previous)) continue;  // none, or the same return again
      if (layout.tags && is_livox_noise(firing[reflectivity_at + 1])) continue;
      previous = place;
      out.push_back({place.cast<float>(), static_cast<std::uint16_t>(i), firing[reflectivity_at], ++number});
    }
  }
}

std::optional<InertialSample> decode_livox_inertial(Bytes data) {
  if (data.size() < 24) return {};
  InertialSample sample;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = 4 * static_cast<std::size_t>(axis);
    sample.angular_rate_rad_s[axis] = little_float(data, at);
    sample.specific_force_m_s2[axis] = standard_gravity * little_float(data, 12 + at);
  }
  if (!sample.angular_rate_rad_s.allFinite() || !sample.specific_force_m_s2.allFinite()) return {};
  return sample;
}

}  // namespace bole::sensor
