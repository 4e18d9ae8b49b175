#include "sensor/core/calibrated_lasers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/option.h"

namespace bole::sensor {
namespace {

std::string nominal_model(std::size_t lasers, double range_quantum_m) {
  if (lasers == 128) return "vls128";
  if (lasers == 64) return "hdl64e_s2";
  if (lasers == 32) return range_quantum_m > 0.003 ? "vlp32c" : "hdl32e";
  if (lasers == 16) return "vlp16";
  throw bad_input("the calibration enables " + std::to_string(lasers) + " lasers", "128, 64, 32 or 16 (Velodyne)");
}

// Only the lasers of an HDL-64E stand across their beams from the centre (its manual, appendix F). The VLP-16 has a
// height to add to z after all else (its manual, section 9.2).
void turn_to_heights(std::vector<LaserChannel>& channels, const std::vector<double>& nominal_m) {
  const bool known = std::ranges::any_of(channels, [](const LaserChannel& c) { return c.offsets.vertical != 0; });
  for (std::size_t i = 0; i < channels.size(); ++i) {
    auto& offsets = channels[i].offsets;
    offsets.height = known ? offsets.vertical : nominal_m[i];
    offsets.vertical = 0;
  }
}

void number_rings(std::vector<LaserChannel>& channels) {
  std::vector<std::size_t> by_elevation(channels.size());
  std::iota(by_elevation.begin(), by_elevation.end(), std::size_t{0});
  std::ranges::stable_sort(by_elevation, {}, [&](std::size_t i) { return channels[i].elevation_rad; });
  for (std::size_t ring = 0; ring < by_elevation.size(); ++ring)
    channels[by_elevation[ring]].ring = static_cast<int>(ring);
}

}  // namespace

SensorModel calibrated_model(std::size_t lasers, double range_quantum_m, const std::vector<CalibratedLaser>& unit) {
  auto model = load_sensor_model(nominal_model(lasers, range_quantum_m));
  if (range_quantum_m > 0) model.range_quantum_m = range_quantum_m;
  std::vector<double> nominal_m;
  for (const auto& c : model.channels) nominal_m.push_back(c.offsets.height);
  std::vector<bool> seen(model.channels.size(), false);
  for (const auto& given : unit) {
    if (!(given.id >= 0 && given.id < static_cast<double>(seen.size()))) continue;  // that the sensor does not have
    const auto laser = static_cast<std::size_t>(given.id);
    if (seen[laser]) throw bad_input("laser " + std::to_string(laser) + " is there twice", "one entry per laser");
    seen[laser] = true;
    auto& channel = model.channels[laser];
    channel.elevation_rad = given.elevation_rad;
    channel.azimuth_offset_rad = given.azimuth_offset_rad;
    channel.offsets = given.offsets;
  }
  if (const auto absent = std::ranges::find(seen, false); absent != seen.end())
    throw bad_input("laser " + std::to_string(absent - seen.begin()) + " is absent",
                    "all " + std::to_string(seen.size()) + " lasers of a " + model.name);
  if (lasers != 64) turn_to_heights(model.channels, nominal_m);
  number_rings(model.channels);
  return model;
}

double calibration_number(std::string_view text, std::string_view name, double limit) {
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || code != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= limit))
    throw bad_input(std::string(name) + " is '" + std::string(text.substr(0, 60)) + "'",
                    "a number from " + number_text(-limit) + " to " + number_text(limit));
  return value;
}

}  // namespace bole::sensor
