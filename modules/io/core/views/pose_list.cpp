#include "io/core/views/pose_list.h"

#include <cmath>

#include "base/error.h"
#include "base/option.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/views/pose_matrix.h"

namespace bole::io {
namespace {

using Rows = std::vector<std::vector<double>>;

constexpr const char* needed_lines =
    "per view: tx ty tz qx qy qz qw, a time before them, 12 or 16 numbers of a matrix, or 4 lines of a matrix";

Pose pose_of_quaternion(const double* v, const std::string& place) {
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1) <= 0.01) || !std::isfinite(v[0] + v[1] + v[2]))
    throw bad_input(place + " has a quaternion of length " + number_text(q.norm()),
                    "length 1 and the order qx qy qz qw");
  Pose pose = Pose::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

ListedPose pose_of_line(const std::vector<double>& line, const std::string& place) {
  switch (line.size()) {
    case 7:
      return {{}, pose_of_quaternion(line.data(), place)};
    case 8:
      return {line[0], pose_of_quaternion(line.data() + 1, place)};
    default:
      return {{}, pose_from_matrix(line, place)};
  }
}

// Matrices of four lines, with or without a line of two to four numbers above each.
std::vector<ListedPose> poses_of_blocks(const Rows& rows, const std::string& name) {
  std::vector<ListedPose> poses;
  std::size_t at = 0;
  // A heading of four numbers would look like a row of a matrix: Open3D's has three.
  const bool headed = rows.front().size() != 4;
  while (at < rows.size()) {
    const auto place = "'" + name + "' pose " + std::to_string(poses.size() + 1);
    ListedPose listed;
    if (headed) {
      if (rows[at].size() > 3 || rows[at].empty())
        throw bad_input(place + " has no line of numbers above it", needed_lines);
      listed.key = rows[at++][0];
    }
    std::vector<double> matrix;
    for (int i = 0; i < 4; ++i, ++at) {
      if (at >= rows.size() || rows[at].size() != 4) throw bad_input(place + " is cut off or no matrix", needed_lines);
      matrix.insert(matrix.end(), rows[at].begin(), rows[at].end());
    }
    listed.pose = pose_from_matrix(matrix, place);
    poses.push_back(std::move(listed));
  }
  return poses;
}

}  // namespace

Rows number_lines(Bytes text, const std::string& name) {
  Rows rows;
  LineReader lines(text);
  std::string_view line;
  while (lines.next(line)) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    std::string copy(line);
    for (char& c : copy)
      if (c == ',') c = ' ';
    std::vector<double> numbers;
    for (const auto word : split_blanks(copy)) {
      double value = 0;
      if (numbers.size() >= 64 || !parse_number(word, value))
        throw bad_input(
            "'" + name + "' line " + std::to_string(lines.number()) + " has '" + std::string(word.substr(0, 40)) + "'",
            "numbers");
      numbers.push_back(value);
    }
    if (!numbers.empty()) rows.push_back(std::move(numbers));
  }
  return rows;
}

std::vector<ListedPose> parse_pose_list(Bytes text, const std::string& name) {
  const auto rows = number_lines(text, name);
  if (rows.empty()) throw bad_input("'" + name + "' holds no poses", needed_lines);
  const auto width = rows.front().size();
  if (width <= 4) return poses_of_blocks(rows, name);
  if (width != 7 && width != 8 && width != 12 && width != 16)
    throw bad_input("'" + name + "' has lines of " + std::to_string(width) + " numbers", needed_lines);
  std::vector<ListedPose> poses;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto place = "'" + name + "' pose " + std::to_string(i + 1);
    if (rows[i].size() != width)
      throw bad_input(place + " has " + std::to_string(rows[i].size()) + " numbers", std::to_string(width));
    poses.push_back(pose_of_line(rows[i], place));
  }
  return poses;
}

std::vector<ListedPose> read_pose_list(const std::filesystem::path& path) {
  const MappedFile file(path);
  return parse_pose_list(file.bytes(), path.string());
}

std::optional<Pose> read_pose_matrix(const std::filesystem::path& path) {
  const MappedFile file(path);
  std::vector<double> matrix;
  for (const auto& row : number_lines(file.bytes(), path.string())) matrix.insert(matrix.end(), row.begin(), row.end());
  for (const double v : matrix)
    if (!std::isfinite(v)) return std::nullopt;
  return pose_from_matrix(matrix, "'" + path.string() + "'");
}

}  // namespace bole::io
