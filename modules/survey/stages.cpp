// Registers the stages of the module survey.
#include "pipeline/stage.h"
#include "survey/core/move_cloud.h"
#include "survey/core/plot_frame.h"
#include "survey/core/plot_options.h"

namespace bole::survey {
namespace {

pipeline::StageResult run_frame(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const PointCloud& cloud = inputs.cloud("points");
  const bool walked = inputs.has("trajectory");
  auto frame = find_plot_frame(cloud, walked ? &inputs.trajectory("trajectory") : nullptr, options.as<FrameOptions>(),
                               run.part(0, 0.9));
  run.report(0.9, "Moving the points");
  pipeline::StageResult result;
  result.outputs.set("points", move_cloud(cloud, frame.T_plot_map, frame.new_origin, frame.axes, run));
  if (walked)
    result.outputs.set("trajectory", move_trajectory(inputs.trajectory("trajectory"), frame.T_plot_map, frame.axes));
  result.outputs.set("targets", std::move(frame.targets));
  result.report = std::move(frame.report);
  return result;
}

// Of the first input that says so.
Axes axes_of(const DataSet& inputs) {
  if (inputs.has("points")) return inputs.cloud("points").axes;
  if (!inputs.has("stems")) return Axes::unknown;
  const auto& facts = inputs.table("stems").facts;
  const auto it = facts.find("axes");
  return it == facts.end() ? Axes::unknown : axes_from_name(it->second);
}

pipeline::StageResult run_plot(const DataSet& inputs, const OptionSet& options, const Run&) {
  const Table* vertices = inputs.has("vertices") ? &inputs.table("vertices") : nullptr;
  const auto rule = counting_rule_for(options.as<PlotOptions>(), axes_of(inputs), vertices);
  pipeline::StageResult result;
  result.report.message = describe(rule.area) + ", trees from " + number_text(rule.min_dbh_cm) + " cm";
  if (rule.area.shape != PlotArea::Shape::none)
    result.report.metrics["area"] = {rule.area.area_m2(), Unit::square_metre};
  result.outputs.set("plot", to_table(rule));
  return result;
}

void register_frame(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.frame";
  type.vtk_class = "vtkBoleSurveyFrame";
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
  type.options = &option_table(static_cast<const FrameOptions*>(nullptr));
  type.run = run_frame;
  registry.add(std::move(type));
}

void register_plot(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.plot";
  type.vtk_class = "vtkBoleSurveyPlot";
  type.title = "Plot boundary and minimum diameter";
  type.help =
      "Sets the boundary of the plot and the minimum diameter for all stages that count trees. A tree counts when its centre "
      "at breast height lies inside (the boundary counts as inside) and its diameter reaches min_dbh. Areas are "
      "horizontal.";
  type.source = "Improved LOAM forest plot survey (SPEC A13)";
  type.inputs = {{"points", DataKind::cloud, "The map; its axes decide shape auto.", true, {}},
                 {"stems", DataKind::table, "Stems; their axes decide where no map is connected.", true, {}},
                 {"vertices", DataKind::table, "Corners of a polygon in order: x_m, y_m.", true, {}}};
  type.outputs = {
      {"plot", DataKind::table, "Outline (x_m, y_m); shape, size and minimum diameter are facts.", false, {}}};
  type.options = &option_table(static_cast<const PlotOptions*>(nullptr));
  type.run = run_plot;
  registry.add(std::move(type));
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  register_frame(registry);
  register_plot(registry);
}

}  // namespace bole::survey
