#include "io/core/views/found_views.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "io/core/views/image_header.h"

namespace bole::io {
namespace {

std::string size_text(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

// What can be wrong with the images of one kind.
struct ImageTrouble {
  Tally missing, damaged, other_size, other_depth;

  std::string first(const std::string& kind) const {
    for (const auto& [tally, what] : {std::pair{&missing, " missing"},
                                      {&damaged, " damaged"},
                                      {&other_size, " of another size than the camera"},
                                      {&other_depth, " without one channel of 16 bits"}})
      if (tally->count() > 0) return tally->text(kind + " images are" + what);
    return {};
  }
  std::size_t count() const { return missing.count() + damaged.count() + other_size.count() + other_depth.count(); }
  void tell(Report& report, const std::string& kind, const std::string& what_follows) const {
    missing.tell(report, Severity::look, kind + "_missing", kind + " images are missing", what_follows);
    damaged.tell(report, Severity::look, kind + "_damaged", kind + " images are damaged", what_follows);
    other_size.tell(report, Severity::look, kind + "_size", kind + " images have another size than the camera",
                    what_follows);
    other_depth.tell(report, Severity::look, kind + "_bits", kind + " images do not have one channel of 16 bits",
                     what_follows);
  }
};

// A file that opens and whose header can be read; the reason where there is none.
std::optional<ImageHeader> header_of(const std::filesystem::path& path, const std::string& name,
                                     ImageTrouble& trouble) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    trouble.missing.add(name);
    return std::nullopt;
  }
  try {
    return read_image_header(path);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    trouble.damaged.add(name);
    return std::nullopt;
  }
}

// A lens of 45 deg across, as most cameras have.
void guess(CameraModel& model) {
  model.fx = model.fy = 1.2 * std::max(model.width, model.height);
  model.cx = (model.width - 1) / 2.0;
  model.cy = (model.height - 1) / 2.0;
}

bool check_color(const ViewFile& file, RgbdCamera& camera, ImageTrouble& trouble) {
  const auto header = header_of(file.color, file.name, trouble);
  if (!header) return false;
  auto& model = camera.color;
  if (model.width == 0) {
    model.width = header->width;
    model.height = header->height;
    if (model.fx == 0) guess(model);
    model.check();
  }
  if (header->width == model.width && header->height == model.height) return true;
  trouble.other_size.add(file.name + " is " + size_text(header->width, header->height) + ", the camera " +
                         size_text(model.width, model.height));
  return false;
}

bool check_depth(const ViewFile& file, RgbdCamera& camera, ImageTrouble& trouble) {
  const auto header = header_of(file.depth, file.name, trouble);
  if (!header) return false;
  if (camera.depth && camera.depth->width == 0) {
    camera.depth->width = header->width;
    camera.depth->height = header->height;
    camera.depth->check();
  }
  const auto& model = camera.of_depth();
  if (header->channels != 1 || header->bits != 16) {
    trouble.other_depth.add(file.name + " has " + std::to_string(header->channels) + " of " +
                            std::to_string(header->bits) + " bits");
    return false;
  }
  if (header->width == model.width && header->height == model.height) return true;
  trouble.other_size.add(file.name + " is " + size_text(header->width, header->height) + ", the camera " +
                         size_text(model.width, model.height));
  return false;
}

bool check_mask(const ViewFile& file, const RgbdCamera& camera, ImageTrouble& trouble) {
  const auto header = header_of(file.mask, file.name, trouble);
  if (!header) return false;
  if (header->width == camera.color.width && header->height == camera.color.height) return true;
  trouble.other_size.add(file.name + " is " + size_text(header->width, header->height));
  return false;
}

}  // namespace

std::string Tally::text(const std::string& what) const {
  return std::to_string(count_) + " " + what + " (first: " + first_ + ")";
}

void Tally::tell(Report& report, Severity severity, const std::string& code, const std::string& what,
                 const std::string& remedy) const {
  if (count_ == 0) return;
  report.counts[code] = static_cast<std::int64_t>(count_);
  report.find(severity, code, text(what) + (remedy.empty() ? "" : "; " + remedy));
}

