#include "bench/rgbd/folder_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/error.h"

namespace bole::bench {
namespace {

namespace fs = std::filesystem;

class FolderViews : public ViewSource {
 public:
  struct Files {
    std::string color, depth;
    double time_s;
  };
  std::vector<Files> files;
  RgbdCamera rgbd;
  Trajectory given;
  std::optional<BoardFacts> board_facts;
  bool with_depth = true;
  std::string folder;

  std::size_t size() const override { return files.size(); }
  double time_s(std::size_t i) const override { return files[i].time_s; }
  std::string name(std::size_t i) const override { return fs::path(files[i].color).stem().string(); }
  const RgbdCamera& camera(std::size_t) const override { return rgbd; }
  bool has_depth() const override { return with_depth; }
  const Trajectory& given_poses() const override { return given; }
  std::optional<BoardFacts> board() const override { return board_facts; }
  std::string description() const override { return folder; }
  std::string locator() const override { return folder; }
  void read(std::size_t i, View& view, ViewParts parts) const override {
    view = {};
    if (parts.color) {
      cv::Mat image = cv::imread(files[i].color, cv::IMREAD_COLOR);
      if (image.empty()) throw bad_input("cannot read " + files[i].color);
      cv::cvtColor(image, image, cv::COLOR_BGR2RGB);
      view.color = ColorImage(image.cols, image.rows, 3);
      std::copy(image.datastart, image.dataend, view.color.values.begin());
    }
    if (!parts.depth || !with_depth) return;
    const cv::Mat depth = cv::imread(files[i].depth, cv::IMREAD_UNCHANGED);
    if (depth.empty() || depth.type() != CV_16U) throw bad_input("cannot read " + files[i].depth);
    view.depth = DepthImage(depth.cols, depth.rows);
    for (int y = 0; y < depth.rows; ++y)
      for (int x = 0; x < depth.cols; ++x)
        if (const auto raw = depth.at<std::uint16_t>(y, x); raw > 0 && raw < 65535)
          view.depth.at(x, y) = static_cast<float>(raw / rgbd.depth_scale);
  }
};

CameraModel camera_from(const nlohmann::json& j) {
  CameraModel c;
  c.width = j.at("width");
  c.height = j.at("height");
  c.fx = j.at("fx");
  c.fy = j.at("fy");
  c.cx = j.at("cx");
  c.cy = j.at("cy");
  if (j.contains("distortion"))
    for (std::size_t i = 0; i < 5; ++i) c.distortion[i] = j["distortion"].at(i);
  return c;
}

nlohmann::json json_file(const fs::path& path) { return nlohmann::json::parse(std::ifstream(path)); }

void read_tum(const fs::path& path, Trajectory& out) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream values(line);
    double t = 0, x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 1;
    values >> t >> x >> y >> z >> qx >> qy >> qz >> qw;
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(x, y, z);
    T.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
    out.poses.push_back({t, T});
  }
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> out;
  for (const auto& f : fs::directory_iterator(folder))
    if (f.path().string().ends_with(ending)) out.push_back(f.path());
  std::ranges::sort(out);
  return out;
}

void open_own(FolderViews& v, const fs::path& folder, bool board) {
  const auto j = json_file(folder / "camera.json");
  v.rgbd.color = camera_from(j);
  v.rgbd.depth_scale = j.value("depth_scale", 1000.0);
  if (j.contains("depth")) {
    v.rgbd.depth = camera_from(j["depth"]);
    for (int r = 0; r < 4 && j.contains("depth_to_color"); ++r)
      for (int c = 0; c < 4; ++c)
        v.rgbd.T_color_depth.matrix()(r, c) =
            j["depth_to_color"].at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c));
  }
  int i = 0;
  for (const auto& c : files_in(folder / "color", ".png"))
    v.files.push_back({c.string(), (folder / "depth" / c.filename()).string(), i++ / 30.0});
  for (const auto* poses : {"truth/poses.tum", "poses.tum"})
    if (fs::exists(folder / poses) && v.given.empty()) read_tum(folder / poses, v.given);
  if (!board || !fs::exists(folder / "mat.json")) return;
  const auto m = json_file(folder / "mat.json");
  BoardFacts facts;
  facts.dictionary = m.at("dictionary");
  facts.columns = m.at("squares").at(0);
  facts.rows = m.at("squares").at(1);
  facts.square = m.at("square_mm").get<double>() / 1000;
  facts.marker = m.at("marker_mm").get<double>() / 1000;
  facts.first_square_black = m.value("first_square", "black") == "black";
  v.board_facts = facts;
}

