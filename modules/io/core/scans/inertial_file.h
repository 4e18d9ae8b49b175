// Measurements of an inertial unit as text, beside the recording of a scanner.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/report.h"
#include "base/run.h"
#include "cloud/scan_frame.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Reads a table with a header line. A column of times (time_s, time, t, timestamp), three of angular rate (gyro_x,
// gx, wx, angular_velocity_x, w_RS_S_x, ..) and three of specific force (accel_x, ax, linear_acceleration_x,
// a_RS_S_x, ..). Units stand behind the names, as accel_x_m_s2, accel_x_g or "timestamp [ns]"; without them they are
// s, rad/s and m/s2. Lines "# name: value" above the header may give T_sensor_imu (x y z qx qy qz qw) and the densities
// of InertialNoise. Rows that are no numbers or go back in time are dropped and counted.
// Throws Error{bad_input} where columns are missing, or where gravity or the rates show that the unit is another one.
InertialRecord read_inertial(Bytes file, const std::string& name, Report& report, const Run& run = {});
InertialRecord read_inertial(const std::filesystem::path& path, Report& report, const Run& run = {});

// Beside `scan`: imu.csv, or NAME_imu.csv for a scan NAME.pcap; for a folder also in it, or above it where it holds
// frames alone. Empty where there is none.
std::filesystem::path inertial_file_beside(const std::filesystem::path& scan);

// `source` with the record of the file `imu`, or with the one found beside the scan where `imu` is empty and the source
// has none of its own; "none" takes all away. A file that is named must fit: Error{bad_input} where it does not overlap
// the scan in time. One that is found and does not fit is left out with a warning.
std::shared_ptr<const FrameSource> with_inertial_file(std::shared_ptr<const FrameSource> source,
                                                      const std::filesystem::path& scan, const std::string& imu,
                                                      const Run& run, Report& report);

}  // namespace bole::io
