// Folders of small views for tests.
#pragma once

#include <cmath>
#include <string>

#include "base/verdict.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/open_views.h"
#include "io/core/views/view_files.h"
#include "modules/io/io_test_tools.h"

namespace bole::testing_io {

using namespace io;

inline constexpr int view_width = 64, view_height = 48;

inline RgbdCamera small_camera() {
  RgbdCamera camera;
  camera.color = {.width = view_width, .height = view_height, .fx = 60, .fy = 61, .cx = 31.5, .cy = 23.5};
  return camera;
}

// Each number gives another picture.
inline ColorImage picture(int number, int width = view_width, int height = view_height) {
  ColorImage image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = static_cast<std::uint8_t>(4 * x % 256);
      image.at(x, y, 1) = static_cast<std::uint8_t>(5 * y % 256);
      image.at(x, y, 2) = static_cast<std::uint8_t>((10 * number + x * y) % 256);
    }
  return image;
}

// A slope from 0.4 m on, with a hole in the corner.
inline DepthImage slope(int number, int width = view_width, int height = view_height) {
  DepthImage image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = 0.4F + 0.01F * static_cast<float>(x) + 0.001F * static_cast<float>(number);
  image.at(0, 0) = 0;
  return image;
}

inline Pose pose_number(int number) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.1 * number, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.1 * number, -0.2, 0.3);
  return pose;
}

inline std::string six_digits(int number) {
  const auto text = std::to_string(number);
  return std::string(6 - text.size(), '0') + text;
}

inline void write_view(const std::filesystem::path& folder, int number, bool with_depth = true) {
  write_color(folder / "color" / (six_digits(number) + ".png"), picture(number));
  if (with_depth) write_depth(folder / "depth" / (six_digits(number) + ".png"), slope(number));
}

// Bole's layout with poses: `count` views.
inline void write_view_folder(const std::filesystem::path& folder, int count) {
  Trajectory poses;
  for (int i = 0; i < count; ++i) {
    write_view(folder, i);
    poses.poses.push_back({i / 30.0, pose_number(i)});
  }
  write_camera_file(folder / "camera.json", small_camera());
  write_tum(folder / "poses.tum", poses);
}

inline std::string finding_text(const Report& report, const std::string& code) {
  for (const auto& f : report.findings)
    if (f.code == code) return f.text;
  return "no finding " + code;
}

struct Opened {
  std::shared_ptr<const ViewSource> views;
  Report report;
};

inline Opened opened(const std::filesystem::path& folder, const ReadViewsOptions& options = {}) {
  Opened out;
  out.views = open_views(folder, options, {}, out.report);
  return out;
}

inline std::string refusal(const std::filesystem::path& folder, const ReadViewsOptions& options = {}) {
  return error_of([&] { open_views(folder, options); });
}

}  // namespace bole::testing_io
