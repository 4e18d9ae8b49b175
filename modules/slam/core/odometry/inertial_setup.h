// The inertial unit of a recording, made ready for SLAM.
#pragma once

#include <optional>

#include "base/report.h"
#include "cloud/scan_frame.h"
#include "slam/core/inertial/preintegration.h"
#include "slam/core/options.h"

namespace bole::slam {

// Nothing where the recording has none or it is not to be used; the report says why. Where its mount in the scanner is
// not known, the first minute of the walk is followed without it, and the mount is estimated from that. Throws
// Error{bad_input} where the unit is required and there is none, or its mount cannot be told; Error{cancelled}.
std::optional<InertialUnit> prepare_unit(const FrameSource& source, const SlamSettings& options, Report& report,
                                         const Run& run);

// Writes a mount that was estimated, with its standard deviations, to the report.
void tell_mount(const Pose& T_sensor_imu, double time_offset_s, const MountSigmas& sigmas, Report& report);

}  // namespace bole::slam
