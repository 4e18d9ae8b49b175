// Trajectories as text: TUM (time and pose) and KITTI (pose matrices without times).
#pragma once

#include <filesystem>
#include <vector>

#include "cloud/trajectory.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Lines "time tx ty tz qx qy qz qw", # begins a comment. Quaternions are normalised. Throws Error{bad_input} naming the
// line: not eight numbers, not finite, a quaternion whose length is not within 1 % of one (files round it), a time that
// does not increase.
Trajectory read_tum(const std::filesystem::path& path);
Trajectory read_tum(Bytes file, const std::string& name);

// Lines of twelve numbers, the upper rows of T_map_sensor. `times_s`: one per pose; empty: 0, 1, 2, ... Rotations must
// be orthonormal to 1e-3 and are made so exactly. KITTI's ground truth is in camera axes: it is read as it is.
Trajectory read_kitti_poses(const std::filesystem::path& path, const std::vector<double>& times_s = {});
Trajectory read_kitti_poses(Bytes file, const std::string& name, const std::vector<double>& times_s = {});

// Either of them; `format` is tum, kitti or auto (by the number of values on the first line). Throws Error{bad_input}.
Trajectory read_trajectory(const std::filesystem::path& path, const std::string& format = "auto");

// Times and positions with six digits after the point, rotations with nine.
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);
void write_kitti_poses(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace bole::io
