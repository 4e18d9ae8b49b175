#include "io/core/views/open_views.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "io/core/views/camera_file.h"
#include "io/core/views/file_views.h"
#include "io/core/views/numbered_files.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {

namespace fs = std::filesystem;

const OptionTable& option_table(const ReadViewsOptions*) {
  using S = ReadViewsOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::optional<ViewLayout>>{"layout", &S::layout, "auto", Tier::advanced,
                                           "Layout of the folder. auto decides by the names of its files."},
      Option<S, std::string>{"camera",
                             &S::camera,
                             TextKind::input_path_or_name,
                             {},
                             Tier::advanced,
                             "Camera of the views: a file camera.json, fx,fy,cx,cy in pixels, or a name such as "
                             "tum_freiburg1, icl_nuim or primesense; unknown for pictures of a calibration board. "
                             "Empty takes the one of the folder."},
      Option<S, int>{"every",
                     &S::every,
                     Unit::none,
                     {1, 1000},
                     Tier::basic,
                     "Take one view of this many. A larger value is faster and has less overlap."},
      Option<S, std::optional<int>>{"max_views",
                                    &S::max_views,
                                    Unit::none,
                                    {1, 100000},
                                    "all",
                                    Tier::basic,
                                    "Largest number of views, spread evenly over the sequence."},
      Option<S, std::optional<double>>{"depth_scale",
                                       &S::depth_scale,
                                       Unit::none,
                                       {1, 1e6},
                                       "auto",
                                       Tier::advanced,
                                       "Units of the depth images per metre: 1000 for millimetres, 5000 for TUM and "
                                       "ICL. auto takes what the folder says."},
      Option<S, std::optional<double>>{"max_depth",
                                       &S::max_depth,
                                       Unit::metre,
                                       {0.05, 1000},
                                       "none",
                                       Tier::advanced,
                                       "Depth beyond this is ignored."},
  });
  return table;
}

