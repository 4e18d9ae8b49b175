#include "io/core/tables/trajectory_file.h"

#include <fmt/format.h>

#include <Eigen/LU>

#include <cmath>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/option.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/formats.h"

namespace bole::io {
namespace {

constexpr double max_length_error = 0.01;
constexpr double max_rotation_error = 1e-3;

// Calls `use(numbers, place)` for each line that is not a comment. `place` is "name line 12". Commas or blanks stand
// between the numbers.
template <class F>
void for_each_line(Bytes file, const std::string& name, std::size_t count, const char* needed, F&& use) {
  LineReader lines(file);
  std::string_view line;
  std::vector<double> values(count);
  while (lines.next(line)) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    std::string copy(line);
    for (char& c : copy)
      if (c == ',') c = ' ';
    const auto words = split_blanks(copy);
    const auto place = "'" + name + "' line " + std::to_string(lines.number());
    if (words.size() != count)
      throw bad_input(place + " has " + std::to_string(words.size()) + (words.size() == 1 ? " value" : " values"),
                      needed);
    for (std::size_t i = 0; i < count; ++i)
      if (!parse_number(words[i], values[i]) || !std::isfinite(values[i]))
        throw bad_input(place + " has '" + std::string(words[i].substr(0, 40)) + "'", needed);
    use(values, place);
  }
}

void check_not_empty(const Trajectory& trajectory, const std::string& name, const char* needed) {
  if (trajectory.empty()) throw bad_input("'" + name + "' holds no poses", needed);
}

}  // namespace

Trajectory read_tum(Bytes file, const std::string& name) {
  constexpr const char* needed = "time tx ty tz qx qy qz qw";
  Trajectory trajectory;
  for_each_line(file, name, 8, needed, [&](const std::vector<double>& v, const std::string& place) {
    Eigen::Quaterniond q(v[7], v[4], v[5], v[6]);
    if (!(std::abs(q.norm() - 1) <= max_length_error))
      throw bad_input(place + " has a quaternion of length " + number_text(q.norm()),
                      "length 1 and the order qx qy qz qw");
    if (!trajectory.empty() && v[0] <= trajectory.poses.back().time_s)
      throw bad_input(
          place + " has time " + number_text(v[0]) + " after " + number_text(trajectory.poses.back().time_s),
          "times that increase");
    Pose pose = Pose::Identity();
    pose.linear() = q.normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
    trajectory.poses.push_back({v[0], pose});
  });
  check_not_empty(trajectory, name, needed);
  return trajectory;
}

Trajectory read_tum(const std::filesystem::path& path) {
  const MappedFile file(path);
  return read_tum(file.bytes(), path.string());
}

Trajectory read_kitti_poses(Bytes file, const std::string& name, const std::vector<double>& times_s) {
  constexpr const char* needed = "12 numbers: the rows of a 3 by 4 matrix";
  Trajectory trajectory;
  for_each_line(file, name, 12, needed, [&](const std::vector<double>& v, const std::string& place) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>> matrix(v.data());
    const Eigen::Matrix3d rotation = matrix.leftCols<3>();
    if (!((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < max_rotation_error &&
          rotation.determinant() > 0))
      throw bad_input(place + " is no rotation and translation", needed);
    Pose pose = Pose::Identity();
    pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    pose.translation() = matrix.col(3);
    const std::size_t i = trajectory.poses.size();
    if (!times_s.empty() && i >= times_s.size())
      throw bad_input(place + " has no time: there are " + std::to_string(times_s.size()), "one time per pose");
    trajectory.poses.push_back({times_s.empty() ? static_cast<double>(i) : times_s[i], pose});
  });
  check_not_empty(trajectory, name, needed);
  return trajectory;
}

Trajectory read_kitti_poses(const std::filesystem::path& path, const std::vector<double>& times_s) {
  const MappedFile file(path);
  return read_kitti_poses(file.bytes(), path.string(), times_s);
}

bool looks_like_kitti_poses(Bytes file) {
  LineReader lines(file);
  std::string_view line;
  while (lines.next(line) && (trimmed(line).empty() || trimmed(line).front() == '#')) continue;
  return split_blanks(line).size() == 12;
}

Trajectory read_trajectory(const std::filesystem::path& path, std::optional<TrajectoryFormat> format) {
  if (path.empty())
    throw bad_input("no trajectory is named", format_list(FileContent::trajectory), "Set the option file");
  const MappedFile file(path);
  constexpr std::array trajectories{FileContent::trajectory};
  const auto& row = format ? format_named(FileContent::trajectory, choice_name(*format))
                           : *find_format(file.bytes(), path, trajectories);
  return std::get<TrajectoryAccess>(row.access).read(file.bytes(), path.string());
}

void write_tum(const std::filesystem::path& path, const Trajectory& trajectory) {
  std::string text;
  for (const auto& p : trajectory.poses) {
    const Eigen::Vector3d t = p.T_target_sensor.translation();
    const Eigen::Quaterniond q(p.T_target_sensor.linear());
    fmt::format_to(std::back_inserter(text), "{:.6f} {:.6f} {:.6f} {:.6f} {:.9f} {:.9f} {:.9f} {:.9f}\n", p.time_s,
                   t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  write_text_file(path, text);
}

void write_kitti_poses(const std::filesystem::path& path, const Trajectory& trajectory) {
  std::string text;
  for (const auto& p : trajectory.poses)
    for (int r = 0; r < 3; ++r) {
      const auto row = p.T_target_sensor.matrix().row(r);
      fmt::format_to(std::back_inserter(text), "{:.9e} {:.9e} {:.9e} {:.9e}{}", row[0], row[1], row[2], row[3],
                     r < 2 ? ' ' : '\n');
    }
  write_text_file(path, text);
}

}  // namespace bole::io
