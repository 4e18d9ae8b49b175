// Given poses: a text file of lines "time x y z qx qy qz qw" (TUM), '#' starts a comment.
#pragma once

#include <filesystem>
#include <vector>

#include "cloud/trajectory.h"

namespace bole::slam {

// Throws Error{bad_input} that names file and line for a line that is not eight numbers, a zero quaternion, or a time
// that does not rise.
std::vector<StampedPose> read_tum_poses(const std::filesystem::path& file);

}  // namespace bole::slam
