// Scans of real sensors with a reference that others have made.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "real_data.h"
#include "slam/core/odometry/features.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/odometry/registration.h"

namespace bole::slam {
namespace {

namespace fs = std::filesystem;
const fs::path data = BOLE_SHARED_DATA_DIR;

template <class T>
std::vector<T> read_values(const fs::path& file) {
  std::vector<T> values(fs::file_size(file) / sizeof(T));
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(T)));
  return values;
}

// Three sweeps of an OS1-64 carried by hand (Newer College), with the time of each point and the same points de-skewed
// by an IMU, in axes that are turned by half a circle. Each raw sweep is registered, begin and end pose unknown,
// against the de-skewed one, as if that were the map; then every point must lie where the reference has it.
TEST(RealScans, TheDeskewedSweepsOfNewerCollegeAreReproduced) {
  const fs::path folder = data / "GTSAMPOINTS/newer_06";
  BOLE_NEEDS_REAL(folder);
  // What an even motion between two poses leaves when it is fitted to the points themselves: hands do not move evenly.
  const std::array<double, 3> best_distance{0.053, 0.018, 0.081};
  for (std::size_t k = 0; k < best_distance.size(); ++k) {
    const std::string number = "_0" + std::to_string(k) + ".bin";
    const auto raw = read_values<Eigen::Vector3f>(folder / ("raw" + number)),
               reference = read_values<Eigen::Vector3f>(folder / ("deskewed" + number));
    const auto time_s = read_values<float>(folder / ("times" + number));
    ASSERT_GT(raw.size(), 10000u);
    ASSERT_EQ(raw.size(), reference.size());
    ASSERT_EQ(raw.size(), time_s.size());
    const float span_s = std::ranges::max(time_s);

    FeatureMaps maps(0.1);
    FeatureSet features;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      maps.planes.insert(reference[i].cast<double>());
      features.planes.push_back({raw[i], time_s[i] / span_s});
    }
    Pose T_start = Pose::Identity();
    T_start.linear() = rotation_from_rpy(0, 0, std::numbers::pi);
    RegistrationSettings settings;
    settings.model = MotionModel::rigid;
    settings.iterations = 30;
    settings.coarse_iterations = 8;
    auto found = register_frame(features, maps, {T_start, T_start}, settings, {});
    settings.model = MotionModel::elastic;
    settings.begin_sigma = settings.motion_sigma = 1;
    settings.begin_sigma_rad = settings.motion_sigma_rad = 1;
    settings.iterations = 60;
    found = register_frame(features, maps, found.motion, settings, {});

    const auto rms = [&](const FrameMotion& motion) {
      const PoseGrid poses(motion);
      double squared = 0;
      for (std::size_t i = 0; i < raw.size(); ++i)
        squared += (poses.in_map(raw[i], time_s[i] / span_s) - reference[i].cast<double>()).squaredNorm();
      return std::sqrt(squared / static_cast<double>(raw.size()));
    };
    const Pose T_mid = found.motion.at(0.5);
    EXPECT_LT(rms(found.motion), best_distance[k] + 0.025) << k << ": " << rms({T_mid, T_mid}) << " m as it was";
    EXPECT_GT(rms({T_mid, T_mid}), 5 * rms(found.motion)) << k;
  }
}

std::vector<FeaturePoint> read_trunks(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && !line.starts_with("DATA")) {
  }
  std::vector<FeaturePoint> points;
  while (std::getline(in, line)) {
    Eigen::Vector3f p;
    if (std::sscanf(line.c_str(), "%f %f %f", &p.x(), &p.y(), &p.z()) == 3 && p.allFinite() && p.norm() > 0.5f)
      points.push_back({p, 1});
  }
  return points;
}

// The first and second pose of the odometry messages in poses.txt.
std::vector<Pose> read_poses(const fs::path& file) {
  std::vector<Pose> poses;
  std::ifstream in(file);
  std::string line;
  std::vector<double> values;  // of the pose in work: x y z, x y z w
  bool twist = false;
  while (std::getline(in, line)) {
    char name = 0;
    double value = 0;
    if (line.starts_with("twist:")) twist = true;
    if (line.starts_with("header:")) {
      twist = false;
      values.clear();
    }
    if (twist || std::sscanf(line.c_str(), " %c: %lf", &name, &value) != 2 || name < 'w' || name > 'z') continue;
    values.push_back(value);
    if (values.size() < 7) continue;
    Pose T = Pose::Identity();
    T.linear() = Eigen::Quaterniond(values[6], values[3], values[4], values[5]).normalized().toRotationMatrix();
    T.translation() = Eigen::Vector3d(values[0], values[1], values[2]);
    poses.push_back(T);
    values.clear();
  }
  return poses;
}

// Two sweeps of a flying OS1-64 in a forest, trunks alone: nothing but trees tells the motion, and they hardly tell
// the height.
TEST(RealScans, TrunksAloneGiveTheMotionBetweenForestScans) {
  const fs::path folder = data / "SLOAM_forest_scans";
  BOLE_NEEDS_REAL(folder);
  const auto poses = read_poses(folder / "poses.txt");
  ASSERT_EQ(poses.size(), 2u);
  const Pose T_0_1 = poses[0].inverse() * poses[1];
  for (const char* pair : {"moving_tree", "still_tree"}) {
    FeatureMaps maps(0.1);
    for (const auto& p : read_trunks(folder / (std::string(pair) + "_t0.pcd")))
      maps.planes.insert(p.position.cast<double>());
    const FeatureSet features{{}, read_trunks(folder / (std::string(pair) + "_t1.pcd"))};
    RegistrationSettings settings;
    settings.iterations = 40;
    settings.coarse_iterations = 8;
    const auto found = register_frame(features, maps, {}, settings, {});
    const Pose& T = found.motion.T_map_end;
    const Pose error = (pair == std::string("moving_tree") ? T_0_1 : Pose::Identity()).inverse() * T;
    // The sweeps of the moving pair are not de-skewed: 12 cm of motion within each.
    EXPECT_LT(error.translation().norm(), pair == std::string("moving_tree") ? 0.07 : 0.01) << pair;
    EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle() * 180 / std::numbers::pi,
              pair == std::string("moving_tree") ? 0.6 : 0.2)
        << pair;
    EXPECT_GT(found.overlap, 0.5) << pair;
  }
}

}  // namespace
}  // namespace bole::slam
