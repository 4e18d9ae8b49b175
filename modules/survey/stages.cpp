// Registers the stages of the module survey.
#include "pipeline/stage.h"
#include "survey/core/move_cloud.h"
#include "survey/core/plot_frame.h"

namespace bole {
namespace {

StageResult run_frame(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const PointCloud& cloud = inputs.cloud("points");
  const bool walked = inputs.has("trajectory");
  auto frame = survey::find_plot_frame(cloud, walked ? &inputs.trajectory("trajectory") : nullptr,
                                       options.as<survey::FrameOptions>(), run.part(0, 0.9));
  run.report(0.9, "Moving the points");
  StageResult result;
  result.outputs.set("points", survey::move_cloud(cloud, frame.T_plot_map, frame.new_origin, frame.axes, run));
  if (walked)
    result.outputs.set("trajectory",
                       survey::move_trajectory(inputs.trajectory("trajectory"), frame.T_plot_map, frame.axes));
  result.outputs.set("targets", std::move(frame.targets));
  result.report = std::move(frame.report);
  return result;
}

}  // namespace

void register_survey_stages(StageRegistry& registry) {
  StageType type;
  type.name = "survey.frame";
  type.title = "Find the plot frame";
  type.help =
      "Moves a map into the axes of the plot: x east, y north, z up, origin on the ground below the centre target. The "
      "vertical comes from the stems (or the ground), origin and heading from two "
      "retro-reflective targets that are found by their strong returns: small, dense, seen from positions far apart. "
      "The target nearest to the start of the walk is the centre. Without targets the map is "
      "levelled and otherwise left as it is.";
  type.source = "SPEC A9: improved LOAM forest plot survey; levelling by stem axes: Bole";
  type.inputs = {
      {"points", DataKind::cloud, "The map; uses intensity and sensor_x, sensor_y, sensor_z where present.", false, {}},
      {"trajectory", DataKind::trajectory, "The sensor's path in the same axes.", true, {}}};
  type.outputs = {{"points", DataKind::cloud, "The map in plot axes, or levelled.", false, {}},
                  {"trajectory", DataKind::trajectory, "The path in the same axes.", true, {}},
                  {"targets", DataKind::table, "Targets found: name, x_m, y_m, z_m, points.", false, {}}};
  type.options = &option_table(static_cast<const survey::FrameOptions*>(nullptr));
  type.run = run_frame;
  registry.add(std::move(type));
}

}  // namespace bole
