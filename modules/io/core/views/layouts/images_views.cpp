// A folder of pictures and nothing else, such as those of a calibration board.
#include "base/error.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

// Files of another kind make it something else: scans may come with a picture.
bool is_images_layout(const std::filesystem::path& path) {
  bool images = false;
  for (const auto& file : files_in(path)) {
    const auto ending = lower_case(file.extension().string());
    const bool notes = ending == ".json" || ending == ".txt" || ending == ".csv" || ending == ".md";
    if (!is_folder(file) && !has_image_ending(file) && !notes) return false;
    images = images || has_image_ending(file);
  }
  return images;
}

FoundViews find_images_views(const std::filesystem::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  for (const auto& path : files_in(folder)) {
    if (!has_image_ending(path)) continue;
    found.files.push_back({.name = path.stem().string(),
                           .time_s = static_cast<double>(found.files.size()) / views_per_second,
                           .color = path});
  }
  if (found.files.empty()) throw bad_input("'" + folder.string() + "' holds no images", ".png, .jpg or .pgm");
  run.check_cancel();
  found.cameras = {chosen_camera(options.camera, folder / "camera.json", false, found.report)};
  if (is_there(folder / "mat.json")) found.board = read_board_file(folder / "mat.json");
  return found;
}

}  // namespace bole::io
