// Bole's own layout, which the simulator writes.
#include <array>

#include "base/error.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/numbered_files.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

constexpr double views_per_second = 30;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

void tell_numbering(const NumberedFiles& color, Report& report) {
  const auto count = [](std::size_t n) { return std::to_string(n); };
  if (color.missing > 0) {
    report.counts["views_missing"] = static_cast<std::int64_t>(color.missing);
    report.find(Severity::look, "views_missing",
                count(color.missing) + " images are missing in the sequence of color/ (first: " +
                    count(color.first_missing) + "); the times of the others follow from their numbers");
  }
  if (color.others > 0)
    report.find(Severity::note, "other_images",
                count(color.others) + " images of color/ have no number as their name and are left out");
  if (color.repeated > 0)
    report.find(Severity::note, "repeated_images", count(color.repeated) + " images of color/ repeat a number");
}

void take_depth_files(const fs::path& folder, const NumberedFiles& color, FoundViews& found) {
  const auto depth = numbered_images(folder / "depth");
  if (depth.by_number.empty()) {
    found.report.find(Severity::look, "depth_absent",
                      is_folder(folder / "depth") ? "the folder depth/ holds no images: the views have no depth"
                                                  : "there is no folder depth/: the views have no depth");
    return;
  }
  auto file = found.files.begin();
  for (const auto& [number, path] : color.by_number) {
    const auto it = depth.by_number.find(number);
    // A file that is not there is counted with the others when the images are looked at.
    file++->depth = it != depth.by_number.end() ? it->second : folder / "depth" / (path.stem().string() + ".png");
  }
  Tally alone;
  for (const auto& [number, path] : depth.by_number)
    if (!color.by_number.contains(number)) alone.add(path.stem().string());
  alone.tell(found.report, Severity::note, "depth_without_colour", "depth images have no colour image");
}

void take_pose_file(const fs::path& path, FoundViews& found) {
  if (!is_file(path)) return;
  Trajectory given;
  try {
    given = read_tum(path);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    found.report.find(Severity::look, "poses_damaged", std::string("the given poses are not used: ") + e.what());
    return;
  }
  take_poses(given, path.filename().string(), found);
}

}  // namespace

bool is_bole_layout(const fs::path& path) { return is_folder(path / "color") && is_file(path / "camera.json"); }

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
  tell_numbering(color, found.report);
  take_depth_files(folder, color, found);
  const bool with_depth = !found.files.front().depth.empty();
  found.cameras = {chosen_camera(options.camera, folder / "camera.json", with_depth, found.report)};
  take_pose_file(folder / "poses.tum", found);
  if (is_file(folder / "mat.json")) found.board = read_board_file(folder / "mat.json");
  return found;
}

}  // namespace bole::io
