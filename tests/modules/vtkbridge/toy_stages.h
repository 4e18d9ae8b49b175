// Small stages with known answers, which count how often they run.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>

#include "cloud/preview.h"
#include "pipeline/stage.h"

namespace toy {

using namespace bole;

inline std::map<std::string, std::atomic<int>>& runs() {
  static std::map<std::string, std::atomic<int>> counts;
  return counts;
}

struct PointsOptions {
  int count = 100;
  double spacing = 0.5;
  std::string file;
};
inline const OptionTable& points_options() {
  using S = PointsOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, int>{"count", &S::count, Unit::none, {0, 1000000}, Tier::basic, "Number of points."},
      Option<S, double>{"spacing", &S::spacing, Unit::metre, {0.001, 10}, Tier::basic, "Distance between points."},
      Option<S, std::string>{
          "file", &S::file, TextKind::input_path, {}, Tier::advanced, "A file whose size is added to the count."},
  });
  return table;
}

struct LiftOptions {
  double by = 1;
  bool fail = false;
};
inline const OptionTable& lift_options() {
  using S = LiftOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, double>{"by", &S::by, Unit::metre, {-100, 100}, Tier::basic, "Height to add."},
      Option<S, bool>{"fail", &S::fail, Tier::expert, "Fails on purpose."},
  });
  return table;
}

struct NoOptions {};
inline const OptionTable& no_options() {
  static const OptionTable table = make_option_table<NoOptions>({});
  return table;
}

inline pipeline::StageResult make_points(const DataSet&, const OptionSet& options, const Run& run) {
  ++runs()["toy.points"];
  const auto& o = options.as<PointsOptions>();
  std::size_t count = static_cast<std::size_t>(o.count);
  if (!o.file.empty()) count += std::filesystem::file_size(o.file);
  PointCloud::Positions positions;
  std::vector<float> range;
  for (std::size_t i = 0; i < count; ++i) {
    positions.emplace_back(static_cast<float>(o.spacing * static_cast<double>(i)), 0.0F, 2.0F);
    range.push_back(static_cast<float>(i));
  }
  PointCloud cloud(std::move(positions), {500000, 5600000, 120});
  cloud.axes = Axes::global;
  cloud.set_column(arrays::range, std::move(range));
  run.report(1, "made points");
  pipeline::StageResult result;
  result.report.counts["points"] = static_cast<std::int64_t>(count);
  result.report.facts["axes"] = "global";
  result.outputs.set("points", std::move(cloud));
  return result;
}

// A reader that gives a tenth of its points as any piece.
inline pipeline::StageResult make_all(const DataSet& none, const OptionSet& options, const Run& run) {
  ++runs()["toy.pieces"];
  return make_points(none, options, run);
}
inline pipeline::StageResult make_piece(const Piece&, const OptionSet& options, const Run& run) {
  OptionSet part = options;
  part.set("count", std::get<std::int64_t>(options.get("count")) / 10);
  return make_all({}, part, run);
}

inline pipeline::StageResult lift(const DataSet& inputs, const OptionSet& options, const Run& run) {
  ++runs()["toy.lift"];
  if (run.preview && run.preview->wants()) run.preview->show(inputs);  // the points before they are lifted
  const auto& o = options.as<LiftOptions>();
  if (o.fail) throw bad_input("the toy is broken", "a whole toy", "Set fail to false");
  PointCloud cloud = inputs.cloud("points");
  std::vector<float> height;
  for (const auto& p : cloud.positions()) height.push_back(p.z() + static_cast<float>(o.by));
  cloud.set_column(arrays::height_above_ground, std::move(height));
  run.report(0.5, "lifting");
  pipeline::StageResult result;
  result.report.metrics["lift"] = {o.by, Unit::metre};
  result.outputs.set("points", std::move(cloud));
  return result;
}

inline pipeline::StageResult count(const DataSet& inputs, const OptionSet&, const Run& run) {
  ++runs()["toy.count"];
  Table table;
  const auto& cloud = inputs.cloud("points");
  double mean = 0;
  for (const auto h : cloud.values<float>(arrays::height_above_ground))
    mean += static_cast<double>(h) / static_cast<double>(cloud.size());
  table.set("name", std::vector<std::string>{"points", "stages before"});
  table.set("value", std::vector<double>{static_cast<double>(cloud.size()),
                                         run.record ? static_cast<double>(run.record->stages.size()) : -1});
  table.set("mean_height", std::vector<double>{mean, std::nan("")});
  table.facts["axes"] = axes_name(cloud.axes);
  pipeline::StageResult result;
  result.report.message = "counted";
  result.outputs.set("table", std::move(table));
  return result;
}

inline pipeline::StageResult write(const DataSet& inputs, const OptionSet&, const Run& run) {
  ++runs()["toy.write"];
  if (run.output_dir.empty()) throw bad_input("no output folder", "--out DIR");
  std::filesystem::create_directories(run.output_dir / "figures");
  std::ofstream(run.output_dir / "figures" / "count.txt")
      << inputs.table("table").text("value", 0) << (inputs.has("extra") ? " extra" : "") << "\n";
  return {};
}

