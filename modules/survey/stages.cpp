// Registers the stages of the module survey.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "cloud/known_facts.h"
#include "cloud/table_columns.h"
#include "pipeline/stage.h"
#include "survey/core/check/check_survey.h"
#include "survey/core/georeference/georeference.h"
#include "survey/core/georeference/place_trees.h"
#include "survey/core/georeference/track_place.h"
#include "survey/core/join_trajectory.h"
#include "survey/core/move_cloud.h"
#include "survey/core/plot_cover.h"
#include "survey/core/plot_frame.h"
#include "survey/core/plot_options.h"
#include "survey/core/revisit/revisit.h"

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

void judge_cover(const PlotArea& area, const PointCloud& points, const Run& run, Report& report) {
  constexpr double max_empty = 0.1;
  const double empty = empty_share(area, points, run);
  if (!std::isfinite(empty)) return;
  report.metrics["empty"] = {100 * empty, Unit::percent};
  if (empty <= max_empty) return;
  report.find(Severity::look, "plot_partly_empty",
              fmt::format("{:.0f} % of the plot ({}, centre ({:.2f}, {:.2f})) holds no points: values per hectare are "
                          "too low there. Move the plot (x, y), make it smaller, or scan the rest",
                          100 * empty, describe(area), area.centre.x(), area.centre.y()));
}

pipeline::StageResult run_plot(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const Table* vertices = inputs.has("vertices") ? &inputs.table("vertices") : nullptr;
  const auto plot = placed_plot(options.as<PlotOptions>(), axes_of(inputs), vertices, site_of(inputs, run));
  const auto& area = plot.rule.area;
  pipeline::StageResult result;
  auto& report = result.report;
  report.message = describe(area);
  if (!plot.centre.empty()) {
    report.facts["centre"] = plot.centre;
    report.message += fmt::format(" about {} ({:.2f}, {:.2f})", plot.centre, area.centre.x(), area.centre.y());
  }
  report.message += ", trees from " + number_text(plot.rule.min_dbh_cm) + " cm";
  if (area.shape != PlotArea::Shape::none) {
    report.metrics["area"] = {area.area_m2(), Unit::square_metre};
    if (inputs.has("points")) judge_cover(area, inputs.cloud("points"), run, report);
  }
  result.outputs.set("plot", to_table(plot.rule));
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

// With the stage that reads tables: this module has no reader of its own.
Table read_control(const std::string& file, const Run& run) {
  const auto& reader = pipeline::StageRegistry::global().at("io.read_table");
  OptionSet options(*reader.options);
  options.set("file", file);
  return reader.run({}, options, run).outputs.table("table");
}

std::vector<Eigen::Vector3d> places_of(const Table& stems) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), z = numbers_or_nan(stems, "z_m");
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(x[i] + y[i])) places.emplace_back(x[i], y[i], z[i]);
  return places;
}

std::string crs_of_data(const Table& stems) {
  const bool global = axes_from_name(fact_text(stems.facts, facts::axes).value_or("unknown")) == Axes::global;
  return global ? fact_text(stems.facts, facts::crs).value_or("") : std::string();
}

// The centre target, or the origin where there is none, as the place of the centre of the options.
Table with_centre(const DataSet& inputs) {
  Table targets = inputs.has("targets") ? inputs.table("targets") : Table();
  if (targets.has("name"))
    for (std::size_t i = 0; i < targets.rows(); ++i)
      if (targets.text("name", i) == "centre") return targets;
  Table origin;
  origin.set("name", std::vector<std::string>{"centre"});
  for (const char* axis : {"x_m", "y_m", "z_m"}) origin.set(axis, std::vector<double>{0});
  return origin;
}

// The outputs of the stage.
pipeline::StageResult placed(const DataSet& inputs, Georeference place, const GeoreferenceOptions& options) {
  const Table& stems = inputs.table("stems");
  pipeline::StageResult result;
  const auto own = own_standard_errors(stems, options.map_sd);
  result.outputs.set("stems", with_places(stems, place, &own));
  if (inputs.has("targets")) {
    const Table& found = inputs.table("targets");
    result.outputs.set("targets", found.has("x_m") ? with_places(found, place, nullptr) : found);
  }
  result.outputs.set("control", std::move(place.control));
  result.report = std::move(place.report);
  return result;
}

LocalPlot local_plot(const DataSet& inputs, const Table& targets) {
  LocalPlot plot;
  plot.axes = axes_of(inputs);
  plot.bearing_target_rad = bearing_target_rad(&targets);
  plot.stems = places_of(inputs.table("stems"));
  return plot;
}

