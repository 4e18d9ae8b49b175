// The calibration of a Velodyne unit that lies beside a capture (db.xml, or the YAML of ROS).
#pragma once

#include <filesystem>
#include <optional>

#include "sensor/core/sensor_model.h"

namespace bole::io {

// The file with the name of the capture, or the only one in its folder that is of this sensor. `foreign` gets one that
// is of another sensor. Throws Error{bad_input} where several are of this one, or one cannot be read.
std::optional<sensor::SensorModel> calibration_beside(const std::filesystem::path& capture,
                                                      const sensor::SensorModel& nominal,
                                                      std::optional<sensor::SensorModel>& foreign);

}  // namespace bole::io
