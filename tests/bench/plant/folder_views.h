// Views of a folder with transforms.json (NeRF synthetic) or with color/, depth/, camera.json and poses.tum, read with
// OpenCV alone: benches of the field do not depend on the readers.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "base/error.h"
#include "cloud/core/view_source.h"

namespace bole::bench {

class FolderViews : public ViewSource {
 public:
  // Every `stride`-th view.
  explicit FolderViews(const std::filesystem::path& folder, int stride = 1) : folder_(folder) {
    if (std::filesystem::exists(folder / "transforms_train.json"))
      read_nerf(stride);
    else
      read_rgbd(stride);
  }
  std::size_t size() const override { return color_.size(); }
  double time_s(std::size_t i) const override { return times_[i]; }
  std::string name(std::size_t i) const override { return color_[i].stem().string(); }
  const RgbdCamera& camera(std::size_t) const override { return camera_; }
  bool has_depth() const override { return !depth_.empty(); }
  const Trajectory& given_poses() const override { return poses_; }
  std::string split(std::size_t i) const override { return split_.empty() ? "" : split_[i]; }
  std::string description() const override { return folder_.string(); }
  std::string locator() const override { return "{}"; }

  void read(std::size_t i, View& view, ViewParts parts) const override {
    view = {};
    if (parts.color) {
      const cv::Mat image = cv::imread(color_[i].string(), cv::IMREAD_UNCHANGED);
      if (image.empty()) throw bad_input("cannot read " + color_[i].string());
      view.color = ColorImage(image.cols, image.rows, 3);
      for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x) {
          const auto* p = image.ptr<std::uint8_t>(y) + x * image.channels();
          for (int c = 0; c < 3; ++c) {
            const int alpha = image.channels() == 4 ? p[3] : 255;
            view.color.at(x, y, c) = static_cast<std::uint8_t>((p[2 - c] * alpha + 255 * (255 - alpha) + 127) / 255);
          }
        }
    }
    if (parts.depth && has_depth()) {
      const cv::Mat image = cv::imread(depth_[i].string(), cv::IMREAD_UNCHANGED);
      if (image.empty() || image.type() != CV_16UC1) throw bad_input("cannot read " + depth_[i].string());
      view.depth = DepthImage(image.cols, image.rows);
      for (int y = 0; y < image.rows; ++y)
        for (int x = 0; x < image.cols; ++x)
          view.depth.at(x, y) = static_cast<float>(image.at<std::uint16_t>(y, x) / camera_.depth_scale);
    }
  }

 private:
  void add_nerf(const std::string& split, int stride) {
    std::ifstream file(folder_ / ("transforms_" + split + ".json"));
    const auto json = nlohmann::json::parse(file);
    int k = 0;
    for (const auto& frame : json.at("frames")) {
      if (k++ % stride != 0) continue;
      color_.push_back(folder_ / (frame.at("file_path").get<std::string>() + ".png"));
      split_.push_back(split);
      Pose T = Pose::Identity();
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) T.matrix()(r, c) = frame.at("transform_matrix")[r][c].get<double>();
      T.linear().col(1) *= -1;  // OpenGL: y up, looking along -z
      T.linear().col(2) *= -1;
      times_.push_back(static_cast<double>(times_.size()));
      poses_.poses.push_back({times_.back(), T});
    }
    const cv::Mat first = cv::imread(color_.front().string(), cv::IMREAD_UNCHANGED);
    auto& c = camera_.color;
    c.width = first.cols, c.height = first.rows;
    c.fx = c.fy = 0.5 * first.cols / std::tan(0.5 * json.at("camera_angle_x").get<double>());
    c.cx = (c.width - 1) / 2.0, c.cy = (c.height - 1) / 2.0;
  }
  void read_nerf(int stride) {
    add_nerf("train", stride);
    add_nerf("test", 1);
  }
  static CameraModel model(const nlohmann::json& j) {
    CameraModel c;
    c.width = j.at("width"), c.height = j.at("height"), c.fx = j.at("fx"), c.fy = j.at("fy"), c.cx = j.at("cx"),
    c.cy = j.at("cy");
    if (j.contains("distortion"))
      for (std::size_t k = 0; k < std::min<std::size_t>(5, j["distortion"].size()); ++k)
        c.distortion[k] = j["distortion"][k];
    return c;
  }
  void read_rgbd(int stride) {
    std::ifstream file(folder_ / "camera.json");
    const auto json = nlohmann::json::parse(file);
    camera_.color = model(json);
    camera_.depth_scale = json.at("depth_scale");
    if (json.contains("depth") && json["depth"].is_object()) camera_.depth = model(json["depth"]);
    if (json.contains("depth_to_color"))
      for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) camera_.T_color_depth.matrix()(r, c) = json["depth_to_color"][r][c].get<double>();
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "color")) files.push_back(entry.path());
    std::ranges::sort(files);
    for (std::size_t i = 0; i < files.size(); i += static_cast<std::size_t>(stride)) {
      color_.push_back(files[i]);
      depth_.push_back(folder_ / "depth" / (files[i].stem().string() + ".png"));
      times_.push_back(static_cast<double>(i) / 30);
    }
    auto tum = folder_ / "poses.tum";
    if (!std::filesystem::exists(tum)) tum = folder_ / "truth" / "poses.tum";
    std::ifstream poses(tum);
    for (std::string line; std::getline(poses, line);) {
      std::istringstream in(line);
      double t, x, y, z, qx, qy, qz, qw;
      if (!(in >> t >> x >> y >> z >> qx >> qy >> qz >> qw)) continue;
      for (const double time : times_)
        if (std::abs(time - t) < 1e-3) {
          Pose T = Pose::Identity();
          T.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
          T.translation() << x, y, z;
          poses_.poses.push_back({time, T});
        }
    }
  }

  std::filesystem::path folder_;
  std::vector<std::filesystem::path> color_, depth_;
  std::vector<std::string> split_;
  std::vector<double> times_;
  RgbdCamera camera_;
  Trajectory poses_;
};

}  // namespace bole::bench
