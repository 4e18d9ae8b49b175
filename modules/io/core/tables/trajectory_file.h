// Trajectories as text: TUM (time and pose) and KITTI (pose matrices without times).
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/trajectory.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Lines "time tx ty tz qx qy qz qw"; # begins a comment. Quaternions are normalised. Throws Error{bad_input} that names
// the line where there are not eight finite numbers, the length of the quaternion differs from 1 by more than 1 %, or
// the time does not increase.
Trajectory read_tum(const std::filesystem::path& path);
Trajectory read_tum(Bytes file, const std::string& name);

// Lines of twelve numbers, the upper rows of T_map_sensor. `times_s` has one time per pose; where it is empty, times
// are 0, 1, 2, ... Rotations must be orthonormal to 1e-3 and are made exactly orthonormal. Poses in camera axes, such
// as KITTI's ground truth, are not converted.
Trajectory read_kitti_poses(const std::filesystem::path& path, const std::vector<double>& times_s = {});
Trajectory read_kitti_poses(Bytes file, const std::string& name, const std::vector<double>& times_s = {});

enum class TrajectoryFormat { tum, kitti, named, sbet };
constexpr std::array<std::string_view, 4> choice_names(TrajectoryFormat) { return {"tum", "kitti", "named", "sbet"}; }

// Any of them, without a format by the content. Throws Error{bad_input}.
Trajectory read_trajectory(const std::filesystem::path& path, std::optional<TrajectoryFormat> format = {});

// Whether the first line that is no comment holds 12 values.
bool looks_like_kitti_poses(Bytes file);

// Times and positions have six decimals, rotations nine.
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);
void write_kitti_poses(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace bole::io
