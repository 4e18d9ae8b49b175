// The calibration of a Velodyne unit, as the maker writes it (db.xml: degrees and centimetres) and as ROS does (YAML).
#pragma once

#include <fmt/format.h>

#include <numbers>
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

// The same as ROS keeps it: radians and metres, one map per laser, in block or flow style.
inline std::string calibration_yaml(const std::vector<UnitLaser>& lasers, double range_step_m, bool flow = false,
                                    const std::string& more = {}) {
  constexpr double degree = std::numbers::pi / 180;
  std::string yaml = "lasers:\n";
  for (std::size_t i = 0; i < lasers.size(); ++i) {
    const auto& l = lasers[i];
    std::string entry = fmt::format(
        "dist_correction: {}, dist_correction_x: {}, dist_correction_y: {}, focal_distance: 0.0, focal_slope: 0.0, "
        "horiz_offset_correction: {}, laser_id: {}, {}rot_correction: {}, vert_correction: {}, "
        "vert_offset_correction: {}",
        l.range_cm / 100, l.near_x_cm / 100, l.near_y_cm / 100, l.horizontal_offset_cm / 100,
        l.id < 0 ? static_cast<int>(i) : l.id, more, l.rotation_deg * degree, l.vertical_deg * degree,
        l.vertical_offset_cm / 100);
    if (!flow)
      for (std::size_t at = 0; (at = entry.find(", ", at)) != std::string::npos;) entry.replace(at, 2, "\n    ");
    yaml += flow ? "  - {" + entry + "}\n" : "  - " + entry + "\n";
  }
  return yaml + fmt::format("num_lasers: {}  # of the unit\ndistance_resolution: {}\n", lasers.size(), range_step_m);
}

}  // namespace bole::testing_velodyne