void open_seven_scenes(FolderViews& v, const fs::path& folder) {
  v.rgbd.color = {640, 480, 585, 585, 320, 240, {}};
  int i = 0;
  for (const auto& c : files_in(folder, ".color.jpg")) {
    const std::string stem = c.string().substr(0, c.string().size() - 10);
    const double time = i++ / 30.0;
    v.files.push_back({c.string(), stem + ".depth.png", time});
    std::ifstream in(stem + ".pose.txt");
    Pose T = Pose::Identity();
    for (int r = 0; r < 4; ++r)
      for (int k = 0; k < 4; ++k) in >> T.matrix()(r, k);
    T.linear() = Eigen::Quaterniond(Eigen::Matrix3d(T.linear())).normalized().toRotationMatrix();
    v.given.poses.push_back({time, T});
  }
}

// Frames of TUM with associate.txt, or those of slambook2 (color/1.png, pose.txt, depth in 1/5000 m).
void open_tum(FolderViews& v, const fs::path& folder) {
  v.rgbd.color = {640, 480, 517.3, 516.5, 318.6, 255.3, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}};
  v.rgbd.depth_scale = 5000;
  Trajectory truth;
  read_tum(folder / "groundtruth.txt", truth);
  std::ifstream in(folder / "associate.txt");
  double color_time = 0, depth_time = 0;
  std::string color, depth;
  while (in >> color_time >> color >> depth_time >> depth) {
    v.files.push_back({(folder / color).string(), (folder / depth).string(), color_time});
    v.given.poses.push_back({color_time, truth.at(color_time)});
  }
}

void open_slambook(FolderViews& v, const fs::path& folder) {
  v.rgbd.color = {640, 480, 481.2, -480, 319.5, 239.5, {}};
  v.rgbd.depth_scale = 5000;
  std::ifstream in(folder / "pose.txt");
  for (int i = 1; i <= 5; ++i) {
    v.files.push_back({(folder / "color" / fmt::format("{}.png", i)).string(),
                       (folder / "depth" / fmt::format("{}.png", i)).string(), i / 30.0});
    double x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 1;
    in >> x >> y >> z >> qx >> qy >> qz >> qw;
    Pose T = Pose::Identity();
    T.translation() = Eigen::Vector3d(x, y, z);
    T.linear() = Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix();
    v.given.poses.push_back({i / 30.0, T});
  }
}

}  // namespace

std::shared_ptr<const ViewSource> open_folder(const std::string& name, const FolderOptions& options) {
  const fs::path folder(name);
  auto v = std::make_shared<FolderViews>();
  v->folder = name;
  if (fs::exists(folder / "camera.json"))
    open_own(*v, folder, options.board);
  else if (fs::exists(folder / "associate.txt"))
    open_tum(*v, folder);
  else if (fs::exists(folder / "pose.txt"))
    open_slambook(*v, folder);
  else
    open_seven_scenes(*v, folder);
  v->with_depth = options.depth;
  std::vector<FolderViews::Files> kept;
  for (std::size_t i = 0; i < v->files.size() && static_cast<int>(kept.size()) < options.max_views;
       i += static_cast<std::size_t>(options.step))
    kept.push_back(v->files[i]);
  v->files = std::move(kept);
  return v;
}

}  // namespace bole::bench
