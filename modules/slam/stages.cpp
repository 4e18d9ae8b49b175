#include "pipeline/stage.h"
#include "slam/core/slam.h"

namespace bole::slam {

void register_stages(pipeline::StageRegistry& registry) {
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
               "pose (SPEC A7); empty with a given trajectory.",
       .arrays = {}},
      {.name = "loops", .kind = DataKind::table, .help = "Accepted loop closures, by their times.", .arrays = {}}};
  type.version = 4;
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
    out.report = std::move(result.report);
    return out;
  };
  registry.add(std::move(type));
}

}  // namespace bole::slam
