#include "sim/core/seedling/seedling_files.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/error.h"
#include "camera/camera_json.h"
#include "sim/core/seedling/charuco_mat.h"

namespace bole::sim {
namespace {

using Json = nlohmann::json;

void write_image(const std::filesystem::path& file, const cv::Mat& image) {
  bool written = false;
  try {
    written = cv::imwrite(file.string(), image, {cv::IMWRITE_PNG_COMPRESSION, 3});
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written)
    throw failure("cannot write " + file.string(), "a folder that can be written to, and space on the disk");
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw failure("cannot write " + file.string(), "a folder that can be written to, and space on the disk");
}

}  // namespace

void write_color(const std::filesystem::path& file, const ColorImage& image) {
  cv::Mat bgr(image.height, image.width, CV_8UC3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      bgr.at<cv::Vec3b>(y, x) = {image.at(x, y, 2), image.at(x, y, 1), image.at(x, y, 0)};
  write_image(file, bgr);
}

void write_depth(const std::filesystem::path& file, const DepthImage& depth, double scale) {
  cv::Mat units(depth.height, depth.width, CV_16UC1);
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double value = std::round(scale * static_cast<double>(depth.at(x, y)));
      units.at<std::uint16_t>(y, x) =
          value >= 1 && value <= 65535 ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
    }
  write_image(file, units);
}

void write_csv(const std::filesystem::path& file, const Table& table) {
  std::string text;
  for (const auto& column : table.columns()) text += (text.empty() ? "" : ",") + column.name;
  text += "\n";
  for (std::size_t r = 0; r < table.rows(); ++r) {
    std::string row;
    for (const auto& column : table.columns()) {
      if (&column != &table.columns().front()) row += ",";
      row += table.text(column.name, r, 5);
    }
    text += row + "\n";
  }
  write_text(file, text);
}

void write_json(const std::filesystem::path& file, const Json& json) { write_text(file, json.dump(2) + "\n"); }

void write_poses(const std::filesystem::path& file, const std::vector<Pose>& T_world_camera) {
  std::string text = "# time_s tx ty tz qx qy qz qw\n";
  for (std::size_t i = 0; i < T_world_camera.size(); ++i) {
    const Eigen::Vector3d t = T_world_camera[i].translation();
    const Eigen::Quaterniond q(T_world_camera[i].linear());
    text += fmt::format("{:.6f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n", static_cast<double>(i) / 30, t.x(),
                        t.y(), t.z(), q.x(), q.y(), q.z(), q.w());
  }
  write_text(file, text);
}

void write_camera(const std::filesystem::path& file, const RgbdCamera& camera) {
  write_text(file, camera_json(camera));
}

Json mat_json() {
  return {{"type", "charuco"},
          {"dictionary", "DICT_4X4_50"},
          {"squares", {CharucoMat::columns, CharucoMat::rows}},
          {"square_mm", 1000 * CharucoMat::square},
          {"marker_mm", 1000 * CharucoMat::marker},
          {"first_square", "black"}};
}

}  // namespace bole::sim
