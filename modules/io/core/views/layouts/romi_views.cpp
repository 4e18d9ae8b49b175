// Scans of ROMI's plant imager (plantdb): images/ and metadata/images/*.json. Lengths are millimetres.
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/json_fields.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/pose_matrix.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

constexpr double metres_per_unit = 0.001;

struct RomiView {
  std::optional<RgbdCamera> camera;
  std::optional<Pose> T_world_camera;
  bool approximate = false;
};

Pose pose_of_camera(const Json& camera) {
  const auto rotation = numbers_of(camera["rotmat"], "rotmat", "3 x 3 numbers");
  const auto shift = numbers_of(holds(camera, "tvec") ? camera["tvec"] : Json(), "tvec", "3 numbers");
  if (rotation.size() != 9 || shift.size() != 3) throw bad_input("rotmat and tvec are no pose", "3 x 3 and 3 numbers");
  std::vector<double> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows.insert(rows.end(), rotation.begin() + static_cast<std::ptrdiff_t>(3 * i),
                rotation.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
    rows.push_back(shift[i] * metres_per_unit);
  }
  return pose_from_matrix(rows, "rotmat").inverse();  // the file has T_camera_world
}

// x, y, z in millimetres; pan and tilt in degrees: the camera looks along (-sin pan, cos pan), and down by the tilt.
Pose pose_of_arm(const std::vector<double>& v) {
  const double pan = radians(v[3]), tilt = radians(v[4]);
  const Eigen::Vector3d right(std::cos(pan), std::sin(pan), 0);
  const Eigen::Vector3d ahead(-std::sin(pan) * std::cos(tilt), std::cos(pan) * std::cos(tilt), -std::sin(tilt));
  Pose pose = Pose::Identity();
  pose.linear().col(0) = right;
  pose.linear().col(1) = ahead.cross(right);
  pose.linear().col(2) = ahead;
  pose.translation() = metres_per_unit * Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

RgbdCamera camera_of(const Json& model) {
  const auto name = text_at(model, "model", "OPENCV");
  const auto p =
      numbers_of(holds(model, "params") ? model["params"] : Json(), "params", "fx, fy, cx, cy, k1, k2, p1, p2");
  if (name != "OPENCV" || p.size() < 4 || p.size() > 8)
    throw bad_input("the camera model is " + name + " with " + std::to_string(p.size()) + " parameters", "OPENCV");
  RgbdCamera camera;
  camera.color.width = whole_number_at(model, "width");
  camera.color.height = whole_number_at(model, "height");
  camera.color.fx = p[0];
  camera.color.fy = p[1];
  camera.color.cx = p[2] - 0.5;  // from the corner of the first pixel, as COLMAP has it
  camera.color.cy = p[3] - 0.5;
  std::copy(p.begin() + 4, p.end(), camera.color.distortion.begin());
  camera.color.check();
  return camera;
}

RomiView read_romi_metadata(const fs::path& path) {
  const MappedFile file(path);
  const auto json = parse_object(file.bytes(), "the metadata of an image");
  RomiView view;
  if (holds(json, "camera") && json["camera"].is_object()) {
    const auto& camera = json["camera"];
    if (holds(camera, "camera_model") && camera["camera_model"].is_object())
      view.camera = camera_of(camera["camera_model"]);
    if (holds(camera, "rotmat")) view.T_world_camera = pose_of_camera(camera);
  }
  for (const char* name : {"pose", "approximate_pose"}) {
    if (view.T_world_camera || !holds(json, name)) continue;
    const auto numbers = numbers_of(json[name], name, "x, y, z, pan and tilt");
    if (numbers.size() != 5) throw bad_input("the pose has " + std::to_string(numbers.size()) + " numbers", "5");
    view.T_world_camera = pose_of_arm(numbers);
    view.approximate = true;
  }
  return view;
}

fs::path romi_image(const fs::path& folder, const std::string& stem) {
  for (const char* ending : {".png", ".jpg", ".jpeg"})
    if (is_there(folder / "images" / (stem + ending))) return folder / "images" / (stem + ending);
  return folder / "images" / (stem + ".png");
}

bool is_color_channel(const fs::path& metadata) {
  const auto stem = metadata.stem().string();
  return metadata.extension() == ".json" && (stem.ends_with("_rgb") || stem.find('_') == std::string::npos);
}

}  // namespace

bool is_romi_layout(const fs::path& path) { return is_folder(path / "metadata/images") && is_folder(path / "images"); }

FoundViews find_romi_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  Tally damaged;
  std::size_t approximate = 0;
  const bool camera_given = !options.camera.empty() || is_there(folder / "camera.json");
  if (camera_given) found.cameras = {chosen_camera(options.camera, folder / "camera.json", false, found.report)};
  for (const auto& metadata : files_in(folder / "metadata/images")) {
    if (!is_color_channel(metadata)) continue;
    run.check_cancel();
    const auto stem = metadata.stem().string();
    RomiView view;
    try {
      view = read_romi_metadata(metadata);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      damaged.add(std::string(e.what()));
      continue;
    }
    ViewFile file{.name = stem,
                  .time_s = static_cast<double>(found.files.size()) / views_per_second,
                  .color = romi_image(folder, stem)};
    file.T_world_camera = view.T_world_camera;
    approximate += view.approximate;
    if (!camera_given) {
      // Without a camera of its own in the metadata, that of the others.
      if (view.camera && (found.cameras.empty() || !(found.cameras.back().color == view.camera->color)))
        found.cameras.push_back(*view.camera);
      file.camera = found.cameras.empty() ? 0 : found.cameras.size() - 1;
    }
    found.files.push_back(std::move(file));
  }
  if (found.files.empty())
    throw bad_input("'" + (folder / "metadata/images").string() + "' describes no image", "files 00000_rgb.json");
  if (found.cameras.empty()) found.cameras = {chosen_camera({}, {}, false, found.report)};
  damaged.tell(found.report, Severity::look, "metadata_damaged", "files of metadata cannot be used",
               "their images are left out");
  if (approximate > 0)
    found.report.find(Severity::look, "poses_approximate",
                      std::to_string(approximate) +
                          " poses are those that the arm was sent to, not measured: estimate "
                          "the poses from the images");
  found.report.facts["unit"] = "millimetres in the files";
  return found;
}

}  // namespace bole::io