namespace {

std::string locator_of(const fs::path& path, const ReadViewsOptions& options) {
  nlohmann::json json{{"views", fs::absolute(path).lexically_normal().string()}};
  for (const auto& spec : option_table(&options).specs) {
    const auto value = spec.get(&options);
    if (value != spec.default_value) std::visit([&](const auto& v) { json["options"][spec.name] = v; }, value);
  }
  return json.dump();
}

// What stands in a folder that no layout takes: for the message.
std::string sight_of(const fs::path& folder) {
  const auto files = files_in(folder);
  if (files.empty()) return "is empty";
  std::error_code ignored;
  if (fs::is_directory(folder / "color", ignored)) return "has color/ and no camera.json";
  const auto images = std::ranges::count_if(files, has_image_ending);
  if (images > 0) return "holds " + std::to_string(images) + " images and no file of their camera";
  for (const auto& file : files)
    if (fs::is_directory(file, ignored) && find_layout(file) != nullptr)
      return "holds no views; its folder '" + file.filename().string() + "' does";
  return "holds no views (first entry: '" + files.front().filename().string() + "')";
}

const LayoutRow& row_of(ViewLayout layout) { return view_layouts()[static_cast<std::size_t>(layout)]; }

// Folders of colour and depth whose camera comes by the option.
const LayoutRow* layout_with_camera(const fs::path& path, const ReadViewsOptions& options) {
  std::error_code ignored;
  return !options.camera.empty() && fs::is_directory(path / "color", ignored) ? &row_of(ViewLayout::bole) : nullptr;
}

const LayoutRow& layout_of(const fs::path& path, const ReadViewsOptions& options) {
  if (path.empty()) throw bad_input("no folder of views is named", layout_list(), "Set the option folder");
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw bad_input("there is no file or folder '" + path.string() + "'", layout_list());
  if (options.layout) return row_of(*options.layout);
  if (const auto* row = find_layout(path)) return *row;
  if (const auto* row = layout_with_camera(path, options)) return *row;
  if (fs::is_directory(path, ignored))
    throw bad_input("the folder '" + path.string() + "' " + sight_of(path), layout_list(),
                    "A camera is given by camera.json in the folder (pipelines/calibrate_camera.json measures it)");
  throw bad_input("'" + path.string() + "' is no file of views", layout_list());
}

// An image stands for the folder of its sequence, and the file of the camera likewise.
fs::path place_of(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return path;
  if (path.filename() == "camera.json") return path.parent_path();
  if (has_image_ending(path) && find_layout(path) == nullptr) return path.parent_path().parent_path();
  return path;
}

// Depth images in the middle of their range: the first, the middle and the last.
void look_at_depth(const FileViews& views, Report& report) {
  std::vector<float> depths;
  View view;
  const auto last = views.size() - 1;
  std::size_t looked = 0;
  for (const auto index : {std::size_t{0}, last / 2, last}) {
    try {
      views.read(index, view, {.color = false, .depth = true, .mask = false});
    } catch (const Error& e) {
      if (e.kind() != ErrorKind::bad_input) throw;
      report.find(Severity::look, "input_damaged", e.what());
      continue;
    }
    looked += !view.depth.empty();
    for (std::size_t i = 0; i < view.depth.values.size(); i += 7)
      if (view.depth.values[i] > 0) depths.push_back(view.depth.values[i]);
  }
  if (looked == 0) return;
  if (depths.empty()) {
    report.find(Severity::look, "depth_empty", "the depth images that were looked at hold no depth");
    return;
  }
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::ranges::nth_element(depths, middle);
  report.metrics["median_depth"] = {*middle, Unit::metre};
  constexpr float min_m = 0.05F, max_m = 20;  // of cameras that are held or driven about plants
  if (*middle < min_m || *middle > max_m)
    report.find(Severity::look, "depth_scale_suspect",
                "half of the depth lies beyond " + number_text(*middle) + " m with " +
                    number_text(views.camera(0).depth_scale) +
                    " units per metre. If that is wrong, set depth_scale (1000: millimetres)");
}

// The byte order of PGM files is that in which the first depth image is smoother: writers differ from the standard.
void find_byte_order(FoundViews& found) {
  for (const auto& file : found.files) {
    if (file.depth.extension() != ".pgm" && file.depth.extension() != ".PGM") continue;
    const MappedFile image(file.depth);
    found.little_endian_pgm = seems_little_endian_pgm(image.bytes());
    found.report.facts["pgm_byte_order"] = found.little_endian_pgm ? "little" : "big";
    return;
  }
}

// The bias of the depth stands in the file that the camera comes from.
std::vector<double> depth_bias_of(const FoundViews& found, const ReadViewsOptions& options) {
  std::error_code ignored;
  const auto file = options.camera.empty() ? found.folder / "camera.json" : fs::path(options.camera);
  if (file.extension() != ".json" || !fs::exists(file, ignored)) return {};
  return read_depth_bias(file);
}

void check_times(const FoundViews& found) {
  for (std::size_t i = 1; i < found.files.size(); ++i)
    if (!(found.files[i].time_s > found.files[i - 1].time_s))
      throw bad_input("views " + found.files[i - 1].name + " and " + found.files[i].name + " have the same time",
                      "times that increase");
}

}  // namespace

std::shared_ptr<const ViewSource> open_views(const fs::path& named, const ReadViewsOptions& options, const Run& run,
                                             Report& report) {
  const auto path = place_of(named);
  const auto& layout = layout_of(path, options);
  auto found = layout.find(path, options, run);
  check_times(found);
  select_views(found.files, options);
  if (options.depth_scale)
    for (auto& camera : found.cameras) camera.depth_scale = *options.depth_scale;
  check_images(found, run);
  find_byte_order(found);
  found.facts["layout"] = layout.title;
  report = std::move(found.report);
  found.depth_bias = depth_bias_of(found, options);
  if (!found.depth_bias.empty()) report.facts["depth_bias"] = "applied, as camera.json has it";
  const auto views = std::make_shared<const FileViews>(std::move(found), options, locator_of(path, options));
  if (views->has_depth()) look_at_depth(*views, report);
  report.counts["poses"] = static_cast<std::int64_t>(views->given_poses().poses.size());
  report.facts["layout"] = layout.title;
  report.message = views->description();
  return views;
}

std::shared_ptr<const ViewSource> open_views(const fs::path& path, const ReadViewsOptions& options, const Run& run) {
  Report report;
  return open_views(path, options, run, report);
}

}  // namespace bole::io
