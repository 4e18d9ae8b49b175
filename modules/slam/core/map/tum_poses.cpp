#include "slam/core/map/tum_poses.h"

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/option.h"

namespace bole::slam {

std::vector<StampedPose> read_tum_poses(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw bad_input("the trajectory " + file.string() + " cannot be opened", "a readable TUM file");
  std::vector<StampedPose> poses;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const auto start = line.find_first_not_of(" \t\r");
    if (start == std::string::npos || line[start] == '#') continue;
    const auto place = file.string() + ":" + std::to_string(number);
    std::array<double, 8> v{};
    std::istringstream words(line);
    for (auto& x : v)
      if (!(words >> x) || !std::isfinite(x))
        throw bad_input("'" + line.substr(0, 80) + "'", "eight numbers: time x y z qx qy qz qw").at(place);
    const Eigen::Quaterniond q(v[7], v[4], v[5], v[6]);
    if (std::abs(q.norm() - 1) > 0.01)
      throw bad_input("a quaternion of length " + number_text(q.norm()), "one of length 1").at(place);
    if (!poses.empty() && v[0] <= poses.back().time_s)
      throw bad_input("time " + number_text(v[0]) + " s", "a time after " + number_text(poses.back().time_s) + " s",
                      "Sort the poses by time")
          .at(place);
    StampedPose pose;
    pose.time_s = v[0];
    pose.T_target_sensor.linear() = q.normalized().toRotationMatrix();
    pose.T_target_sensor.translation() = Eigen::Vector3d(v[1], v[2], v[3]);
    poses.push_back(pose);
  }
  if (poses.size() < 2)
    throw bad_input("the trajectory " + file.string() + " has " + std::to_string(poses.size()) + " poses",
                    "at least 2");
  return poses;
}

}  // namespace bole::slam