void select_views(std::vector<ViewFile>& files, const ReadViewsOptions& options) {
  std::vector<ViewFile> kept;
  for (std::size_t i = 0; i < files.size(); i += static_cast<std::size_t>(options.every))
    kept.push_back(std::move(files[i]));
  files = std::move(kept);
  const auto most = static_cast<std::size_t>(options.max_views.value_or(0));
  if (most == 0 || files.size() <= most) return;
  kept.clear();
  for (std::size_t i = 0; i < most; ++i) kept.push_back(std::move(files[i * files.size() / most]));
  files = std::move(kept);
}

void check_images(FoundViews& found, const Run& run) {
  ImageTrouble color, depth, mask;
  std::size_t with_depth = 0, depth_listed = 0;
  std::vector<ViewFile> kept;
  const auto listed = found.files.size();
  for (auto& file : found.files) {
    run.check_cancel();
    run.report(static_cast<double>(kept.size()) / static_cast<double>(listed), "looking at images");
    auto& camera = found.cameras.at(file.camera);
    if (!check_color(file, camera, color)) continue;
    depth_listed += !file.depth.empty();
    if (!file.depth.empty() && !check_depth(file, camera, depth)) file.depth.clear();
    if (!file.mask.empty() && !check_mask(file, camera, mask)) file.mask.clear();
    with_depth += !file.depth.empty();
    kept.push_back(std::move(file));
  }
  if (kept.empty())
    throw bad_input("'" + found.folder.string() + "' has no view that can be used: " + color.first("colour"),
                    "colour images of the size of their camera",
                    color.other_size.count() == listed ? "Calibrate the camera at the size of its images" : "");
  if (depth_listed > 0 && with_depth == 0)
    throw bad_input("'" + found.folder.string() + "' has no depth that can be used: " + depth.first("depth"),
                    "depth images with one channel of 16 bits, and of the size of their camera",
                    depth.other_size.count() > 0
                        ? "Images that are not registered to colour need the entries depth and depth_to_color in "
                          "camera.json"
                        : "");
  found.files = std::move(kept);
  color.tell(found.report, "colour", "these views are left out");
  depth.tell(found.report, "depth", "these views have no depth");
  mask.tell(found.report, "mask", "these views have no mask");
  found.report.counts["views"] = static_cast<std::int64_t>(found.files.size());
  found.report.counts["views_with_depth"] = static_cast<std::int64_t>(with_depth);
}

void take_poses(const Trajectory& given, const std::string& name, FoundViews& found) {
  constexpr double same_time_s = 1e-3;
  std::vector<std::pair<ViewFile*, Pose>> matched;
  Tally strangers;
  for (const auto& pose : given.poses) {
    const auto it = std::ranges::lower_bound(found.files, pose.time_s - same_time_s, {}, &ViewFile::time_s);
    if (it != found.files.end() && std::abs(it->time_s - pose.time_s) <= same_time_s)
      matched.emplace_back(&*it, pose.T_target_sensor);
    else
      strangers.add(std::to_string(pose.time_s) + " s");
  }
  const auto poses = given.poses.size();
  if (2 * matched.size() < poses) {
    found.report.find(Severity::look, "poses_other_times",
                      name + " is not used: " + std::to_string(matched.size()) + " of its " + std::to_string(poses) +
                          " poses have the time of a view. Views are at " + std::to_string(found.files.front().time_s) +
                          " s to " + std::to_string(found.files.back().time_s) + " s, poses at " +
                          std::to_string(given.poses.front().time_s) + " s to " +
                          std::to_string(given.poses.back().time_s) + " s");
    return;
  }
  for (auto& [file, pose] : matched) file->T_world_camera = pose;
  strangers.tell(found.report, Severity::note, "poses_without_view", "poses of " + name + " have no view");
  Tally without;
  for (const auto& file : found.files)
    if (!file.T_world_camera) without.add(file.name);
  without.tell(found.report, Severity::look, "views_without_pose", "views have no pose in " + name);
}

}  // namespace bole::io
