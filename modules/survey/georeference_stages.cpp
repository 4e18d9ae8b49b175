// The stage survey.georeference.
#include <algorithm>
#include <cmath>

#include "base/no_number.h"
#include "cloud/known_facts.h"
#include "cloud/table_columns.h"
#include "survey/core/georeference/georeference.h"
#include "survey/core/georeference/place_trees.h"
#include "survey/core/georeference/track_place.h"
#include "survey/survey_stages.h"

namespace bole::survey {
namespace {

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
}  // namespace

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
  registry.add(std::move(type));
}

}  // namespace bole::survey