pipeline::StageResult georeference_by_track(const DataSet& inputs, const GeoreferenceOptions& options) {
  if (!inputs.has("trajectory"))
    throw bad_input("a GNSS track is given, but no trajectory of the walk", "both", "Connect trajectory, or set file");
  const Table track = with_plane_columns(inputs.table("track"));
  const auto crs = control_crs(track, options, crs_of_data(inputs.table("stems")));
  return placed(inputs, place_by_track(inputs.trajectory("trajectory"), track, crs, local_plot(inputs, {}), options),
                options);
}

pipeline::StageResult run_georeference(const DataSet& inputs, const OptionSet& option_set, const Run& run) {
  const auto& options = option_set.as<GeoreferenceOptions>();
  const bool centre_given = options.easting || options.latitude_deg,
             control_given = centre_given || !options.file.empty();
  pipeline::StageResult result;
  if (!control_given && !inputs.has("track")) {
    if (options.bearing_deg || !options.crs.empty())
      throw bad_input("crs or bearing is given, but no place of the plot", "control points or the centre",
                      "Set file, or easting and northing, or latitude and longitude");
    for (const char* port : {"stems", "targets"})
      if (inputs.has(port)) result.outputs.set(port, inputs.all().find(port)->second);
    result.outputs.set("control", Table());
    result.report.message =
        "no control points, centre coordinates or GNSS track are given: the place of the plot on the earth is not "
        "known, and "
        "everything stays as it is";
    return result;
  }
  const Table& stems = inputs.table("stems");
  if (!control_given) return georeference_by_track(inputs, options);
  const Table control = centre_given ? centre_as_table(options) : read_control(options.file, run);
  const Table targets = centre_given ? with_centre(inputs) : inputs.has("targets") ? inputs.table("targets") : Table();
  const auto crs = control_crs(control, options, crs_of_data(stems));
  Report report;
  const auto points =
      control_points(control, {&targets, inputs.has("dem") ? &inputs.raster("dem") : nullptr}, crs, options, report);
  auto place = georeference(points, crs, local_plot(inputs, targets), options, std::move(report));
  if (inputs.has("track"))
    place.report.find(Severity::note, "track_not_used", "the GNSS track is not used: the control points go before it");
  return placed(inputs, std::move(place), options);
}
void register_georeference(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.georeference";
  type.vtk_class = "vtkBoleGeoreference";
  type.title = "Georeference the plot";
  type.help =
      "Gives the plot its place on the earth: from control points with projected or geodetic coordinates, or from the "
      "coordinates of the centre and a bearing, or from the track of a GNSS receiver that was carried on the walk (the "
      "offset "
      "of the clocks and the lever arm are estimated). Turn and shift are adjusted by least squares, the level by "
      "control "
      "heights; residuals, standard errors and a test for blunders are reported. Stems and targets get easting and "
      "northing, stems also the standard error of their position. Reports write their files in the coordinate system. "
      "Points that do not carry a place (too few, exchanged axes, other zones, distances that do not fit) are refused. "
      "Without control points and centre everything stays as it is.";
  type.source = "Least squares adjustment; Baarda: A testing procedure for use in geodetic networks, 1968";
  type.inputs = {{"stems", DataKind::table, "Stems with x_m, y_m.", false, {}},
                 {"targets", DataKind::table, "Targets from survey.frame; control points have their names.", true, {}},
                 {"dem", DataKind::raster, "Terrain model, for heights of points that are on the ground.", true, {}},
                 {"trajectory", DataKind::trajectory, "The walk, for a track.", true, {}},
                 {"track", DataKind::table, "Track of a GNSS receiver, from io.read_track.", true, {}}};
  type.outputs = {{"stems", DataKind::table, "The stems with easting_m, northing_m and position_se_m.", false, {}},
                  {"targets", DataKind::table, "The targets with easting_m and northing_m.", true, {}},
                  {"control", DataKind::table, "Control points with residuals; the frame is a fact.", false, {}, true}};
  type.main_numbers = {"residual_rms", "frame_se_max", "turn"};
  type.options = &option_table(static_cast<const GeoreferenceOptions*>(nullptr));
  type.run = run_georeference;
  pipeline::StageResult run_check(const DataSet& inputs, const OptionSet& options, const Run& run) {
    CheckInputs in;
    const auto table = [&](const char* port) { return inputs.has(port) ? &inputs.table(port) : nullptr; };
    if (inputs.has("points")) in.points = &inputs.cloud("points");
    if (inputs.has("dem")) in.dem = &inputs.raster("dem");
    if (inputs.has("trajectory")) in.trajectory = &inputs.trajectory("trajectory");
    in.stems = table("stems");
    in.plot = table("plot");
    in.loops = table("loops");
    in.targets = table("targets");
    auto check = check_survey(in, options.as<CheckOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("findings", std::move(check.findings));
    result.outputs.set("cells", std::move(check.cells));
    result.outputs.set("stems", std::move(check.stems));
    result.outputs.set("boundary", std::move(check.boundary));
    result.report = std::move(check.report);
    return result;
  }

  void register_check(pipeline::StageRegistry & registry) {
    pipeline::StageType type;
    type.name = "survey.check";
    type.vtk_class = "vtkBoleSurveyCheck";
    type.title = "Check the map";
    type.help =
        "Checks a surveyed plot before somebody signs it: ground never seen, density and directions of view in every "
        "cell, places that were not walked, surfaces of different passes, scatter about the bark, loop closures "
        "against "
        "the final trajectory, common lean of the stems, targets, trees on the boundary, stems in each other, stems "
        "without ground or points, heights without tops, and upright structures without a stem. The verdict is sign, "
        "look or walk again, with the reasons and where to go. What an input is missing for is listed as not judged.";
    type.source = "Bole";
    type.inputs = {
        {"points",
         DataKind::cloud,
         "The map; uses height_above_ground, sensor_x/y, pass or time where present.",
         true,
         {}},
        {"dem", DataKind::raster, "Terrain, for clouds without height_above_ground.", true, {}},
        {"trajectory", DataKind::trajectory, "The walk in the axes of the points.", true, {}},
        {"stems", DataKind::table, "Stems: x_m, y_m, and dbh_cm, lean_deg, height_seen where known.", true, {}},
        {"plot", DataKind::table, "Boundary and minimum diameter, from survey.plot.", true, {}},
        {"loops", DataKind::table, "Accepted loop closures, from slam.run.", true, {}},
        {"targets", DataKind::table, "Targets, from survey.frame.", true, {}}};
    type.outputs = {
        {.name = "findings",
         .kind = DataKind::table,
         .help = "What was found: code, severity, text, and where to go; the verdict is a fact.",
         .arrays = {},
         .in_summary = true},
        {"cells", DataKind::table, "The measures of every cell of the plot.", false, {}},
        {"stems", DataKind::table, "Scatter about the bark and distance of the passes at each stem.", false, {}},
        {"boundary", DataKind::table, "Trees on the boundary, in or out by the rule.", false, {}}};
    type.main_numbers = {"ground_unseen", "one_sided", "ground_pass_spread", "stem_pass_spread", "wall", "common_lean"};
    type.options = &option_table(static_cast<const CheckOptions*>(nullptr));
    type.run = run_check;
    registry.add(std::move(type));
  }

  void register_revisit(pipeline::StageRegistry & registry) {
    pipeline::StageType type;
    type.name = "survey.revisit";
    type.vtk_class = "vtkBoleSurveyRevisit";
    type.title = "Compare two surveys";
    type.help =
        "Brings two surveys of one plot together by the places and diameters of their stems, whatever the axes of the "
        "two, and tells what became of every tree: growth of its diameter with a 95 % interval, ingrowth, trees that "
        "are "
        "gone, and trees that one of the two missed, told apart by where they stand, how thick they are, whether their "
        "neighbours were found again and what the other survey rejected there. Maps that do not go together, or in "
        "more "
        "than one way, are refused.";
    type.source = "Bole";
    type.inputs = {
        {"first", DataKind::table, "Stems of the first survey: x_m, y_m, dbh_cm, dbh_lo_cm, dbh_hi_cm.", false, {}},
        {"second", DataKind::table, "Stems of the second survey.", false, {}},
        {"first_rejected", DataKind::table, "Candidates that the first survey rejected: x_m, y_m.", true, {}},
        {"second_rejected", DataKind::table, "Candidates that the second survey rejected.", true, {}}};
    type.outputs = {{"growth", DataKind::table, "A row per tree, in the axes of the first survey.", false, {}},
                    {.name = "values",
                     .kind = DataKind::table,
                     .help = "Values of the stand with their intervals.",
                     .arrays = {},
                     .in_summary = true}};
    type.main_numbers = {"matched", "grew", "shrank", "ingrowth", "gone", "distance_rms"};
    type.options = &option_table(static_cast<const RevisitOptions*>(nullptr));
    type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
      const auto table = [&](const char* port) { return inputs.has(port) ? &inputs.table(port) : nullptr; };
      auto found = revisit(inputs.table("first"), inputs.table("second"), table("first_rejected"),
                           table("second_rejected"), options.as<RevisitOptions>(), run);
      pipeline::StageResult result;
      result.outputs.set("growth", std::move(found.growth));
      result.outputs.set("values", std::move(found.values));
      result.report = std::move(found.report);
      return result;
    };
    registry.add(std::move(type));
  }

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  register_frame(registry);
  register_plot(registry);
  register_join(registry);
  register_georeference(registry);
  register_check(registry);
  register_revisit(registry);
}

}  // namespace bole::survey
