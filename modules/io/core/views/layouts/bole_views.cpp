// Bole's own layout, which the simulator writes.
#include "base/error.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

// A folder with the poses of another layout belongs to that one, which knows camera.json too.
bool is_bole_layout(const fs::path& path) {
  if (!is_folder(path / "color") || !is_there(path / "camera.json")) return false;
  return is_there(path / "poses.tum") || first_of(path, {"trajectory.log", "pose.txt", "pose"}).empty();
}

FoundViews find_bole_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  const auto color = numbered_images(folder / "color");
  if (color.by_number.empty())
    throw bad_input("'" + (folder / "color").string() + "' " +
                        (!is_folder(folder / "color") ? "does not exist"
                         : color.others > 0           ? "holds images, and none has a number as its name"
                                                      : "holds no images"),
                    "images 000000.png, 000001.png, ... (.png or .jpg)");
  run.check_cancel();
  for (const auto& [number, path] : color.by_number)
    found.files.push_back({.name = path.stem().string(), .time_s = number / views_per_second, .color = path});
  tell_numbering(color, "color/", found.report);
  take_depth_images(color, numbered_images(folder / "depth"), folder / "depth", found);
  const bool with_depth = !found.files.front().depth.empty();
  found.cameras = {chosen_camera(options.camera, folder / "camera.json", with_depth, found.report)};
  if (const auto poses = folder / "poses.tum"; is_there(poses))
    allow_damaged_poses(found, [&] { take_poses(read_tum(poses), "poses.tum", found); });
  if (is_there(folder / "mat.json")) found.board = read_board_file(folder / "mat.json");
  return found;
}

}  // namespace bole::io
