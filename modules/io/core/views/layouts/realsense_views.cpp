// What RealSense programs export: rs-convert writes NAME_Color_TIME.png and NAME_Depth_TIME.png, the Viewer's snapshots
// are NAME_Color.png and NAME_Depth.png; metadata lie beside them (NAME_Color_metadata_TIME.txt,
// NAME_Color_metadata.csv).
#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "io/core/bytes/line_reader.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/camera_choice.h"
#include "io/core/views/layout_tools.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

namespace {

struct Export {
  fs::path path;
  std::string prefix;         // before the name of the stream
  std::optional<double> key;  // the number behind it: milliseconds, or the number of the image
};

// Images of a stream ("color", "depth") in a folder. In the order of their keys, then of their names.
std::vector<Export> exports_of(const fs::path& folder, std::string_view stream) {
  std::vector<Export> found;
  for (const auto& path : files_in(folder)) {
    if (!has_image_ending(path)) continue;
    const auto stem = path.stem().string();
    const auto lower = lower_case(stem);
    const auto word = "_" + std::string(stream);
    const auto at = lower.rfind(word);
    if (at == std::string::npos) continue;
    Export entry{path, stem.substr(0, at), {}};
    auto rest = stem.substr(at + word.size());
    if (!rest.empty()) {
      double key = 0;
      if (rest.front() != '_' || !parse_number(std::string_view(rest).substr(1), key)) continue;
      entry.key = key;
    }
    found.push_back(std::move(entry));
  }
  std::ranges::stable_sort(found, {}, [](const Export& e) { return e.key.value_or(0); });
  return found;
}

std::map<std::string, std::string, std::less<>> read_realsense_metadata(const Export& image, const char* stream) {
  std::map<std::string, std::string, std::less<>> values;
  const auto stem = image.path.stem().string();
  const auto number = stem.substr(image.prefix.size() + 1 + std::string_view(stream).size());
  const auto base = image.path.parent_path() / (image.prefix + "_" + stream + "_metadata");
  for (const auto& name :
       {base.string() + number, base.string(), (image.path.parent_path() / stem).string() + "_metadata"})
    for (const char* ending : {".txt", ".csv"}) {
      if (!values.empty() || !is_there(name + ending)) continue;
      const MappedFile file(name + ending);
      LineReader lines(file.bytes());
      std::string_view line;
      while (lines.next(line) && values.size() < 500) {
        const auto comma = line.find_first_of(",:;");
        if (comma == std::string_view::npos) continue;
        auto key = lower_case(std::string(trimmed(line.substr(0, comma))));
        std::ranges::replace(key, '_', ' ');
        values.emplace(std::move(key), std::string(trimmed(line.substr(comma + 1))));
      }
    }
  return values;
}

// Intrinsics in the metadata of a stream; nothing where there are none.
std::optional<CameraModel> camera_in_metadata(const std::vector<Export>& images, const char* stream) {
  if (images.empty()) return std::nullopt;
  const auto values = read_realsense_metadata(images.front(), stream);
  const auto number = [&](std::initializer_list<const char*> names) {
    double value = 0;
    for (const char* name : names)
      if (const auto it = values.find(name); it != values.end() && parse_number(std::string_view(it->second), value))
        return value;
    return 0.0;
  };
  CameraModel camera;
  camera.fx = number({"fx"});
  camera.fy = number({"fy"});
  camera.cx = number({"ppx", "cx"});
  camera.cy = number({"ppy", "cy"});
  if (camera.fx == 0 || camera.fy == 0) return std::nullopt;
  const double width = number({"resolution x", "width"}), height = number({"resolution y", "height"});
  if (width >= 1 && height >= 1 && width < 1e5 && height < 1e5) {
    camera.width = static_cast<int>(width);
    camera.height = static_cast<int>(height);
  }
  return camera;
}

RgbdCamera camera_of_exports(const fs::path& folder, const std::vector<Export>& color, const std::vector<Export>& depth,
                             const ReadViewsOptions& options, Report& report) {
  const auto own = folder / "camera.json";
  const auto of_color = camera_in_metadata(color, "Color"), of_depth = camera_in_metadata(depth, "Depth");
  if (!options.camera.empty() || is_there(own) || !of_color)
    return chosen_camera(options.camera, own, !depth.empty(), report);
  RgbdCamera camera;
  camera.color = *of_color;
  const bool registered =
      !of_depth || (std::abs(of_depth->fx - of_color->fx) < 0.01 && of_depth->width == of_color->width);
  if (!registered) {
    camera.depth = of_depth;
    report.find(Severity::look, "depth_to_color_missing",
                "depth is not registered to colour, and the metadata do not say where the two cameras are: they are "
                "taken to be at one place. Export aligned depth, or write camera.json");
  }
  return camera;
}

// The depth image of each view: with the same prefix and key, else the nearest within 20 ms.
void pair_depth(const std::vector<Export>& color, const std::vector<Export>& depth, bool times, FoundViews& found) {
  constexpr double max_apart_ms = 20;
  std::vector<bool> taken(depth.size());
  Tally without;
  for (std::size_t c = 0; c < color.size(); ++c) {
    std::size_t best = depth.size();
    double apart = times ? max_apart_ms : 0.5;
    for (std::size_t d = 0; d < depth.size(); ++d) {
      if (taken[d] || depth[d].prefix != color[c].prefix || depth[d].key.has_value() != color[c].key.has_value())
        continue;
      const double difference = std::abs(depth[d].key.value_or(0) - color[c].key.value_or(0));
      if (difference < apart) best = d, apart = difference;
    }
    if (best == depth.size()) {
      without.add(found.files[c].name);
      continue;
    }
    taken[best] = true;
    found.files[c].depth = depth[best].path;
  }
  without.tell(found.report, Severity::look, "views_without_depth", "views have no depth image");
}

std::vector<Export> exports_below(const fs::path& folder, std::string_view stream) {
  auto found = exports_of(folder, stream);
  if (found.empty()) found = exports_of(folder / stream, stream);
  return found;
}

}  // namespace

bool is_realsense_layout(const fs::path& path) { return is_folder(path) && !exports_below(path, "color").empty(); }

FoundViews find_realsense_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  const auto color = exports_below(folder, "color"), depth = exports_below(folder, "depth");
  if (color.empty())
    throw bad_input("'" + folder.string() + "' holds no images NAME_Color_TIME.png", "exported images");
  run.check_cancel();
  constexpr double min_time_ms = 1e6;  // smaller keys are numbers of images
  const bool keyed = std::ranges::all_of(color, [](const Export& e) { return e.key.has_value(); });
  const bool times = keyed && color.back().key > min_time_ms;
  for (const auto& image : color) {
    const auto rank = static_cast<double>(found.files.size());
    const double time_s = times ? *image.key / 1000 : (keyed ? *image.key : rank) / views_per_second;
    if (!found.files.empty() && !(time_s > found.files.back().time_s))
      throw bad_input("'" + image.path.string() + "' has the time of another image", "one recording in a folder");
    found.files.push_back({.name = image.path.stem().string(), .time_s = time_s, .color = image.path});
  }
  found.cameras = {camera_of_exports(folder, color, depth, options, found.report)};
  if (depth.empty())
    found.report.find(Severity::look, "depth_absent",
                      "there are no images NAME_Depth_TIME.png: the views have no depth");
  else
    pair_depth(color, depth, times, found);
  if (const auto poses = folder / "poses.tum"; is_there(poses))
    allow_damaged_poses(found, [&] { take_poses(read_tum(poses), "poses.tum", found); });
  return found;
}

}  // namespace bole::io