// Polls as stages do, for up to ten seconds; keeps a half result when asked to finish.
inline pipeline::StageResult slow(const DataSet& inputs, const OptionSet&, const Run& run) {
  ++runs()["toy.slow"];
  pipeline::StageResult result;
  result.outputs.set("points", PointCloud(inputs.cloud("points")));
  for (int i = 0; i < 1000; ++i) {
    run.check_cancel();
    if (run.asked_to_finish()) {
      result.report.status = Status::finished_early;
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (i % 5 == 0) run.report(i / 1000.0, "slowly");
  }
  return result;
}

class ToyFrames : public FrameSource {
 public:
  std::size_t size() const override { return 4; }
  void read(std::size_t index, ScanFrame& frame) const override {
    frame.clear();
    frame.start_time_s = frame_time_s(index);
    for (std::size_t i = 0; i <= index; ++i) {
      frame.positions.emplace_back(3.0F, 4.0F, 0.0F);
      frame.time_offset_s.push_back(0.01F * static_cast<float>(i));
      frame.ring.push_back(static_cast<std::uint16_t>(i));
      frame.intensity.push_back(10);
      frame.return_number.push_back(1);
    }
  }
  double frame_time_s(std::size_t index) const override { return 100.0 + 0.1 * static_cast<double>(index); }
  int rings() const override { return 4; }
  std::string sensor_model() const override { return "toy"; }
  std::string description() const override { return "four toy frames"; }
  std::string locator() const override { return R"({"toy": true})"; }
};

inline pipeline::StageResult open_frames(const DataSet&, const OptionSet&, const Run&) {
  ++runs()["toy.frames"];
  pipeline::StageResult result;
  result.report.counts["frames"] = 4;
  result.outputs.set("frames", Data(std::shared_ptr<const FrameSource>(std::make_shared<ToyFrames>())));
  return result;
}

inline pipeline::StageResult use_frames(const DataSet& inputs, const OptionSet&, const Run&) {
  ++runs()["toy.use_frames"];
  const auto& frames = inputs.frames("frames");
  Trajectory path;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    StampedPose pose{frames.frame_time_s(i), Pose::Identity()};
    pose.T_target_sensor.translation().x() = static_cast<double>(i);
    path.poses.push_back(pose);
  }
  Raster raster;
  raster.nx = 2, raster.ny = 3, raster.cell_m = 0.5, raster.origin = {10, 20};
  raster.values = {1, 2, 3, 4, 5, std::nanf("")};
  pipeline::StageResult result;
  result.outputs.set("trajectory", std::move(path));
  result.outputs.set("dem", std::move(raster));
  return result;
}

inline pipeline::StageType stage_type(std::string name, std::vector<pipeline::Port> inputs,
                                      std::vector<pipeline::Port> outputs, const OptionTable& options,
                                      decltype(pipeline::StageType::run) run) {
  pipeline::StageType type;
  type.name = std::move(name);
  type.title = type.name;
  type.help = "A toy for tests.";
  type.source = "Bole";
  type.inputs = std::move(inputs), type.outputs = std::move(outputs);
  type.options = &options;
  type.run = std::move(run);
  return type;
}

inline void register_toys() {
  auto& registry = pipeline::StageRegistry::global();
  for (auto& [name, n] : runs()) n = 0;
  if (!registry.first_time("toys")) return;
  const pipeline::Port cloud{"points", DataKind::cloud, "Points.", false, {}};
  const pipeline::Port with_height{"points", DataKind::cloud, "Points.", false, {arrays::height_above_ground}};
  registry.add(stage_type("toy.points", {}, {{"points", DataKind::cloud, "Points.", false, {arrays::range}}},
                          points_options(), make_points));
  auto pieces = stage_type("toy.pieces", {}, {{"points", DataKind::cloud, "Points.", false, {arrays::range}}},
                           points_options(), make_all);
  pieces.run_piece = make_piece;
  registry.add(std::move(pieces));
  registry.add(stage_type("toy.lift", {cloud}, {with_height}, lift_options(), lift));
  registry.add(
      stage_type("toy.count", {with_height}, {{"table", DataKind::table, "Counts.", false, {}}}, no_options(), count));
  auto sink = stage_type(
      "toy.write", {{"table", DataKind::table, "Counts.", false, {}}, {"extra", DataKind::cloud, "More.", true, {}}},
      {}, no_options(), write);
  sink.writes_files = true;
  registry.add(std::move(sink));
  registry.add(stage_type("toy.nothing", {}, {cloud}, no_options(),
                          [](const DataSet&, const OptionSet&, const Run&) { return pipeline::StageResult(); }));
  registry.add(stage_type("toy.glance", {{"extra", DataKind::cloud, "What there is.", true, {}}}, {}, no_options(),
                          [](const DataSet&, const OptionSet&, const Run&) { return pipeline::StageResult(); }));
  registry.add(stage_type("toy.slow", {cloud}, {cloud}, no_options(), slow));
  registry.add(
      stage_type("toy.frames", {}, {{"frames", DataKind::frames, "Frames.", false, {}}}, no_options(), open_frames));
  registry.add(stage_type(
      "toy.use_frames", {{"frames", DataKind::frames, "Frames.", false, {}}},
      {{"trajectory", DataKind::trajectory, "Path.", false, {}}, {"dem", DataKind::raster, "Grid.", false, {}}},
      no_options(), use_frames));
}

// A folder of its own for each test, removed at its end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    static std::atomic<int> counter{0};
    path_ = std::filesystem::temp_directory_path() /
            ("bole_bridge_" + std::to_string(::getpid()) + "_" + std::to_string(counter++));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace toy
