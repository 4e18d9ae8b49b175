#include "io/core/views/layout_tools.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.h"

namespace bole::io {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

fs::path first_of(const fs::path& folder, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (is_there(folder / name)) return folder / name;
  return {};
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

void allow_damaged_poses(FoundViews& found, const std::function<void()>& take) {
  try {
    take();
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::bad_input) throw;
    for (auto& file : found.files) file.T_world_camera.reset();
    found.report.find(Severity::look, "poses_damaged", std::string("the given poses are not used: ") + e.what());
  }
}

void tell_numbering(const NumberedFiles& images, const std::string& folder, Report& report) {
  const auto count = [](std::size_t n) { return std::to_string(n); };
  if (images.missing > 0) {
    report.counts["views_missing"] = static_cast<std::int64_t>(images.missing);
    report.find(Severity::look, "views_missing",
                count(images.missing) + " images are missing in the sequence of " + folder +
                    " (first: " + count(images.first_missing) + "); the times of the others follow from their numbers");
  }
  if (images.others > 0)
    report.find(Severity::note, "other_images",
                count(images.others) + " images of " + folder + " have no number as their name and are left out");
  if (images.repeated > 0)
    report.find(Severity::note, "repeated_images",
                count(images.repeated) + " images of " + folder + " repeat a number");
}

void take_depth_images(const NumberedFiles& color, const NumberedFiles& depth, const fs::path& folder,
                       FoundViews& found) {
  if (depth.by_number.empty()) {
    found.report.find(Severity::look, "depth_absent",
                      "'" + folder.filename().string() + "' " +
                          (is_folder(folder) ? "holds no depth images" : "does not exist") +
                          ": the views have no depth");
    return;
  }
  auto file = found.files.begin();
  for (const auto& [number, path] : color.by_number) {
    const auto it = depth.by_number.find(number);
    (file++)->depth = it != depth.by_number.end() ? it->second : folder / (std::to_string(number) + " is missing");
  }
  Tally alone;
  for (const auto& [number, path] : depth.by_number)
    if (!color.by_number.contains(number)) alone.add(path.stem().string());
  alone.tell(found.report, Severity::note, "depth_without_colour", "depth images have no colour image");
}

void take_listed_poses(const std::vector<ListedPose>& poses, const NumberedFiles& color, const std::string& name,
                       FoundViews& found) {
  const auto first = color.by_number.begin()->first, last = color.by_number.rbegin()->first;
  const auto span = static_cast<std::size_t>((last - first) / std::max(color.step, 1U)) + 1;
  std::map<double, const Pose*> by_key;
  for (const auto& listed : poses)
    if (listed.key) by_key.emplace(*listed.key, &listed.pose);
  const bool keys_are_numbers =
      by_key.size() == poses.size() && std::ranges::all_of(color.by_number, [&](const auto& entry) {
        return by_key.contains(static_cast<double>(entry.first));
      });
  if (!keys_are_numbers && poses.size() != span && poses.size() != color.by_number.size()) {
    found.report.find(Severity::look, "poses_other_count",
                      name + " is not used: it has " + std::to_string(poses.size()) + " poses for " +
                          std::to_string(color.by_number.size()) + " images with the numbers " + std::to_string(first) +
                          " to " + std::to_string(last));
    return;
  }
  auto file = found.files.begin();
  std::size_t rank = 0;
  for (const auto& [number, path] : color.by_number) {
    const auto step = static_cast<std::size_t>((number - first) / std::max(color.step, 1U));
    const Pose& pose =
        keys_are_numbers ? *by_key.at(static_cast<double>(number)) : poses[poses.size() == span ? step : rank].pose;
    (file++)->T_world_camera = pose;
    ++rank;
  }
}

void tell_unknown_scale(const std::string& file, FoundViews& found) {
  found.facts["scale"] = "unknown";
  found.report.find(
      Severity::look, "scale_unknown",
      "lengths are in the unit of " + file + ", which need not be the metre: give a board or a known length");
}

}  // namespace bole::io
