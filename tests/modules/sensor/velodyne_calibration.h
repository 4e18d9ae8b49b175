// The calibration of a Velodyne unit as the maker writes it (db.xml): degrees and centimetres.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace bole::testing_velodyne {

struct UnitLaser {
  double rotation_deg = 0, vertical_deg = 0;
  double range_cm = 0, near_x_cm = 0, near_y_cm = 0, vertical_offset_cm = 0, horizontal_offset_cm = 0;
  int id = -1;  // the place in the list
};

inline std::string calibration_xml(const std::vector<UnitLaser>& lasers, double range_step_cm = 0.2) {
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>\n<!DOCTYPE boost_serialization>\n"
      "<boost_serialization signature=\"serialization::archive\" version=\"4\">\n<DB class_id=\"0\">\n"
      "<distLSB_>{}</distLSB_>\n<enabled_>\n<count>64</count>\n",
      range_step_cm);
  for (std::size_t i = 0; i < 64; ++i) xml += i < lasers.size() ? "<item>1</item>\n" : "<item>0</item>\n";
  xml += "</enabled_>\n<points_>\n<count>64</count>\n";
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    const auto& l = lasers[i];
    xml += fmt::format(
        "<item><px><id_>{}</id_><rotCorrection_>{}</rotCorrection_><vertCorrection_>{}</vertCorrection_>"
        "<distCorrection_>{}</distCorrection_><distCorrectionX_>{}</distCorrectionX_>"
        "<distCorrectionY_>{}</distCorrectionY_><vertOffsetCorrection_>{}</vertOffsetCorrection_>"
        "<horizOffsetCorrection_>{}</horizOffsetCorrection_><focalDistance_>0</focalDistance_>"
        "<focalSlope_>0</focalSlope_></px></item>\n",
        l.id < 0 ? static_cast<int>(i) : l.id, l.rotation_deg, l.vertical_deg, l.range_cm, l.near_x_cm, l.near_y_cm,
        l.vertical_offset_cm, l.horizontal_offset_cm);
  }
  return xml + "</points_>\n</DB>\n</boost_serialization>\n";
}

}  // namespace bole::testing_velodyne
