// Small models of COLMAP, text and binary.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "view_folder.h"

namespace bole::testing_io {

struct ColmapFiles {
  std::string cameras, images, points;
};

inline std::vector<double> quaternion_and_shift(int number) {
  const Pose T_camera_world = pose_number(number).inverse();
  const Eigen::Quaterniond q(T_camera_world.linear());
  const Eigen::Vector3d t = T_camera_world.translation();
  return {q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()};
}

inline ColmapFiles colmap_text(int count, const std::string& camera = "1 OPENCV 64 48 60 61 32 24 0.01 0 0 0.001") {
  ColmapFiles files;
  files.cameras = "# Camera list\n" + camera + "\n";
  files.images = "# Image list\n";
  for (int i = count - 1; i >= 0; --i) {
    files.images += std::to_string(i + 1);
    for (const double v : quaternion_and_shift(i)) files.images += " " + std::to_string(v);
    files.images += " 1 view " + std::to_string(i) + ".png\n" + (i == 0 ? "" : "1.5 2.5 7 3 4 -1") + "\n";
  }
  files.points = "# points\n7 0.1 0.2 0.3 255 0 0 0.5 1 0 2 0\n8 0.1 0.2 0.3 255 0 0 1.5 1 0 2 0 3 1 4 1\n";
  return files;
}

inline ColmapFiles colmap_bytes(int count) {
  ColmapFiles files;
  put(files.cameras, std::uint64_t{1});
  put(files.cameras, std::uint32_t{1});
  put(files.cameras, std::uint32_t{4});  // OPENCV
  put(files.cameras, std::uint64_t{64});
  put(files.cameras, std::uint64_t{48});
  for (const double v : {60.0, 61.0, 32.0, 24.0, 0.01, 0.0, 0.0, 0.001}) put(files.cameras, v);
  put(files.images, static_cast<std::uint64_t>(count));
  for (int i = count - 1; i >= 0; --i) {
    put(files.images, static_cast<std::uint32_t>(i + 1));
    for (const double v : quaternion_and_shift(i)) put(files.images, v);
    put(files.images, std::uint32_t{1});
    files.images += "view " + std::to_string(i) + ".png";
    files.images += '\0';
    put(files.images, std::uint64_t{1});
    put(files.images, 1.5);
    put(files.images, 2.5);
    put(files.images, std::int64_t{7});
  }
  put(files.points, std::uint64_t{1});
  put(files.points, std::uint64_t{7});
  for (const double v : {0.1, 0.2, 0.3}) put(files.points, v);
  files.points += std::string(3, '\x7f');
  put(files.points, 0.5);
  put(files.points, std::uint64_t{2});
  for (const std::uint32_t v : {1, 0, 2, 0}) put(files.points, v);
  return files;
}

}  // namespace bole::testing_io
