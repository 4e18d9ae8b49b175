// Given poses: a text file with lines "time x y z qx qy qz qw" (TUM); '#' starts a comment.
#pragma once

#include <filesystem>
#include <vector>

#include "cloud/trajectory.h"

namespace bole::slam {

// Throws Error{bad_input} with file and line where a line is not eight numbers, a quaternion is not of length 1, or the
// times are not ascending.
std::vector<StampedPose> read_tum_poses(const std::filesystem::path& file);

}  // namespace bole::slam
