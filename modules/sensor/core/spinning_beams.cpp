#include "sensor/core/spinning_beams.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::sensor {
namespace {

constexpr double radians_per_centideg = std::numbers::pi / 18000;
// A block lasts at most 111 us, in which a rotor at 60 Hz turns by 2.4 degrees. A larger step is a damaged block.
constexpr double max_advance_centideg = 300;

struct Direction {
  float cos, sin;
};

// Cosine and sine of every hundredth of a degree.
const std::vector<Direction>& directions() {
  static const std::vector<Direction> table = [] {
    std::vector<Direction> t(full_turn_centideg);
    for (int i = 0; i < full_turn_centideg; ++i)
      t[static_cast<std::size_t>(i)] = {static_cast<float>(std::cos(i * radians_per_centideg)),
                                        static_cast<float>(std::sin(i * radians_per_centideg))};
    return t;
  }();
  return table;
}

// A first-order step from the nearest entry; the error is below 4e-9.
Direction direction(double azimuth_centideg) {
  const double nearest = std::nearbyint(azimuth_centideg);
  const int wrapped = static_cast<int>(nearest) % full_turn_centideg;
  const auto& d = directions()[static_cast<std::size_t>(wrapped < 0 ? wrapped + full_turn_centideg : wrapped)];
  const auto step = static_cast<float>((azimuth_centideg - nearest) * radians_per_centideg);
  return {d.cos - step * d.sin, d.sin + step * d.cos};
}

double signed_turn(double from_centideg, double to_centideg) {
  return std::remainder(to_centideg - from_centideg, full_turn_centideg);
}

// One jump of the azimuth: the time that the rotor takes to pass the masked sector.
void shift_behind_blind_sector(double mean_advance_centideg, double firing_period_s,
                               std::vector<VelodyneFiring>& firings) {
  for (std::size_t i = 0; i + 1 < firings.size(); ++i) {
    const double turn = std::fmod(firings[i + 1].azimuth_centideg - firings[i].azimuth_centideg + full_turn_centideg,
                                  full_turn_centideg);
    if (turn <= max_advance_centideg || turn >= full_turn_centideg - max_advance_centideg) continue;
    const double skipped_s = (turn / mean_advance_centideg - 1) * firing_period_s;
    for (std::size_t k = i + 1; k < firings.size(); ++k) firings[k].time_offset_s += skipped_s;
  }
}

bool is_off_centre(LaserOffsets offsets) {
  offsets.height = 0;
  return offsets != LaserOffsets{};
}

}  // namespace

Eigen::Vector3d laser_origin(const LaserOffsets& offsets, double azimuth_rad, double elevation_rad) {
  const double c = std::cos(azimuth_rad), s = std::sin(azimuth_rad);
  const double inwards = offsets.vertical * std::sin(elevation_rad);
  return {-inwards * c + offsets.horizontal * s, inwards * s + offsets.horizontal * c,
          offsets.vertical * std::cos(elevation_rad) + offsets.height};
}

SpinningBeams::SpinningBeams(const SensorModel& model)
    : usual_rate_centideg_s_(full_turn_centideg * model.rotation_hz) {
  for (const auto& c : model.channels)
    beams_.push_back({static_cast<float>(std::cos(c.elevation_rad)), static_cast<float>(std::sin(c.elevation_rad)),
                      c.azimuth_offset_rad / radians_per_centideg, c.firing_time_s, static_cast<std::uint16_t>(c.ring),
                      c.offsets, is_off_centre(c.offsets)});
}

void SpinningBeams::set_advances(double firing_period_s, std::vector<VelodyneFiring>& out) const {
  if (out.size() == 1) {
    out[0].advance_centideg = usual_rate_centideg_s_ * firing_period_s;
    return;
  }
  double sum = 0;
  int sane = 0;
  const auto turn_after = [&](std::size_t i) {
    return signed_turn(out[i].azimuth_centideg, out[i + 1].azimuth_centideg);
  };
  const auto is_sane = [&](std::size_t i) {
    return i + 1 < out.size() && out[i].valid && out[i + 1].valid && std::abs(turn_after(i)) <= max_advance_centideg;
  };
  for (std::size_t i = 0; i < out.size(); ++i)
    if (is_sane(i)) {
      sum += turn_after(i);
      ++sane;
    }
  const double mean = sane > 0 ? sum / sane : 0;
  for (std::size_t i = 0; i < out.size(); ++i) out[i].advance_centideg = is_sane(i) ? turn_after(i) : mean;
  if (mean > 0 && sane + 2 == static_cast<int>(out.size()) && std::ranges::all_of(out, &VelodyneFiring::valid))
    shift_behind_blind_sector(mean, firing_period_s, out);
}

// Velodyne HDL-64E S2 manual, appendix F: the laser stands beside the centre, and the correction of its range depends
// on how far the target is, along each of the two axes.
Eigen::Vector3f SpinningBeams::point_with_offsets(const Beam& beam, double range_m, double cos_azimuth,
                                                  double sin_azimuth) {
  constexpr double far = 25.04, near_aside = 2.4, near_ahead = 1.93;  // metres, of the calibration's targets
  const auto& o = beam.offsets;
  const double cos_elevation = static_cast<double>(beam.cos_elevation),
               sin_elevation = static_cast<double>(beam.sin_elevation);
  const auto in_plan = [&](double range) { return range * cos_elevation - o.vertical * sin_elevation; };
  const auto ahead_at = [&](double range) { return in_plan(range) * cos_azimuth + o.horizontal * sin_azimuth; };
  const auto right_at = [&](double range) { return in_plan(range) * sin_azimuth - o.horizontal * cos_azimuth; };
  const double range = range_m + o.range;
  double range_ahead = range, range_aside = range;
  if (o.two_points) {
    const auto change = [&](double near_offset, double distance, double near) {
      return (o.range - near_offset) * (std::abs(distance) - near) / (far - near) + near_offset - o.range;
    };
    range_aside += change(o.near_x, right_at(range), near_aside);
    range_ahead += change(o.near_y, ahead_at(range), near_ahead);
  }
  return Eigen::Vector3d(ahead_at(range_ahead), -right_at(range_aside),
                         range_ahead * sin_elevation + o.vertical * cos_elevation)
      .cast<float>();
}

void SpinningBeams::append(float range_m, std::uint8_t intensity, std::size_t beam, const VelodyneFiring& firing,
                           double firing_period_s, double sequence_time_s, std::uint8_t firing_index,
                           std::uint8_t return_number, std::vector<VelodyneReturn>& out) const {
  const auto& b = beams_[beam];
  const double time_s = sequence_time_s + b.time_s;
  const Direction d =
      direction(firing.azimuth_centideg + firing.advance_centideg * time_s / firing_period_s + b.offset_centideg);
  const float horizontal = range_m * b.cos_elevation;
  // The rotor turns clockwise seen from above, y points to the left.
  Eigen::Vector3f position(horizontal * d.cos, -horizontal * d.sin, range_m * b.sin_elevation);
  if (b.off_centre)
    position =
        point_with_offsets(b, static_cast<double>(range_m), static_cast<double>(d.cos), static_cast<double>(d.sin));
  position.z() += static_cast<float>(b.offsets.height);
  out.push_back({position, b.off_centre ? position.norm() : range_m, static_cast<float>(firing.time_offset_s + time_s),
                 static_cast<std::uint16_t>(beam), b.ring, firing_index, intensity, return_number});
}

}  // namespace bole::sensor
