// Folders of COLMAP: a model (cameras, images, points3D) and the images it was made of.
#include <algorithm>
#include <array>

#include "base/error.h"
#include "io/core/views/colmap_model.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

struct ModelPlace {
  fs::path folder;
  bool binary = false;
};

std::optional<ModelPlace> model_in(const fs::path& folder) {
  for (const bool binary : {true, false}) {
    const std::string ending = binary ? ".bin" : ".txt";
    if (is_there(folder / ("cameras" + ending)) && is_there(folder / ("images" + ending)))
      return ModelPlace{folder, binary};
  }
  return std::nullopt;
}

std::optional<ModelPlace> find_model(const fs::path& path) {
  if (!is_folder(path)) {
    constexpr std::array names{"cameras.bin", "cameras.txt", "images.bin", "images.txt"};
    const bool named = std::ranges::find(names, path.filename().string()) != names.end();
    return named ? model_in(path.parent_path()) : std::nullopt;
  }
  for (const char* place : {"", "sparse/0", "sparse", "dense/sparse", "dense/0/sparse", "model", "colmap/sparse/0"})
    if (auto model = model_in(path / place)) return model;
  return std::nullopt;
}

// The folder that holds the first image, looked for beside and above the model.
fs::path image_folder(const ModelPlace& model, const std::vector<ColmapImage>& images) {
  fs::path above = model.folder;
  for (int level = 0; level < 4; ++level) {
    for (const char* place : {"images", "", "rgb", "color"}) {
      auto folder = above / place;
      if (std::ranges::any_of(images, [&](const ColmapImage& image) { return is_there(folder / image.name); }))
        return folder;
    }
    above /= "..";
  }
  throw bad_input("the images of '" + model.folder.string() + "' are not found (first: '" + images.front().name + "')",
                  "a folder images/ in the folder of the model or above it");
}

template <class Parse>
auto parsed(const ModelPlace& model, const char* name, Parse&& parse) {
  const auto path = model.folder / (std::string(name) + (model.binary ? ".bin" : ".txt"));
  const MappedFile file(path);
  try {
    return parse(file.bytes(), model.binary);
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

void tell_points(const ModelPlace& model, FoundViews& found) {
  if (!is_there(model.folder / (model.binary ? "points3D.bin" : "points3D.txt"))) return;
  try {
    const auto points = parsed(model, "points3D", parse_colmap_points);
    found.report.counts["model_points"] = static_cast<std::int64_t>(points.count);
    found.report.metrics["model_reprojection_error"] = {points.mean_error_px, Unit::pixel};
    found.report.metrics["model_track_length"] = {points.mean_track, Unit::none};
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    found.report.find(Severity::look, "points_damaged", e.what());
  }
}

}  // namespace

bool is_colmap_layout(const fs::path& path) { return find_model(path).has_value(); }

FoundViews find_colmap_views(const fs::path& path, const ReadViewsOptions& options, const Run& run) {
  const auto model = find_model(path);
  if (!model) throw bad_input("'" + path.string() + "' holds no model of COLMAP", "cameras and images, .bin or .txt");
  if (!options.camera.empty())
    throw bad_input("the option camera is set, and the model has the cameras", "one of both", "Leave camera empty");
  FoundViews found;
  found.folder = is_folder(path) ? path : path.parent_path();
  const auto cameras = parsed(*model, "cameras", parse_colmap_cameras);
  const auto images = parsed(*model, "images", parse_colmap_images);
  run.check_cancel();
  const auto folder = image_folder(*model, images);
  std::map<std::uint32_t, std::size_t> index;
  for (const auto& [id, camera] : cameras) {
    index[id] = found.cameras.size();
    found.cameras.push_back({.color = camera, .depth = {}});
  }
  for (const auto& image : images) {
    const auto camera = index.find(image.camera);
    if (camera == index.end())
      throw bad_input("image '" + image.name + "' has camera " + std::to_string(image.camera),
                      "one of the cameras file");
    found.files.push_back({.name = image.name,
                           .time_s = static_cast<double>(found.files.size()) / views_per_second,
                           .color = (folder / image.name).lexically_normal(),
                           .camera = camera->second,
                           .T_world_camera = image.T_world_camera});
  }
  tell_points(*model, found);
  tell_unknown_scale("the model of COLMAP", found);
  return found;
}

}  // namespace bole::io
