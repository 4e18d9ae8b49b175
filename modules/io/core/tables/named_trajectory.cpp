#include "io/core/tables/named_trajectory.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cloud/known_facts.h"
#include "io/core/tables/named_layout.h"

namespace bole::io {
namespace {

Pose pose_of(const named::Lines& lines, const named::Layout& layout) {
  using namespace named;
  Pose pose = Pose::Identity();
  const auto number = [&](int role) { return lines.number(role); };
  if (layout.has_matrix()) {
    Eigen::Matrix3d rotation;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) rotation(r, c) = number(matrix + 4 * r + c);
      pose.translation()[r] = number(matrix + 4 * r + 3);
    }
    constexpr double max_error = 1e-2;
    if (!((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < max_error &&
          rotation.determinant() > 0))
      throw bad_input(lines.place() + " is no rotation and translation", "the rows of a 3 by 4 matrix");
    pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    return pose;
  }
  pose.translation() = layout.is_geographic() ? Eigen::Vector3d(number(longitude), number(latitude), number(z))
                                              : Eigen::Vector3d(number(x), number(y), number(z));
  if (layout.has_all(qw, 4)) {
    const Eigen::Quaterniond q(number(qw), number(qx), number(qy), number(qz));
    constexpr double max_error = 0.01;
    if (!(std::abs(q.norm() - 1) <= max_error))
      throw bad_input(lines.place() + " has a quaternion of length " + std::to_string(q.norm()), "length 1");
    pose.linear() = q.normalized().toRotationMatrix();
  }
  return pose;
}

}  // namespace

bool looks_like_named_trajectory(Bytes file) {
  LineReader lines(file.first(std::min<std::size_t>(file.size(), 1 << 16)));
  std::string_view line;
  while (lines.next(line) && trimmed(line).empty()) continue;
  const auto layout = named::layout_of(trimmed(line));
  if (!layout || !trimmed(line).starts_with('#') || layout->open_end) return layout.has_value();
  // A comment above TUM poses may go on behind the names.
  std::vector<std::string_view> words;
  while (lines.next(line))
    if (line = trimmed(line); !line.empty() && line.front() != '#') {
      named::split(line, line.find(layout->delimiter) == line.npos ? named::separator_in(line) : layout->delimiter,
                   words);
      return words.size() == layout->columns;
    }
  return true;
}

Trajectory read_named_trajectory(Bytes file, const std::string& name) {
  LineReader first(file);
  std::string_view header;
  while (first.next(header) && trimmed(header).empty()) continue;
  const auto layout = named::layout_of(trimmed(header));
  constexpr const char* needed =
      "a first line that names the columns, with time and x y z (or longitude latitude height)";
  if (!layout) throw bad_input("'" + name + "' begins with '" + std::string(header.substr(0, 80)) + "'", needed);
  Trajectory trajectory;
  named::Lines lines(file.subspan(first.position()), name, *layout, first.number());
  std::size_t repeated = 0;
  while (lines.next()) {
    const double time = lines.time();
    if (!trajectory.empty() && time <= trajectory.poses.back().time_s) {
      if (time < trajectory.poses.back().time_s)
        throw bad_input(lines.place() + " has time " + std::to_string(time) + " after " +
                            std::to_string(trajectory.poses.back().time_s),
                        "times that increase");
      ++repeated;
      continue;
    }
    trajectory.poses.push_back({time, pose_of(lines, *layout)});
  }
  if (trajectory.empty()) throw bad_input("'" + name + "' holds no poses", needed);
  if (repeated > 0) trajectory.facts["repeated_times"] = std::to_string(repeated);
  if (!layout->has_matrix() && !layout->has_all(named::qw, 4)) trajectory.facts["orientation"] = "unknown";
  if (!layout->has_matrix() && layout->is_geographic()) set_fact(trajectory.facts, facts::crs, geographic_crs);
  return trajectory;
}

bool is_geographic(const Trajectory& trajectory) {
  return fact_text(trajectory.facts, facts::crs) == std::string(geographic_crs);
}

}  // namespace bole::io
