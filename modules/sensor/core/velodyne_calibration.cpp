#include "sensor/core/velodyne_calibration.h"

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "base/angles.h"
#include "base/error.h"
#include "sensor/core/calibrated_lasers.h"

namespace bole::sensor {
namespace {

constexpr double metres_per_cm = 0.01;

double xml_number(const pugi::xml_node& node, const char* name, double limit) {
  return calibration_number(node.child_value(name), "<" + std::string(name) + ">", limit);
}

pugi::xml_node database(const pugi::xml_document& document) {
  return document.child("boost_serialization").child("DB");
}

std::size_t enabled_lasers(const pugi::xml_node& db) {
  std::size_t enabled = 0;
  for (const auto& item : db.child("enabled_").children("item")) enabled += item.text().as_int() != 0;
  return enabled;
}

// Angles are in degrees, lengths in centimetres.
CalibratedLaser read_laser(const pugi::xml_node& px) {
  CalibratedLaser laser;
  laser.id = xml_number(px, "id_", 255);
  laser.elevation_rad = radians(xml_number(px, "vertCorrection_", 90));
  laser.azimuth_offset_rad = -radians(xml_number(px, "rotCorrection_", 180));
  auto& offsets = laser.offsets;
  offsets.range = xml_number(px, "distCorrection_", 1000) * metres_per_cm;
  offsets.vertical = xml_number(px, "vertOffsetCorrection_", 100) * metres_per_cm;
  offsets.horizontal = xml_number(px, "horizOffsetCorrection_", 100) * metres_per_cm;
  if (px.child("distCorrectionX_").empty()) return laser;
  offsets.near_x = xml_number(px, "distCorrectionX_", 1000) * metres_per_cm;
  offsets.near_y = xml_number(px, "distCorrectionY_", 1000) * metres_per_cm;
  // Older units have one distance only, and zeros in its place.
  offsets.two_points = offsets.near_x != 0 || offsets.near_y != 0;
  return laser;
}

bool looks_like_xml_calibration(std::string_view text) {
  return text.find("boost_serialization") != std::string_view::npos &&
         text.find("rotCorrection_") != std::string_view::npos;
}

}  // namespace

bool is_velodyne_calibration(std::string_view text) {
  return looks_like_xml_calibration(text) ||
         (text.find("laser_id") != std::string_view::npos && text.find("rot_correction") != std::string_view::npos &&
          text.find("vert_correction") != std::string_view::npos);
}

bool may_be_velodyne_calibration(const std::filesystem::path& path) {
  const auto ending = path.extension();
  return ending == ".xml" || ending == ".yaml" || ending == ".yml";
}

SensorModel velodyne_model_from_xml(std::string_view xml) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(xml.data(), xml.size());
  if (!parsed)
    throw bad_input(std::string("the calibration is no XML: ") + parsed.description(), "the db.xml of a Velodyne unit");
  const auto db = database(document);
  if (db.empty()) throw bad_input("the XML has no <DB> in <boost_serialization>", "the db.xml of a Velodyne unit");
  const auto lasers = enabled_lasers(db);
  std::vector<CalibratedLaser> unit;
  for (const auto& item : db.child("points_").children("item"))
    if (const auto px = item.child("px"); xml_number(px, "id_", 255) < static_cast<double>(lasers))
      unit.push_back(read_laser(px));  // those that the sensor does not have may hold anything
  return calibrated_model(lasers, xml_number(db, "distLSB_", 10) * metres_per_cm, unit);
}

SensorModel velodyne_model_from(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  const bool xml = begin != std::string_view::npos && text[begin] == '<';
  return xml ? velodyne_model_from_xml(text) : velodyne_model_from_yaml(text);
}

}  // namespace bole::sensor
