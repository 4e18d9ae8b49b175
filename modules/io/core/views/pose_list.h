// Poses as lists of text: one per view.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/transform.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct ListedPose {
  std::optional<double> key;  // the number or time in front of the pose, where the lines have one
  Pose pose = Pose::Identity();
};

// What the lines hold decides: 7 numbers (tx ty tz qx qy qz qw), 8 (a number or time before them), 12 or 16 (the rows
// of a matrix), or blocks of 4 lines with 4 numbers, each below a line of whole numbers (Open3D's trajectory.log) or
// not. # begins a comment. Throws Error{bad_input} that names the line.
std::vector<ListedPose> parse_pose_list(Bytes text, const std::string& name);
std::vector<ListedPose> read_pose_list(const std::filesystem::path& path);

// One 4 x 4 matrix. Nothing where it holds values that are no numbers, as trackers write for a view that was lost.
std::optional<Pose> read_pose_matrix(const std::filesystem::path& path);

// The numbers of a text file, line by line; comments and empty lines left out. "nan" and "-inf" are numbers here.
std::vector<std::vector<double>> number_lines(Bytes text, const std::string& name);

}  // namespace bole::io
