// Folders of NeRF data: transforms.json, or transforms_train.json and its sisters.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/core/views/image_header.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/transforms_file.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

bool is_transforms(const fs::path& path) {
  const auto name = path.filename().string();
  return name.starts_with("transforms") && name.ends_with(".json");
}

struct Part {
  fs::path path;
  std::string split;
};

// The file itself, transforms.json alone, or transforms_train.json, transforms_val.json, transforms_test.json and
// others.
std::vector<Part> parts_of(const fs::path& path, Report& report) {
  const auto split_of = [](const fs::path& file) {
    const auto stem = file.stem().string();
    return stem.size() > 11 && stem[10] == '_' ? stem.substr(11) : std::string();
  };
  if (!is_folder(path)) return {{path, split_of(path)}};
  std::vector<Part> parts;
  for (const auto& file : files_in(path))
    if (is_transforms(file)) parts.push_back({file, split_of(file)});
  const auto whole = std::ranges::find(parts, std::string(), &Part::split);
  if (whole != parts.end() && parts.size() > 1) {
    report.find(Severity::note, "other_transforms",
                "transforms.json is read, and the " + std::to_string(parts.size() - 1) + " files beside it are not");
    return {*whole};
  }
  // The views to learn from come first.
  std::ranges::stable_sort(parts, std::ranges::greater(), [](const Part& part) { return part.split == "train"; });
  return parts;
}

// file_path may lack its ending.
fs::path nerf_image(const fs::path& folder, const std::string& file) {
  auto path = (folder / file).lexically_normal();
  if (has_image_ending(path)) return path;
  for (const char* ending : {".png", ".jpg", ".jpeg", ".PNG", ".JPG"})
    if (is_there(path.string() + ending)) return path.string() + ending;
  return path.string() + ".png";
}

// The size of the first image that is there.
void complete_cameras(const fs::path& folder, TransformsFile& file) {
  std::optional<ImageHeader> header;
  for (auto& view : file.views) {
    const bool complete = view.camera.width > 0 && view.camera.height > 0;
    if (complete) continue;
    const auto path = nerf_image(folder, view.file);
    if (!header && is_there(path)) {
      try {
        header = read_image_header(path);
      } catch (const Error& e) {
        if (e.kind() != ErrorKind::bad_input) throw;
      }
    }
  }
  for (auto& view : file.views) {
    if (view.camera.width > 0 && view.camera.height > 0) continue;
    if (!header)
      throw bad_input("none of its images is there (first: '" + file.views.front().file + "')", "the images");
    complete_camera(view, header->width, header->height);
  }
}

std::size_t camera_index(const RgbdCamera& camera, std::vector<RgbdCamera>& cameras) {
  for (std::size_t i = cameras.size(); i-- > 0;)
    if (cameras[i].color == camera.color && cameras[i].depth_scale == camera.depth_scale) return i;
  cameras.push_back(camera);
  return cameras.size() - 1;
}

void take_part(const Part& part, const fs::path& folder, FoundViews& found, Tally& without_pose) {
  const MappedFile bytes(part.path);
  auto file = parse_transforms(bytes.bytes());
  complete_cameras(folder, file);
  for (auto& view : file.views) {
    RgbdCamera camera;
    camera.color = view.camera;
    camera.depth_scale = file.depth_scale;
    ViewFile out{.name = fs::path(view.file).lexically_normal().string(),
                 .time_s = static_cast<double>(found.files.size()) / views_per_second,
                 .color = nerf_image(folder, view.file)};
    if (!view.depth_file.empty()) out.depth = (folder / view.depth_file).lexically_normal();
    if (!view.mask_file.empty()) out.mask = (folder / view.mask_file).lexically_normal();
    out.camera = camera_index(camera, found.cameras);
    out.split = view.split.empty() ? part.split : view.split;
    out.T_world_camera = view.T_world_camera;
    if (!out.T_world_camera) without_pose.add(out.name);
    found.files.push_back(std::move(out));
  }
}

}  // namespace

bool is_nerf_layout(const fs::path& path) {
  if (!is_folder(path)) return is_transforms(path);
  return std::ranges::any_of(files_in(path), is_transforms);
}

FoundViews find_nerf_views(const fs::path& path, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = is_folder(path) ? path : path.parent_path();
  if (!options.camera.empty())
    throw bad_input("the option camera is set, and transforms.json has the cameras", "one of both",
                    "Leave camera empty");
  const auto parts = parts_of(path, found.report);
  if (parts.empty()) throw bad_input("'" + path.string() + "' holds no transforms.json", "transforms.json");
  Tally without_pose;
  std::string splits;
  for (const auto& part : parts) {
    run.check_cancel();
    const auto before = found.files.size();
    try {
      take_part(part, found.folder, found, without_pose);
    } catch (const Error& e) {
      throw e.at("'" + part.path.string() + "'");
    }
    if (!part.split.empty())
      splits += (splits.empty() ? "" : ", ") + part.split + " " + std::to_string(found.files.size() - before);
  }
  if (!splits.empty()) found.report.facts["splits"] = splits;
  without_pose.tell(found.report, Severity::look, "poses_damaged", "views have a matrix that is no rigid motion",
                    "they have no pose");
  tell_unknown_scale("transforms.json", found);
  return found;
}

}  // namespace bole::io
