// orchard_loops SCAN [frames=N] [out=DIR] [option=value ...]
// SPEC D: one odometry over a simulated recording (preset lego_loam, or as the options say), then its revisits looked
// for in each way and registered in each way, so that nothing else differs. Prints a JSON object with a row per way:
// loops found, right by place, true by pose, recall, and RMSE and SD of the key frames' trajectory (SPEC D 16, 17).
// With `out`, writes reference.tum and for each row NAME.tum and NAME-loops.csv, for `bole evaluate`. What
// orchard_tables.py runs.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "evaluation/core/evaluate_loops.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "io/core/frame_source.h"
#include "io/core/table_file.h"
#include "io/core/trajectory_file.h"
#include "slam/core/context_index.h"
#include "slam/core/loops.h"
#include "slam/core/odometry.h"
#include "slam/core/pose_graph.h"
#include "slam/core/tum_poses.h"

namespace {

using namespace bole;
using Json = nlohmann::ordered_json;

struct Settings {
  std::string scan, out;
  std::size_t frames = 1000000;
  OptionSet options{option_table(static_cast<const SlamOptions*>(nullptr))};
};

std::vector<Keyframe> followed(const Settings& settings, const SlamOptions& options, std::size_t& frames_used) {
  const auto source = open_frame_source(settings.scan);
  const ScanGate gate{options.range_min_m, options.range_max_m, source->rings() > 0 ? source->rings() : 1024};
  FeatureExtractor extractor(options);
  Odometry odometry(options);
  ScanFrame frame;
  Scan scan;
  Features features;
  for (std::size_t i = 0; i < std::min(settings.frames, source->size()); ++i) {
    source->read(i, frame);
    prepare_scan(frame, gate, scan);
    extractor.extract(scan, features);
    const auto keyframes = odometry.keyframes().size();
    odometry.add(i, scan.begin_time_s, scan.end_time_s, features, {});
    if (odometry.keyframes().size() > keyframes)
      odometry.set_context(context_of(scan, odometry.frames().back().motion, context_shape(options)));
    if (odometry.lost()) throw failure("the track was lost at frame " + std::to_string(i), odometry.why_failed());
    frames_used = i + 1;
    if (i % 500 == 0) std::fprintf(stderr, "frame %zu of %zu\n", i, source->size());
  }
  return odometry.take_keyframes();
}

Trajectory path_of(const std::vector<Keyframe>& keyframes, const std::vector<Pose>& T_map_keyframe) {
  Trajectory out;
  for (std::size_t k = 0; k < keyframes.size(); ++k) out.poses.push_back({keyframes[k].time_s, T_map_keyframe[k]});
  return out;
}

std::vector<Pose> poses_of(const std::vector<Keyframe>& keyframes) {
  std::vector<Pose> out;
  for (const auto& k : keyframes) out.push_back(k.T_map_keyframe);
  return out;
}

Table table_of(const std::vector<Loop>& loops, const std::vector<Keyframe>& keyframes) {
  std::map<std::string, std::vector<double>> columns;
  const std::array<const char*, 7> pose{"x_m", "y_m", "z_m", "qx", "qy", "qz", "qw"};
  for (const auto* name : {"from_time_s", "to_time_s", "way_m", "correction_m", "overlap"}) columns[name];
  for (const auto* name : pose) columns[name];
  for (const auto& l : loops) {
    columns["from_time_s"].push_back(keyframes[l.from].time_s), columns["to_time_s"].push_back(keyframes[l.to].time_s);
    columns["way_m"].push_back(keyframes[l.to].path_m - keyframes[l.from].path_m);
    columns["correction_m"].push_back(l.correction_m), columns["overlap"].push_back(l.overlap);
    const Eigen::Quaterniond q(l.T_from_to.linear());
    const Eigen::Vector3d t = l.T_from_to.translation();
    const std::array<double, 7> values{t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
    for (std::size_t i = 0; i < pose.size(); ++i) columns[pose[i]].push_back(values[i]);
  }
  Table table;
  for (auto& [name, values] : columns) table.set(name, values);
  return table;
}

void add_summary(const Table& summary, const std::vector<std::string>& measures, Json& row) {
  const auto& names = summary.texts("measure");
  const auto values = summary.numbers("value");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::ranges::find(measures, names[i]) != measures.end())
      row[names[i]] = std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr);
}

}  // namespace

int main(int count, char** arguments) try {
  Settings settings;
  settings.options.set_text("preset", "lego_loam");
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    const auto equals = word.find('=');
    const auto name = word.substr(0, equals), value = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (equals == std::string::npos)
      settings.scan = word;
    else if (name == "frames")
      settings.frames = std::stoul(value);
    else if (name == "out")
      settings.out = value;
    else
      settings.options.set_text(name, value);
  }
  namespace fs = std::filesystem;
  const auto options = resolved(settings.options.as<SlamOptions>());
  Trajectory truth;
  truth.poses = read_tum_poses((fs::path(settings.scan).parent_path() / "trajectory.tum").string());
  std::size_t frames = 0;
  const auto start = std::chrono::steady_clock::now();
  const auto keyframes = followed(settings, options, frames);
  if (!settings.out.empty()) fs::create_directories(settings.out);

  Json report{{"scan", settings.scan}, {"frames", frames}, {"keyframes", keyframes.size()}};
  report["ms_per_frame"] = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() /
                           static_cast<double>(frames);
  const std::vector<std::string> path_measures{"length", "ate_rmse", "ate_sd", "ate_mean", "ate_max", "end_error"},
      loop_measures{"loops_found",         "loops_right",  "loops_wrong", "loop_precision",         "loops_true_pose",
                    "loop_pose_precision", "loop_chances", "loop_recall", "loop_shift_error_median"};
  const auto judge = [&](const std::string& name, const Trajectory& path, Json& row) {
    add_summary(evaluate_trajectory(path, truth, {}).summary, path_measures, row);
    if (!settings.out.empty()) write_tum(fs::path(settings.out) / (name + ".tum"), path);
  };
  judge("no_loops", path_of(keyframes, poses_of(keyframes)), report["no_loops"]);
  Trajectory driven;  // the part of the truth that was followed
  for (const auto& p : truth.poses)
    if (p.time_s <= keyframes.back().time_s) driven.poses.push_back(p);
  if (!settings.out.empty()) write_tum(fs::path(settings.out) / "reference.tum", driven);

  for (const std::string search : {"odometry", "context"})
    for (const std::string registration : {"icp", "ndt_icp", "features"}) {
      auto way = options;
      way.loops = search, way.loop_registration = registration;
      const auto begin = std::chrono::steady_clock::now();
      const auto found = find_loops(keyframes, way, {});
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      const auto graph = optimise_pose_graph(keyframes, found.loops, {});
      const std::string name = search + "-" + registration;
      Json row{{"search", search}, {"registration", registration}, {"candidates", found.candidates}};
      row["refused"] = std::ranges::count(graph.refused, 1);
      const auto loops = evaluate_loops(table_of(kept_loops(found.loops, graph), keyframes), driven, {});
      add_summary(loops.summary, loop_measures, row);
      row["doubted"] = graph.doubted_loops, row["seconds"] = seconds;
      if (!settings.out.empty()) write_table(fs::path(settings.out) / (name + "-loops.csv"), loops.loops);
      judge(name, path_of(keyframes, graph.T_map_keyframe), row);
      report["ways"].push_back(row);
      std::fprintf(stderr, "%s\n", row.dump().c_str());
    }
  std::printf("%s\n", report.dump(1).c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "orchard_loops: %s\n", error.what());
  return 1;
}
