// The calibration of a Velodyne unit, as it comes with an HDL-64E and as VeloView keeps it (db.xml).
#pragma once

#include <string_view>

#include "sensor/core/sensor_model.h"

namespace bole::sensor {

bool is_velodyne_calibration(std::string_view xml);

// The nominal model with the angles and offsets of the unit's lasers. 64 enabled lasers are an HDL-64E, 16 a VLP-16; of
// 32 the VLP-32C has ranges in steps of 4 mm, the HDL-32E of 2 mm. Throws Error{bad_input} that names what is absent or
// cannot be.
SensorModel velodyne_model_from_xml(std::string_view xml);

}  // namespace bole::sensor
