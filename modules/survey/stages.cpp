// Registers the stages of the module survey.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "cloud/known_facts.h"
#include "cloud/table_columns.h"
#include "pipeline/stage.h"
#include "survey/core/edit_points.h"
#include "survey/core/join_trajectory.h"
#include "survey/core/move_cloud.h"
#include "survey/core/plot_cover.h"
#include "survey/core/plot_frame.h"
#include "survey/core/plot_options.h"
#include "survey/survey_stages.h"

namespace bole::survey {
namespace {

pipeline::StageResult run_frame(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const PointCloud& cloud = inputs.cloud("points");
  const bool walked = inputs.has("trajectory");
  auto frame = find_plot_frame(cloud, walked ? &inputs.trajectory("trajectory") : nullptr, options.as<FrameOptions>(),
                               run.part(0, 0.9));
  run.report(0.9, "Moving the points");
  pipeline::StageResult result;
  auto moved = move_cloud(cloud, frame.T_plot_map, frame.new_origin, frame.axes, run);
  if (!frame.by_gravity) moved.facts.erase(std::string(facts::level_sigma.key));
  result.outputs.set("points", std::move(moved));
  if (walked) {
    auto path = move_trajectory(inputs.trajectory("trajectory"), frame.T_plot_map, frame.axes);
    if (!frame.by_gravity) path.facts.erase(std::string(facts::level_sigma.key));
    result.outputs.set("trajectory", std::move(path));
  }
  result.outputs.set("targets", std::move(frame.targets));
  result.report = std::move(frame.report);
  return result;
}

std::optional<Eigen::Vector2d> centre_target(const Table& targets) {
  const auto& names = targets.texts("name");
  const auto x = targets.numbers("x_m"), y = targets.numbers("y_m");
  for (std::size_t i = 0; i < targets.rows(); ++i)
    if (names[i] == "centre") return Eigen::Vector2d(x[i], y[i]);
  return std::nullopt;
}

// The middle between the outermost stems.
std::optional<Eigen::Vector2d> middle_of_stems(const Table& stems) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m");
  if (x.empty()) return std::nullopt;
  const auto [min_x, max_x] = std::ranges::minmax(x);
  const auto [min_y, max_y] = std::ranges::minmax(y);
  return Eigen::Vector2d((min_x + max_x) / 2, (min_y + max_y) / 2);
}

PlotSite site_of(const DataSet& inputs, const Run& run) {
  PlotSite site;
  if (inputs.has("targets")) site.target = centre_target(inputs.table("targets"));
  site.middle = [&inputs, &run]() -> std::optional<Eigen::Vector2d> {
    if (inputs.has("points")) return middle_of(inputs.cloud("points"), run);
    return inputs.has("stems") ? middle_of_stems(inputs.table("stems")) : std::nullopt;
  };
  return site;
}

void judge_cover(const PlotArea& area, const Table& plot, const PointCloud& points, const Run& run, Report& report) {
  constexpr double max_empty = 0.1;
  const double empty = empty_share(area, points, run);
  if (!std::isfinite(empty)) return;
  report.metrics["empty"] = {100 * empty, Unit::percent};
  if (empty <= max_empty) return;
  report.find(
      Severity::look, "plot_partly_empty",
      fmt::format("{}{:.0f} % of the plot ({}, centre ({:.2f}, {:.2f})) holds no points: values per hectare are "
                  "too low there. Move the plot (x, y), make it smaller, or scan the rest",
                  assumed_size_remedy(plot), 100 * empty, describe(area), area.centre.x(), area.centre.y()));
}

pipeline::StageResult run_plot(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const Table* vertices = inputs.has("vertices") ? &inputs.table("vertices") : nullptr;
  const auto plot = placed_plot(options.as<PlotOptions>(), axes_of(inputs), vertices, site_of(inputs, run));
  const auto& area = plot.rule.area;
  pipeline::StageResult result;
  auto& report = result.report;
  Table table = to_table(plot.rule);
  if (!plot.assumed_size.empty()) {
    table.facts[assumed_size_fact] = plot.assumed_size;
    report.facts[assumed_size_fact] = plot.assumed_size;
  }
  report.message = describe(area);
  if (!plot.centre.empty()) {
    report.facts["centre"] = plot.centre;
    report.message += fmt::format(" about {} ({:.2f}, {:.2f})", plot.centre, area.centre.x(), area.centre.y());
  }
  report.message += ", trees from " + number_text(plot.rule.min_dbh_cm) + " cm";
  if (area.shape != PlotArea::Shape::none) {
    report.metrics["area"] = {area.area_m2(), Unit::square_metre};
    if (inputs.has("points")) judge_cover(area, table, inputs.cloud("points"), run, report);
  }
  result.outputs.set("plot", std::move(table));
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
  type.version = 2;
  type.options = &option_table(static_cast<const FrameOptions*>(nullptr));
  type.run = run_frame;
  registry.add(std::move(type));
}

pipeline::StageResult run_join(const DataSet& inputs, const OptionSet& options, const Run& run) {
  pipeline::StageResult result;
  if (!inputs.has("trajectory")) {
    result.outputs.set("points", inputs.cloud("points"));
    result.report.message = "no trajectory is given: the points are as they were";
    return result;
  }
  auto joined =
      join_trajectory(inputs.cloud("points"), inputs.trajectory("trajectory"), options.as<JoinOptions>(), run);
  result.outputs.set("points", std::move(joined.points));
  result.outputs.set("trajectory", std::move(joined.trajectory));
  result.report = std::move(joined.report);
  return result;
}

pipeline::StageResult run_edit_points(const DataSet& inputs, const OptionSet& set, const Run& run) {
  const auto& options = set.as<EditPointsOptions>();
  auto edited = edit_points(inputs.cloud("points"), edits_of(options.file, options.edits, parse_point_edits), run);
  pipeline::StageResult result;
  result.outputs.set("point_edits", std::move(edited.table));
  result.report = std::move(edited.report);
  return result;
}

void register_edit_points(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.edit_points";
  type.vtk_class = "vtkBoleSurveyEditPoints";
  type.title = "Edit points";
  type.help =
      "Keeps the points that a person gave to a tree, to no tree, to the ground or to noise: to_tree, to_no_tree, "
      "to_ground and to_noise, each with author, time and reason. Points are selected by an outline drawn over a view, "
      "a box or the stroke of a brush, never by their numbers, so that the same edits hold for a cloud that was "
      "thinned or read again. ground.model leaves points of noise out and takes those given to the ground for ground; "
      "stems.measure gives points to trees before it measures heights, crowns and volumes; stems.edit does so for "
      "trees that a person added. Diameters do not follow from points given to a tree.";
  type.source = "Bole";
  type.inputs = {
      {"points", DataKind::cloud, "The cloud in the axes of the plot, before the ground is modelled.", false, {}}};
  type.outputs = {{"point_edits",
                   DataKind::table,
                   "One row for each edit: edit, action, x_m, y_m, points (in the selection), author, time, reason, "
                   "selection.",
                   false,
                   {}}};
  type.options = &option_table(static_cast<const EditPointsOptions*>(nullptr));
  type.run = run_edit_points;
  registry.add(std::move(type));
}

void register_join(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.join_trajectory";
  type.vtk_class = "vtkBoleSurveyJoinTrajectory";
  type.title = "Join points and trajectory";
  type.help =
      "Joins a cloud that another program mapped with the path of its sensor: every point gets the place of the sensor "
      "at its time, its range and its pass, so that stems are measured along the rays. The clocks of the two are "
      "recognised (GPS time, GPS time less 1e9 s, seconds of the GPS week, Unix time), and the offset is reported. "
      "Clocks that do not go together for certain, and a path that does not run through the cloud, are refused. "
      "Without a trajectory the points stay as they are.";
  type.source = "Bole";
  type.inputs = {
      {"points", DataKind::cloud, "A cloud with the time of every point.", false, {}},
      {"trajectory", DataKind::trajectory, "The path of the sensor, in the coordinates of the points.", true, {}}};
  type.outputs = {
      {"points", DataKind::cloud, "The cloud with sensor_x, sensor_y, sensor_z, range and pass.", false, {}},
      {"trajectory", DataKind::trajectory, "The path with the times of the points.", true, {}}};
  type.options = &option_table(static_cast<const JoinOptions*>(nullptr));
  type.run = run_join;
  registry.add(std::move(type));
}

void register_plot(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.plot";
  type.vtk_class = "vtkBoleSurveyPlot";
  type.title = "Plot boundary and minimum diameter";
  type.help =
      "Sets the boundary of the plot and the minimum diameter for all stages that count trees. A tree counts when its "
      "centre "
      "at breast height lies inside (the boundary counts as inside) and its diameter reaches min_dbh. Areas are "
      "horizontal. Options that contradict one another are refused. A plot of which more than a tenth holds no points "
      "is reported.";
  type.source = "Improved LOAM forest plot survey (SPEC A13)";
  type.inputs = {{"points", DataKind::cloud, "The map; its axes decide shape auto, its middle is a centre.", true, {}},
                 {"stems", DataKind::table, "Stems; their axes decide where no map is connected.", true, {}},
                 {"targets", DataKind::table, "Targets from survey.frame; the one named centre is a centre.", true, {}},
                 {"vertices", DataKind::table, "Corners of a polygon in order: x_m, y_m.", true, {}}};
  type.outputs = {
      {"plot", DataKind::table, "Outline (x_m, y_m); shape, size and minimum diameter are facts.", false, {}}};
  type.version = 2;
  type.options = &option_table(static_cast<const PlotOptions*>(nullptr));
  type.run = run_plot;
  registry.add(std::move(type));
}

}  // namespace

Axes axes_of(const DataSet& inputs) {
  if (inputs.has("points")) return inputs.cloud("points").axes;
  if (!inputs.has("stems")) return Axes::unknown;
  const auto& facts = inputs.table("stems").facts;
  const auto it = facts.find("axes");
  return it == facts.end() ? Axes::unknown : axes_from_name(it->second);
}

void register_stages(pipeline::StageRegistry& registry) {
  register_frame(registry);
  register_plot(registry);
  register_join(registry);
  register_edit_points(registry);
  register_georeference(registry);
  register_check(registry);
  register_revisit(registry);
}

}  // namespace bole::survey
