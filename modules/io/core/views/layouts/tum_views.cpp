// The layout of the TUM RGB-D benchmark (Sturm et al., IROS 2012): files listed with their times.
#include <algorithm>
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

constexpr double max_apart_s = 0.02;    // between a colour image and its depth image (associate.py of the benchmark)
constexpr double max_pose_gap_s = 0.1;  // between the poses about a view

struct ListedFile {
  double time_s = 0;
  std::string name;
};

// The lines of a file "time name" or "time name time name", comments left out.
std::vector<std::vector<ListedFile>> read_list(const fs::path& path, std::string& comments) {
  const MappedFile file(path);
  LineReader lines(file.bytes());
  std::string_view line;
  std::vector<std::vector<ListedFile>> rows;
  while (lines.next(line)) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#') {
      if (comments.size() < 1000) comments += line;
      continue;
    }
    const auto words = split_blanks(line);
    std::vector<ListedFile> row;
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
      double time = 0;
      if (!parse_number(words[i], time) || !std::isfinite(time)) break;
      row.push_back({time, std::string(words[i + 1])});
    }
    if (row.empty() || 2 * row.size() != words.size() || row.size() > 2)
      throw bad_input("'" + path.string() + "' line " + std::to_string(lines.number()) + " is '" +
                          std::string(line.substr(0, 60)) + "'",
                      "a time and the name of a file, or both twice");
    rows.push_back(std::move(row));
  }
  return rows;
}

fs::path association_file(const fs::path& folder) {
  return first_of(folder, {"associate.txt", "associations.txt", "association.txt", "associated.txt"});
}

// In the order of time; of those with the same time the first.
void put_in_order(FoundViews& found) {
  std::ranges::stable_sort(found.files, {}, &ViewFile::time_s);
  Tally repeated;
  std::vector<ViewFile> kept;
  for (auto& file : found.files) {
    if (!kept.empty() && !(file.time_s > kept.back().time_s))
      repeated.add(file.name);
    else
      kept.push_back(std::move(file));
  }
  repeated.tell(found.report, Severity::look, "repeated_times", "views have the time of another one", "left out");
  found.files = std::move(kept);
}

ViewFile view_of(const fs::path& folder, const ListedFile& color) {
  return {.name = fs::path(color.name).stem().string(), .time_s = color.time_s, .color = folder / color.name};
}

// Pairs of colour and depth by the smallest difference of time first, each used once.
std::vector<double> associate(const fs::path& folder, const std::vector<std::vector<ListedFile>>& depth,
                              FoundViews& found) {
  struct Pair {
    double apart_s;
    std::size_t color, depth;
  };
  std::vector<ListedFile> depths;
  for (const auto& row : depth) depths.push_back(row.front());
  std::ranges::stable_sort(depths, {}, &ListedFile::time_s);
  std::vector<Pair> pairs;
  for (std::size_t c = 0; c < found.files.size(); ++c) {
    const double time = found.files[c].time_s;
    const auto first = std::ranges::lower_bound(depths, time - max_apart_s, {}, &ListedFile::time_s);
    for (auto it = first; it != depths.end() && it->time_s <= time + max_apart_s && it - first < 16; ++it)
      pairs.push_back({std::abs(it->time_s - time), c, static_cast<std::size_t>(it - depths.begin())});
  }
  std::ranges::stable_sort(pairs, {}, &Pair::apart_s);
  std::vector<bool> taken(depths.size());
  std::vector<double> apart_s;
  for (const auto& pair : pairs) {
    if (taken[pair.depth] || !found.files[pair.color].depth.empty()) continue;
    taken[pair.depth] = true;
    found.files[pair.color].depth = folder / depths[pair.depth].name;
    apart_s.push_back(pair.apart_s);
  }
  return apart_s;
}

std::vector<double> take_associations(const fs::path& folder, const std::vector<std::vector<ListedFile>>& rows,
                                      FoundViews& found) {
  std::vector<double> apart_s;
  for (const auto& row : rows) {
    if (row.size() != 2) throw bad_input("the associations name one file in a line", "colour and depth in each line");
    const bool depth_first = row[0].name.find("depth") != std::string::npos;
    const auto& color = row[depth_first ? 1 : 0];
    const auto& depth = row[depth_first ? 0 : 1];
    auto view = view_of(folder, color);
    view.depth = folder / depth.name;
    apart_s.push_back(std::abs(color.time_s - depth.time_s));
    found.files.push_back(std::move(view));
  }
  return apart_s;
}

