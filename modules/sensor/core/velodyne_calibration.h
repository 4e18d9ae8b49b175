// The calibration of a Velodyne unit: the maker's XML (db.xml, as VeloView keeps it), or the YAML of ROS
// (velodyne_pointcloud, its converter gen_calibration.py, and Nebula).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "sensor/core/sensor_model.h"

namespace bole::sensor {

inline constexpr std::uintmax_t max_velodyne_calibration_bytes = 4 << 20;

// Whether a text looks like one of the two forms.
bool is_velodyne_calibration(std::string_view text);

// Whether a file with this ending may be one (.xml, .yaml, .yml).
bool may_be_velodyne_calibration(const std::filesystem::path& path);

// The nominal model with the angles and offsets of the unit's lasers. 64 lasers are an HDL-64E, 128 a VLS-128, 16 a
// VLP-16; of 32 the VLP-32C has ranges in steps of 4 mm, the HDL-32E of 2 mm. A vertical offset of a sensor other than
// the HDL-64E is the height of the laser on the axis. Where all of them are zero the file does not know them: the
// heights of the nominal model stay. Throws Error{bad_input} that names what is absent or cannot be.
SensorModel velodyne_model_from_xml(std::string_view xml);
SensorModel velodyne_model_from_yaml(std::string_view yaml);
SensorModel velodyne_model_from(std::string_view text);  // either form

}  // namespace bole::sensor
