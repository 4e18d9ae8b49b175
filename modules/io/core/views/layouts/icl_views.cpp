// Folders of colour and depth with one list of poses: ICL-NUIM, Open3D's reconstruction system, slambook.
#include "base/error.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

fs::path color_folder(const fs::path& folder) { return first_of(folder, {"color", "rgb", "image", "images"}); }

fs::path pose_file(const fs::path& folder) {
  if (auto path =
          first_of(folder, {"trajectory.log", "traj.log", "pose.txt", "poses.txt", "traj.txt", "scene/trajectory.log"});
      !path.empty())
    return path;
  for (const auto& path : files_in(folder))  // livingRoom2.gt.freiburg, 00-trajectory.log
    if (path.extension() == ".freiburg" || path.filename().string().ends_with("trajectory.log")) return path;
  return {};
}

fs::path camera_file_of(const fs::path& folder) {
  return first_of(folder, {"camera.json", "intrinsic.json", "intrinsics.json", "camera_intrinsic.json",
                           "camera_intrinsics.json", "camera_primesense.json"});
}

}  // namespace

bool is_icl_layout(const fs::path& path) {
  if (color_folder(path).empty() || !is_folder(path / "depth") || is_folder(path / "pose")) return false;
  return !pose_file(path).empty() || !camera_file_of(path).empty();
}

FoundViews find_icl_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  const auto images = color_folder(folder);
  if (images.empty()) throw bad_input("'" + folder.string() + "' has no folder of colour images", "color/ and depth/");
  const auto color = numbered_images(images);
  if (color.by_number.empty())
    throw bad_input("'" + images.string() + "' holds no images that are named by a number", "0.png, 1.png, ...");
  run.check_cancel();
  for (const auto& [number, path] : color.by_number)
    found.files.push_back({.name = path.stem().string(), .time_s = number / views_per_second, .color = path});
  tell_numbering(color, images.filename().string() + "/", found.report);
  take_depth_images(color, numbered_images(folder / "depth"), folder / "depth", found);
  found.cameras = {chosen_camera(options.camera, camera_file_of(folder), true, found.report)};
  if (!options.camera.empty() && !options.camera.ends_with(".json") && known_camera(options.camera) == nullptr &&
      !options.depth_scale)
    found.report.find(Severity::look, "depth_scale_assumed",
                      "the scale of the depth is not given: 1000 units per metre are assumed. Set depth_scale (ICL and "
                      "TUM: 5000)");
  if (const auto path = pose_file(folder); !path.empty())
    allow_damaged_poses(found,
                        [&] { take_listed_poses(read_pose_list(path), color, path.filename().string(), found); });
  return found;
}

}  // namespace bole::io
