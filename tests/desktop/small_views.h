// Views of a ball on a chequered table from eight sides, with exact depth, and the cloud of both.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <string>

#include "cloud/core/view_source.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/views/view_files.h"

namespace bole::desktop {

inline constexpr int small_views = 8;

inline CameraModel small_camera() {
  return {.width = 160, .height = 120, .fx = 150, .fy = 150, .cx = 79.5, .cy = 59.5};
}

// On a circle of 0.4 m, 0.3 m above the table, towards the middle of the ball.
inline Pose small_pose(int view) {
  const double angle = 2 * M_PI * view / small_views;
  const Eigen::Vector3d eye(0.4 * std::cos(angle), 0.4 * std::sin(angle), 0.3), centre(0, 0, 0.08);
  const Eigen::Vector3d ahead = (centre - eye).normalized(), right = ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
  Pose pose = Pose::Identity();
  pose.linear().col(0) = right;
  pose.linear().col(1) = ahead.cross(right);
  pose.linear().col(2) = ahead;
  pose.translation() = eye;
  return pose;
}

struct SmallHit {
  double along = 0;  // of the direction; 0: nothing
  Eigen::Vector3d color = Eigen::Vector3d(200, 210, 220);
};
inline Eigen::Vector3d table_color(double x, double y) {
  const bool dark = (static_cast<int>(std::floor(x / 0.04)) + static_cast<int>(std::floor(y / 0.04))) % 2 != 0;
  return dark ? Eigen::Vector3d(60, 50, 45) : Eigen::Vector3d(230, 225, 215);
}
inline SmallHit small_hit(const Eigen::Vector3d& eye, const Eigen::Vector3d& d) {
  const Eigen::Vector3d centre(0, 0, 0.08), oc = eye - centre;
  const double a = d.squaredNorm(), b = oc.dot(d), c = oc.squaredNorm() - 0.08 * 0.08, disc = b * b - a * c;
  if (disc > 0 && -b - std::sqrt(disc) > 0) {
    const double t = (-b - std::sqrt(disc)) / a;
    const Eigen::Vector3d n = (oc + t * d) / 0.08;
    return {t, Eigen::Vector3d(50, 160, 70) * (0.5 + 0.5 * std::max(0.0, n.z()))};
  }
  const double t = -eye.z() / d.z();
  const Eigen::Vector3d p = eye + t * d;
  if (t > 0 && std::abs(p.x()) < 0.25 && std::abs(p.y()) < 0.25) return {t, table_color(p.x(), p.y())};
  return {};
}

inline void write_views(const std::filesystem::path& folder, bool with_poses = true) {
  std::filesystem::create_directories(folder / "color");
  std::filesystem::create_directories(folder / "depth");
  const auto camera = small_camera();
  std::ofstream(folder / "camera.json")
      << R"({"width": 160, "height": 120, "fx": 150, "fy": 150, "cx": 79.5, "cy": 59.5,
    "distortion": [0, 0, 0, 0, 0], "depth_scale": 10000})";
  std::ofstream poses;
  if (with_poses) poses.open(folder / "poses.tum");
  poses << std::setprecision(12);
  for (int i = 0; i < small_views; ++i) {
    const Pose T = small_pose(i);
    ColorImage color(camera.width, camera.height, 3);
    DepthImage depth(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x < camera.width; ++x) {
        const auto hit = small_hit(T.translation(), T.linear() * camera.direction({x, y}));
        for (int k = 0; k < 3; ++k) color.at(x, y, k) = static_cast<std::uint8_t>(hit.color[k]);
        depth.at(x, y) = static_cast<float>(hit.along);
      }
    const std::string name = "00000" + std::to_string(i) + ".png";
    io::write_color(folder / "color" / name, color);
    io::write_depth(folder / "depth" / name, depth, 10000);
    const Eigen::Quaterniond q(T.linear());
    poses << i / 30.0 << ' ' << T.translation().transpose() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z() << ' '
          << q.w() << '\n';
  }
}

// Points two millimetres apart, in colours.
inline void write_views_cloud(const std::filesystem::path& file) {
  PointCloud::Positions positions;
  std::vector<std::uint16_t> red, green, blue;
  const auto add = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& c) {
    positions.push_back(p.cast<float>());
    red.push_back(static_cast<std::uint16_t>(257 * c.x()));
    green.push_back(static_cast<std::uint16_t>(257 * c.y()));
    blue.push_back(static_cast<std::uint16_t>(257 * c.z()));
  };
  for (double x = -0.2; x < 0.2; x += 0.002)
    for (double y = -0.2; y < 0.2; y += 0.002) add({x, y, 0}, table_color(x, y));
  for (double v = 0.02; v < M_PI; v += 0.025)
    for (double u = 0; u < 2 * M_PI; u += 0.025 / std::sin(v))
      add({0.08 * std::sin(v) * std::cos(u), 0.08 * std::sin(v) * std::sin(u), 0.08 + 0.08 * std::cos(v)},
          Eigen::Vector3d(50, 160, 70) * (0.5 + 0.5 * std::max(0.0, std::cos(v))));
  PointCloud cloud(positions);
  cloud.set_column(arrays::red, red);
  cloud.set_column(arrays::green, green);
  cloud.set_column(arrays::blue, blue);
  io::write_ply(file, cloud, {});
}

inline void write_views_pipeline(const std::filesystem::path& file) {
  std::ofstream(file) << R"({"title": "Ball", "stages": [
    {"id": "frames", "type": "io.read_views", "options": {"folder": "ball"}},
    {"id": "points", "type": "io.read_cloud", "options": {"file": "ball.ply"}}]})";
}

}  // namespace bole::desktop