void take_files(const fs::path& folder, std::string& comments, FoundViews& found) {
  std::vector<double> apart_s;
  if (const auto path = association_file(folder); !path.empty()) {
    apart_s = take_associations(folder, read_list(path, comments), found);
    put_in_order(found);
    if (is_there(folder / "rgb.txt")) read_list(folder / "rgb.txt", comments);  // its comments name the recording
  } else {
    for (const auto& row : read_list(folder / "rgb.txt", comments)) found.files.push_back(view_of(folder, row.front()));
    put_in_order(found);
    if (is_there(folder / "depth.txt")) apart_s = associate(folder, read_list(folder / "depth.txt", comments), found);
    Tally without;
    for (const auto& file : found.files)
      if (file.depth.empty()) without.add(file.name);
    without.tell(found.report, Severity::look, "views_without_depth", "views have no depth image within 20 ms");
  }
  if (apart_s.empty()) return;
  const auto middle = apart_s.begin() + static_cast<std::ptrdiff_t>(apart_s.size() / 2);
  std::ranges::nth_element(apart_s, middle);
  found.report.metrics["depth_apart"] = {*middle, Unit::second};
}

// Poses are much denser than views: those of the views are between two of them.
void take_truth(const fs::path& path, FoundViews& found) {
  const auto truth = read_tum(path);
  Tally without;
  for (auto& file : found.files) {
    const auto after = std::ranges::lower_bound(truth.poses, file.time_s, {}, &StampedPose::time_s);
    const bool exact = after != truth.poses.end() && after->time_s == file.time_s;
    const bool between = after != truth.poses.end() && after != truth.poses.begin();
    if (exact) {
      file.T_world_camera = after->T_target_sensor;
    } else if (between && after->time_s - std::prev(after)->time_s <= max_pose_gap_s) {
      const auto& before = *std::prev(after);
      const double s = (file.time_s - before.time_s) / (after->time_s - before.time_s);
      file.T_world_camera = interpolate(before.T_target_sensor, after->T_target_sensor, s);
    } else {
      without.add(file.name);
    }
  }
  without.tell(found.report, Severity::look, "views_without_pose", "views have no pose in " + path.filename().string());
}

// The recordings of the benchmark say in a comment, or by the name of their folder, which of three cameras made them.
std::string recorded_with(const fs::path& folder, const std::string& comments) {
  const auto text = comments + fs::absolute(folder).lexically_normal().string();
  for (const char* number : {"1", "2", "3"})
    if (text.find(std::string("freiburg") + number) != std::string::npos) return std::string("tum_freiburg") + number;
  return {};
}

}  // namespace

bool is_tum_layout(const fs::path& path) {
  return is_folder(path) && (is_there(path / "rgb.txt") || !association_file(path).empty());
}

FoundViews find_tum_views(const fs::path& folder, const ReadViewsOptions& options, const Run& run) {
  FoundViews found;
  found.folder = folder;
  std::string comments;
  take_files(folder, comments, found);
  if (found.files.empty()) throw bad_input("'" + folder.string() + "' lists no colour images", "lines 'time name'");
  run.check_cancel();
  auto choice = options.camera;
  const auto own = folder / "camera.json";
  if (choice.empty() && !is_there(own)) {
    choice = recorded_with(folder, comments);
    if (!choice.empty())
      found.report.find(Severity::note, "camera_by_name",
                        "the camera is " + choice + ", by the name of the recording; camera=FILE gives another one");
  }
  auto camera = chosen_camera(choice, own, false, found.report);
  if (!is_there(own) && known_camera(choice) == nullptr) camera.depth_scale = 5000;
  found.cameras = {camera};
  found.report.facts["depth_scale"] = std::to_string(static_cast<int>(camera.depth_scale)) + " per metre";
  if (const auto truth = first_of(folder, {"groundtruth.txt", "poses.tum"}); !truth.empty())
    allow_damaged_poses(found, [&] { take_truth(truth, found); });
  return found;
}

}  // namespace bole::io
