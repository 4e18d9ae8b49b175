#include "sensor/core/velodyne_calibration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <pugixml.hpp>
#include <string>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"

namespace bole::sensor {
namespace {

constexpr double metres_per_cm = 0.01;

// The number in a child; files write a dot whatever the locale is.
double xml_number(const pugi::xml_node& node, const char* name, double limit) {
  const std::string_view text = node.child_value(name);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || code != std::errc{} || end != text.data() + text.size() || !(std::abs(value) <= limit))
    throw bad_input("<" + std::string(name) + "> is '" + std::string(text) + "'",
                    "a number from " + number_text(-limit) + " to " + number_text(limit));
  return value;
}

pugi::xml_node database(const pugi::xml_document& document) {
  return document.child("boost_serialization").child("DB");
}

std::size_t enabled_lasers(const pugi::xml_node& db) {
  std::size_t enabled = 0;
  for (const auto& item : db.child("enabled_").children("item")) enabled += item.text().as_int() != 0;
  return enabled;
}

std::string nominal_model(std::size_t lasers, double range_quantum_m) {
  if (lasers == 64) return "hdl64e_s2";
  if (lasers == 32) return range_quantum_m > 0.003 ? "vlp32c" : "hdl32e";
  if (lasers == 16) return "vlp16";
  throw bad_input("the calibration enables " + std::to_string(lasers) + " lasers", "64, 32 or 16 (Velodyne)");
}

// Angles are in degrees, lengths in centimetres.
void read_laser(const pugi::xml_node& px, LaserChannel& channel) {
  channel.elevation_rad = xml_number(px, "vertCorrection_", 90) * rad_per_deg;
  channel.azimuth_offset_rad = -xml_number(px, "rotCorrection_", 180) * rad_per_deg;
  auto& offsets = channel.offsets;
  offsets.range = xml_number(px, "distCorrection_", 1000) * metres_per_cm;
  offsets.vertical = xml_number(px, "vertOffsetCorrection_", 100) * metres_per_cm;
  offsets.horizontal = xml_number(px, "horizOffsetCorrection_", 100) * metres_per_cm;
  if (px.child("distCorrectionX_").empty()) return;
  offsets.near_x = xml_number(px, "distCorrectionX_", 1000) * metres_per_cm;
  offsets.near_y = xml_number(px, "distCorrectionY_", 1000) * metres_per_cm;
  // Older units have one distance only, and zeros in its place.
  offsets.two_points = offsets.near_x != 0 || offsets.near_y != 0;
}

void number_rings(std::vector<LaserChannel>& channels) {
  std::vector<std::size_t> by_elevation(channels.size());
  std::iota(by_elevation.begin(), by_elevation.end(), std::size_t{0});
  std::ranges::stable_sort(by_elevation, {}, [&](std::size_t i) { return channels[i].elevation_rad; });
  for (std::size_t ring = 0; ring < by_elevation.size(); ++ring)
    channels[by_elevation[ring]].ring = static_cast<int>(ring);
}

}  // namespace

bool is_velodyne_calibration(std::string_view xml) {
  return xml.find("boost_serialization") != std::string_view::npos &&
         xml.find("rotCorrection_") != std::string_view::npos;
}

SensorModel velodyne_model_from_xml(std::string_view xml) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    throw bad_input(std::string("the calibration is no XML: ") + parsed.description(), "the db.xml of a Velodyne unit");
  const auto db = database(document);
  if (db.empty()) throw bad_input("the XML has no <DB> in <boost_serialization>", "the db.xml of a Velodyne unit");
  const double quantum_m = xml_number(db, "distLSB_", 10) * metres_per_cm;
  auto model = load_sensor_model(nominal_model(enabled_lasers(db), quantum_m));
  if (quantum_m > 0) model.range_quantum_m = quantum_m;
  std::vector<bool> seen(model.channels.size(), false);
  for (const auto& item : db.child("points_").children("item")) {
    const auto px = item.child("px");
    const double id = xml_number(px, "id_", 255);
    if (id < 0 || id >= static_cast<double>(seen.size())) continue;  // lasers that the sensor does not have
    const auto laser = static_cast<std::size_t>(id);
    if (seen[laser]) throw bad_input("laser " + std::to_string(laser) + " is there twice", "one entry per laser");
    seen[laser] = true;
    read_laser(px, model.channels[laser]);
  }
  if (const auto absent = std::ranges::find(seen, false); absent != seen.end())
    throw bad_input("laser " + std::to_string(absent - seen.begin()) + " is absent",
                    "all " + std::to_string(seen.size()) + " lasers of a " + model.name);
  number_rings(model.channels);
  return model;
}

}  // namespace bole::sensor
