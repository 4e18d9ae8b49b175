#include "pipeline/stage.h"
#include "slam/core/edits/apply_loop_edits.h"
#include "slam/core/edits/corrected_map.h"
#include "slam/core/slam.h"

namespace bole::slam {
namespace {

pipeline::StageType run_stage() {
  pipeline::StageType type;
  type.name = "slam.run";
  type.vtk_class = "vtkBoleSlam";
  type.title = "Simultaneous localization and mapping";
  type.help =
      "Estimates the trajectory of the sensor from the frames, and from the inertial unit where the recording has one, "
      "and maps all returns with it. Each frame is de-skewed and registered against a local map of keyframes. Loop "
      "closures correct the drift in a pose graph, and a final adjustment fits the whole trajectory to the whole map. "
      "A preset sets the options that differ between published systems. With a given trajectory only the map is made.";
  type.source =
      "Zhang and Singh 2014 (LOAM); SPEC A 1-8 and D; Shan and Englot 2018 (LeGO-LOAM); Kim and Kim 2018 (Scan "
      "Context); Dellenbach et al. 2022 (elastic frames); Forster et al. 2017 and Xu et al. 2022 (inertial unit); Bole";
  type.inputs = {{.name = "frames",
                  .kind = DataKind::frames,
                  .help = "Revolutions of a spinning multi-line sensor.",
                  .arrays = {}}};
  type.outputs = {
      {.name = "points",
       .kind = DataKind::cloud,
       .help = "The map, with the history of each point.",
       .arrays = {arrays::time, arrays::range, arrays::ring, arrays::intensity, arrays::pass, arrays::keyframe,
                  arrays::sensor_x, arrays::sensor_y, arrays::sensor_z}},
      {.name = "trajectory",
       .kind = DataKind::trajectory,
       .help = "Poses of the sensor in the axes of the map.",
       .arrays = {}},
      {.name = "odometry",
       .kind = DataKind::table,
       .help = "Per frame: agreement with the map, observability, sigma0 and standard deviations of the "
               "pose (SPEC A7), and the pose before loop closures; empty with a given trajectory.",
       .arrays = {}},
      {.name = "loops", .kind = DataKind::table, .help = "Accepted loop closures, by their times.", .arrays = {}},
      {.name = "loop_candidates",
       .kind = DataKind::table,
       .help = "Every loop closure that was tried: frames, score, verdict with its reason, residual, relative pose.",
       .arrays = {}},
      {.name = "pose_graph",
       .kind = DataKind::table,
       .help = "Edges of the pose graph: information, residuals and weight.",
       .arrays = {}}};
  type.version = 6;
  type.options = &option_table(static_cast<const SlamOptions*>(nullptr));
  type.in_force = [](const OptionSet& options) {
    const SlamOptions filled = filled_in(options.as<SlamOptions>());
    OptionSet out = options;
    for (const auto& spec : out.table().specs) out.set(spec.name, spec.get(&filled));
    return out;
  };
  type.main_numbers = {"frames",      "frames_failed",    "keyframes", "loops",  "refused_loops",
                       "path_length", "registration_rms", "overlap",   "points", "seconds"};
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    auto result = run_slam(inputs.frames("frames"), options.as<SlamOptions>(), run);
    pipeline::StageResult out;
    out.outputs.set("points", std::move(result.points));
    out.outputs.set("trajectory", std::move(result.trajectory));
    out.outputs.set("odometry", std::move(result.odometry));
    out.outputs.set("loops", std::move(result.loops));
    out.outputs.set("loop_candidates", std::move(result.loop_candidates));
    out.outputs.set("pose_graph", std::move(result.pose_graph));
    out.report = std::move(result.report);
    return out;
  };
  return type;
}

pipeline::StageType edit_stage() {
  pipeline::StageType type;
  type.name = "slam.edit_loops";
  type.vtk_class = "vtkBoleEditLoops";
  type.title = "Edit loop closures";
  type.help =
      "Applies what a person decided about loop closures: accept one that was refused, or strike one out, by the "
      "frames "
      "of the scan, each with author, time and reason. The pose graph is solved again with the odometry as it was, and "
      "trajectory and map move with it: no frame is read again. The final adjustment is carried along, not repeated. A "
      "loop accepted by hand is held whatever the others say. The edits are kept in the pipeline and applied after "
      "every run. An edit that no longer fits is a conflict: it changes nothing and is listed. Without edits "
      "everything passes through unchanged.";
  type.source = "SPEC A8 (pose graph over keyframes); Bole";
  type.inputs = {{"points", DataKind::cloud, "The map of slam.run.", false, {arrays::time}},
                 {"trajectory", DataKind::trajectory, "Its trajectory.", false, {}},
                 {"odometry", DataKind::table, "Its odometry: a row per frame, with poses.", false, {}},
                 {"loop_candidates", DataKind::table, "The loop closures that it tried.", false, {}}};
  type.outputs = {
      {"points", DataKind::cloud, "The map after the edits.", false, {}},
      {"trajectory", DataKind::trajectory, "The trajectory after the edits.", false, {}},
      {"loops", DataKind::table, "Accepted loop closures after the edits.", false, {}},
      {"loop_candidates", DataKind::table, "All loop closures, with verdict and state (auto, edited).", false, {}},
      {"pose_graph", DataKind::table, "Edges of the pose graph after the edits.", false, {}},
      {"log", DataKind::table, "Every edit, whether it was applied, and why not.", false, {}}};
  type.options = &option_table(static_cast<const LoopEditOptions*>(nullptr));
  type.main_numbers = {"loops", "applied", "conflicts", "keyframes_moved_rms", "keyframes_moved_max"};
  type.run = [](const DataSet& in, const OptionSet& set, const Run& run) {
    const auto& options = set.as<LoopEditOptions>();
    const auto edits = edits_of(options.file, options.edits, parse_loop_edits);
    auto edited = apply_loop_edits(in.table("odometry"), in.table("loop_candidates"), edits, options, run.part(0, 0.3));
    pipeline::StageResult out;
    if (edited.corrections) {
      out.outputs.set("points", corrected(in.cloud("points"), *edited.corrections, run));
      out.outputs.set("trajectory", corrected(in.trajectory("trajectory"), *edited.corrections));
    } else {
      out.outputs.set("points", Data(in.get<PointCloud>("points")));
      out.outputs.set("trajectory", Data(in.get<Trajectory>("trajectory")));
    }
    out.outputs.set("loops", std::move(edited.loops));
    out.outputs.set("loop_candidates", std::move(edited.candidates));
    out.outputs.set("pose_graph", std::move(edited.graph));
    out.outputs.set("log", std::move(edited.log));
    out.report = std::move(edited.report);
    return out;
  };
  return type;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(run_stage());
  registry.add(edit_stage());
}

}  // namespace bole::slam
