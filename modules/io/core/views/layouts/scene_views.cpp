// Layouts with one file of pose per view: 7-Scenes and ScanNet.
#include <array>

#include "base/error.h"
#include "base/option.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

// fx, fy, cx and cy of a matrix of 3 x 3 or 4 x 4 numbers. The size comes from the images.
CameraModel camera_of_matrix(const fs::path& path) {
  const MappedFile file(path);
  const auto rows = number_lines(file.bytes(), path.string());
  const bool shaped = rows.size() >= 3 && rows[0].size() >= 3 && rows[1].size() >= 3;
  if (!shaped || rows[0][0] == 0 || rows[1][1] == 0)
    throw bad_input("'" + path.string() + "' is no matrix of a camera", "fx 0 cx / 0 fy cy / 0 0 1");
  CameraModel camera;
  camera.fx = rows[0][0];
  camera.fy = rows[1][1];
  camera.cx = rows[0][2];
  camera.cy = rows[1][2];
  return camera;
}

// One file per view; `path_of` gives it. Views whose file is absent or says that they were lost have no pose.
template <class PathOf>
void take_pose_files(FoundViews& found, PathOf&& path_of, const Run& run) {
  Tally absent, lost, damaged;
  for (auto& file : found.files) {
    run.check_cancel();
    const fs::path path = path_of(file);
    if (!is_there(path)) {
      absent.add(file.name);
      continue;
    }
    try {
      file.T_world_camera = read_pose_matrix(path);
      if (!file.T_world_camera) lost.add(file.name);
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      damaged.add(file.name);
    }
  }
  if (absent.count() == found.files.size()) {
    found.report.find(Severity::note, "poses_absent", "there are no files of poses");
    return;
  }
  absent.tell(found.report, Severity::look, "views_without_pose", "views have no file of their pose");
  lost.tell(found.report, Severity::look, "views_lost", "views were lost by the tracker that made the poses");
  damaged.tell(found.report, Severity::look, "poses_damaged", "files of poses are no matrix of 4 x 4 numbers");
}

NumberedFiles scene_images(const fs::path& folder, std::string_view suffix) {
  return numbered_images(folder, "frame-", suffix);
}

void take_color(const NumberedFiles& color, FoundViews& found) {
  for (const auto& [number, path] : color.by_number) {
    const auto name = path.stem().string();
    found.files.push_back({.name = name.substr(0, name.find('.')), .time_s = number / views_per_second, .color = path});
  }
}

// intrinsic_color.txt and intrinsic_depth.txt, extrinsic_color.txt and extrinsic_depth.txt: camera to the axes of both.
RgbdCamera scannet_camera(const fs::path& folder, Report& report) {
  const auto place = is_folder(folder / "intrinsic") ? folder / "intrinsic" : folder;
  const auto color =
      first_of(place, {"intrinsic_color.txt", "intrinsics_color.txt", "intrinsic.txt", "intrinsics.txt"});
  const auto depth = first_of(place, {"intrinsic_depth.txt", "intrinsics_depth.txt"});
  RgbdCamera camera;
  camera.color = camera_of_matrix(color.empty() ? depth : color);
  if (color.empty())
    report.find(Severity::look, "colour_camera_assumed",
                "there is no intrinsic_color.txt: colour is taken to be registered to depth");
  if (color.empty() || depth.empty()) return camera;
  camera.depth = camera_of_matrix(depth);
  const auto extrinsic = [&](const char* name) {
    const auto path = place / name;
    return is_there(path) ? read_pose_matrix(path).value_or(Pose::Identity()) : Pose::Identity();
  };
  camera.T_color_depth = extrinsic("extrinsic_color.txt").inverse() * extrinsic("extrinsic_depth.txt");
  return camera;
}

}  // namespace

bool is_7scenes_layout(const fs::path& path) {
  if (!is_folder(path)) return false;
  for (const auto& file : files_in(path))
    if (const auto name = file.filename().string();
        name.starts_with("frame-") && name.find(".color.") != std::string::npos)
      return true;
  return false;
}

FoundViews find_7scenes_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  auto color = scene_images(folder, ".color");
  color.others = 0;  // depth images lie beside them
  if (color.by_number.empty())
    throw bad_input("'" + folder.string() + "' holds no files frame-000000.color.png", "the layout of 7-Scenes");
  take_color(color, found);
  tell_numbering(color, "the folder", found.report);
  auto depth = scene_images(folder, ".depth");
  if (depth.by_number.empty()) depth = scene_images(folder, ".depth.proj");
  take_depth_images(color, depth, folder, found);
  const auto own = first_of(folder, {"camera-intrinsics.txt", "../camera-intrinsics.txt"});
  RgbdCamera camera;
  if (!options.camera.empty() || is_there(folder / "camera.json")) {
    camera = chosen_camera(options.camera, folder / "camera.json", true, found.report);
  } else if (!own.empty()) {
    camera.color = camera_of_matrix(own);
  } else {
    camera.color = {.width = 640, .height = 480, .fx = 585, .fy = 585, .cx = 320, .cy = 240};
    found.report.find(Severity::look, "camera_assumed",
                      "there is no camera-intrinsics.txt: the depth camera of 7-Scenes is taken (585, 585, 320, 240)");
  }
  found.cameras = {camera};
  take_pose_files(
      found, [&](const ViewFile& file) { return folder / (file.name + ".pose.txt"); }, run);
  return found;
}

bool is_scannet_layout(const fs::path& path) {
  return is_folder(path / "color") && is_folder(path / "pose") &&
         (is_folder(path / "intrinsic") || !first_of(path, {"intrinsic.txt", "intrinsics.txt", "intrinsic_color.txt",
                                                            "intrinsic_depth.txt", "camera.json"})
                                                .empty());
}

FoundViews find_scannet_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  const auto color = numbered_images(folder / "color");
  if (color.by_number.empty())
    throw bad_input("'" + (folder / "color").string() + "' holds no images that are named by a number",
                    "0.jpg, 1.jpg, ...");
  take_color(color, found);
  tell_numbering(color, "color/", found.report);
  take_depth_images(color, numbered_images(folder / "depth"), folder / "depth", found);
  found.cameras = {!options.camera.empty() || is_there(folder / "camera.json")
                       ? chosen_camera(options.camera, folder / "camera.json", true, found.report)
                       : scannet_camera(folder, found.report)};
  take_pose_files(
      found, [&](const ViewFile& file) { return folder / "pose" / (file.name + ".txt"); }, run);
  return found;
}

}  // namespace bole::io
