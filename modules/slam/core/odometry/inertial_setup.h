// The inertial unit of a recording, made ready for SLAM.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "cloud/scan_frame.h"
#include "slam/core/inertial/preintegration.h"
#include "slam/core/odometry/odometry.h"
#include "slam/core/options.h"

namespace bole::slam {

// Nothing where the recording has none or it is not to be used; the report says why. Where its mount in the scanner is
// not known, the first minute of the walk is followed without it, and the mount is estimated from that. Throws
// Error{bad_input} where the unit is required and there is none, or its mount cannot be told; Error{cancelled}.
std::optional<InertialUnit> prepare_unit(const FrameSource& source, const SlamSettings& options, Report& report,
                                         const Run& run);

// Writes a mount that was estimated, with its standard deviations, to the report.
void tell_mount(const Pose& T_sensor_imu, double time_offset_s, const MountSigmas& sigmas, Report& report);

// A finding for the longest stretch over which the unit alone carried a motion, where the map behind may be off by more
// than a stem is placed to.
void tell_unit_alone(const std::vector<TrackedFrame>& frames, Report& report);

}  // namespace bole::slam
