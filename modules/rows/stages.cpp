// Registers the stages of the module rows.
#include "pipeline/stage.h"
#include "rows/core/edits/apply_row_edits.h"
#include "rows/core/frame/frame_filters.h"
#include "rows/core/frame/mean_shift.h"
#include "rows/core/frame/place_stems.h"
#include "rows/core/frame/sensor_pose.h"
#include "rows/core/frame/trunk_centres.h"
#include "rows/core/rows/find_rows.h"
#include "rows/core/rows/hedge_rows.h"

namespace bole::rows {
namespace {

pipeline::StageType from_stems() {
  pipeline::StageType type;
  type.name = "rows.from_stems";
  type.vtk_class = "vtkBoleRowsFromStems";
  type.title = "Find plant rows";
  type.help =
      "Finds plant rows in a table of stems: any number of rows, straight or curved, with gaps, in several blocks "
      "of different direction. Stems that fit no row are strays. Plants are numbered along their row and missing "
      "plants are listed. Rows are numbered block by block, from left to right looking along the rows. A column "
      "row_id fixes the assignment. The direction of a row is the angle of its least-squares line with due east.";
  type.source = "Line fit: SPEC B6 (plant rows from a 3-D LiDAR); search for rows: Bole";
  type.inputs = {{"stems", DataKind::table, "Stems: x_m, y_m; row_id and tree_id where known.", false, {}}};
  type.outputs = {
      {"rows", DataKind::table, "One line per row: direction with standard error, ends, plants, spacing.", false, {}},
      {"plants", DataKind::table, "Plants in their rows, numbered; missing ones too.", false, {}},
      {"lines", DataKind::table, "Vertices of the guidance lines.", false, {}},
      {"strays", DataKind::table, "Stems in no row.", false, {}}};
  type.options = &option_table(static_cast<const RowOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    auto found = find_rows(inputs.table("stems"), options.as<RowOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("rows", std::move(found.rows));
    result.outputs.set("plants", std::move(found.plants));
    result.outputs.set("lines", std::move(found.lines));
    result.outputs.set("strays", std::move(found.strays));
    result.report = std::move(found.report);
    return result;
  };
  return type;
}

constexpr const char* paper = "SPEC B: plant rows from a 3-D LiDAR (Zhao et al. 2023)";

// A step that takes points and gives points.
template <class Options, class Step>
pipeline::StageType point_step(const char* name, const char* vtk_class, const char* title, const char* help,
                               Step step) {
  pipeline::StageType type;
  type.name = name;
  type.vtk_class = vtk_class;
  type.title = title;
  type.help = help;
  type.source = paper;
  type.inputs = {{"points", DataKind::cloud, "Points of a frame: y ahead, z up, origin in the sensor.", false, {}}};
  type.outputs = {{"points", DataKind::cloud, "The points after this step.", false, {}}};
  type.options = &option_table(static_cast<const Options*>(nullptr));
  type.run = [step](const DataSet& inputs, const OptionSet& options, const Run& run) {
    const auto& before = inputs.cloud("points");
    PointCloud after = step(before, options.as<Options>(), run);
    pipeline::StageResult result;
    result.report.counts["points_in"] = static_cast<std::int64_t>(before.size());
    result.report.counts["points"] = static_cast<std::int64_t>(after.size());
    result.report.message = std::to_string(after.size()) + " of " + std::to_string(before.size()) + " points";
    result.outputs.set("points", std::move(after));
    return result;
  };
  return type;
}

pipeline::StageType level_stage() {
  auto type = point_step<LevelOptions>(
      "rows.level", "vtkBoleLevelFrame", "Level a frame",
      "Turns a frame by the attitude of the sensor: Rz(yaw) Ry(pitch) Rx(roll). With a table of attitudes every "
      "point is turned by the attitude at its own time, otherwise the frame has one attitude.",
      [](const PointCloud& c, const LevelOptions& o, const Run&) { return level(c, o); });
  type.inputs.push_back({"attitude", DataKind::table, "time_s, roll_deg, pitch_deg, yaw_deg of the IMU.", true, {}});
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run&) {
    const Table* attitude = inputs.has("attitude") ? &inputs.table("attitude") : nullptr;
    pipeline::StageResult result;
    result.outputs.set("points", level(inputs.cloud("points"), options.as<LevelOptions>(), attitude));
    result.report.counts["points"] = static_cast<std::int64_t>(inputs.cloud("points").size());
    result.report.message = attitude != nullptr ? "levelled point by point" : "levelled with one attitude";
    return result;
  };
  return type;
}

pipeline::StageType trunks() {
  pipeline::StageType type;
  type.name = "rows.trunks";
  type.vtk_class = "vtkBoleFrameTrunks";
  type.title = "Find trunk centres";
  type.help =
      "Cuts every plant into horizontal layers and keeps those that are no wider than a trunk, so that leaves and "
      "branches do not move the centre. The mean of the trunk points in plan is the centre of the plant. The "
      "sensor sees one side only, so this centre lies too near by most of a radius; centre=face corrects that.";
  type.source = paper;
  type.inputs = {{"points", DataKind::cloud, "Points with the column plant.", false, {}},
                 {"dense", DataKind::cloud, "The levelled frame before it was thinned; for centre = face.", true, {}}};
  type.outputs = {{"stems", DataKind::table, "Centres: tree_id, x_m, y_m, layers, points, diameter_cm.", false, {}},
                  {"points", DataKind::cloud, "Points of the trunks, with the column plant.", false, {}}};
  type.version = 2;
  type.options = &option_table(static_cast<const TrunkOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run&) {
    pipeline::StageResult result;
    const PointCloud* dense = inputs.has("dense") ? &inputs.cloud("dense") : nullptr;
    auto found = trunk_centres(inputs.cloud("points"), dense, options.as<TrunkOptions>(), result.report);
    result.outputs.set("stems", std::move(found.stems));
    result.outputs.set("points", std::move(found.points));
    return result;
  };
  return type;
}

pipeline::StageType hedges() {
  pipeline::StageType type;
  type.name = "rows.hedges";
  type.vtk_class = "vtkBoleHedgeRows";
  type.title = "Find hedge rows";
  type.help =
      "Finds rows whose canopy hides the trunks (vines, fruit walls, hedges) as peaks of the point profile across "
      "the rows. The direction is given, or the one with the sharpest profile is taken. Along each row every "
      "piece gives a point in the middle of the canopy, and the window follows the row, so the row may bend. "
      "rows.from_stems makes rows and guidance lines of the points. The points must be canopy only: remove the "
      "ground with rows.region or rows.remove_ground.";
  type.source = "Bole";
  type.inputs = {{"points", DataKind::cloud, "Canopy without the ground, z up.", false, {}}};
  type.outputs = {{"stems", DataKind::table, "Points of the hedges' lines: row_id, x_m, y_m, points.", false, {}}};
  type.options = &option_table(static_cast<const HedgeOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    pipeline::StageResult result;
    result.outputs.set("stems", hedge_rows(inputs.cloud("points"), options.as<HedgeOptions>(), run, result.report));
    return result;
  };
  return type;
}

pipeline::StageType place() {
  pipeline::StageType type;
  type.name = "rows.place";
  type.vtk_class = "vtkBolePlaceStems";
  type.title = "Place stems on the map";
  type.help =
      "Moves plant centres from the axes of the frame to navigation axes, x east and y north, with the position "
      "and yaw of the sensor: by hand, or from rows.resect, whose standard error of the heading then counts in the "
      "directions of rows.";
  type.source = paper;
  type.inputs = {{"stems", DataKind::table, "Centres in frame axes: x_m, y_m.", false, {}},
                 {"pose", DataKind::table, "Pose of the sensor, in place of the options.", true, {}}};
  type.outputs = {{"stems", DataKind::table, "The same in navigation axes.", false, {}}};
  type.options = &option_table(static_cast<const PlaceOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run&) {
    pipeline::StageResult result;
    const Table* pose = inputs.has("pose") ? &inputs.table("pose") : nullptr;
    result.outputs.set("stems", place_stems(inputs.table("stems"), options.as<PlaceOptions>(), pose));
    result.report.message = std::to_string(inputs.table("stems").rows()) + " stems placed";
    return result;
  };
  return type;
}

pipeline::StageType resect() {
  pipeline::StageType type;
  type.name = "rows.resect";
  type.vtk_class = "vtkBoleResectSensor";
  type.title = "Resect the sensor";
  type.help =
      "Finds position and heading of the sensor from marks of known position that the frame shows, with covariance "
      "and residuals. Give the places where an antenna stood (E, F, G) and where the levelled frame shows it. Marks "
      "that were mixed up, swapped axes and weak geometry are refused with the reason.";
  type.source = paper;
  type.inputs = {{"marks",
                  DataKind::table,
                  "name, x_m, y_m, z_m (known); seen_x_m, seen_y_m, seen_z_m (frame); range_m where measured.",
                  false,
                  {}}};
  type.outputs = {{"pose", DataKind::table, "Position, yaw, standard errors and covariance.", false, {}, true},
                  {"residuals", DataKind::table, "Known minus adjusted position of each mark.", false, {}, true}};
  type.options = &option_table(static_cast<const ResectOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run&) {
    auto found = sensor_pose(inputs.table("marks"), options.as<ResectOptions>());
    pipeline::StageResult result;
    result.outputs.set("pose", std::move(found.pose));
    result.outputs.set("residuals", std::move(found.residuals));
    result.report = std::move(found.report);
    return result;
  };
  return type;
}

pipeline::StageType edit_stage() {
  pipeline::StageType t;
  t.name = "rows.edit";
  t.vtk_class = "vtkBoleEditRows";
  t.title = "Edit rows";
  t.help =
      "Applies the edits of a person: move (the ends), add, delete, split, merge, renumber and note, each with "
      "author, time and reason. The inputs do not change. The edits are kept in the pipeline and applied after "
      "every run, by place. Rows whose plants changed are measured again. An edit that no longer fits is a "
      "conflict: it changes nothing and is listed.";
  t.source = "Bole";
  t.inputs = {{"rows", DataKind::table, "Rows as found.", false, {}},
              {"plants", DataKind::table, "Plants in their rows.", false, {}},
              {"lines", DataKind::table, "Vertices of the guidance lines.", false, {}},
              {"strays", DataKind::table, "Plants in no row.", true, {}}};
  t.outputs = {{"rows", DataKind::table, "Rows after the edits; state is auto or edited.", false, {}},
               {"plants", DataKind::table, "Plants after the edits.", false, {}},
               {"lines", DataKind::table, "Guidance lines after the edits.", false, {}},
               {"strays", DataKind::table, "Plants in no row after the edits.", false, {}},
               {"log", DataKind::table, "Every edit, whether it was applied, and why not.", false, {}}};
  t.options = &option_table(static_cast<const RowEditOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& set, const Run& run) {
    const auto& options = set.as<RowEditOptions>();
    FoundRows found;
    found.rows = in.table("rows");
    found.plants = in.table("plants");
    found.lines = in.table("lines");
    if (in.has("strays")) found.strays = in.table("strays");
    auto edited = apply_row_edits(found, edits_of(options.file, options.edits, parse_row_edits), options, run);
    pipeline::StageResult result;
    result.outputs.set("rows", std::move(edited.found.rows));
    result.outputs.set("plants", std::move(edited.found.plants));
    result.outputs.set("lines", std::move(edited.found.lines));
    result.outputs.set("strays", std::move(edited.found.strays));
    result.outputs.set("log", std::move(edited.log));
    result.report = std::move(edited.found.report);
    return result;
  };
  return t;
}

void add_frame_steps(pipeline::StageRegistry& registry) {
  using namespace rows;
  registry.add(level_stage());
  registry.add(point_step<RegionOptions>(
      "rows.region", "vtkBoleFrameRegion", "Cut a region", "Keeps the points inside a box (pass-through filter).",
      [](const PointCloud& c, const RegionOptions& o, const Run&) { return cut_region(c, o); }));
  registry.add(point_step<VoxelOptions>(
      "rows.voxel", "vtkBoleVoxelGrid", "Thin by voxels", "Replaces the points of each voxel by their centroid.",
      [](const PointCloud& c, const VoxelOptions& o, const Run&) { return voxel_centroids(c, o); }));
  registry.add(point_step<RayGroundOptions>(
      "rows.remove_ground", "vtkBoleRemoveGround", "Remove the ground",
      "Removes the ground with a ray ground filter. In narrow sectors around the sensor, in order of range, a "
      "point is ground when it rises less than the local slope above the last ground point and stays within the "
      "general slope.",
      [](const PointCloud& c, const RayGroundOptions& o, const Run& run) { return remove_ground(c, o, run); }));
  registry.add(point_step<RadiusOptions>(
      "rows.radius_filter", "vtkBoleRadiusFilter", "Drop lone points",
      "Removes points that have too few neighbours within a radius.",
      [](const PointCloud& c, const RadiusOptions& o, const Run& run) { return radius_filter(c, o, run); }));
  registry.add(point_step<MeanShiftOptions>(
      "rows.mean_shift", "vtkBoleMeanShift", "Cluster into plants",
      "Mean shift in plan. Points that converge to the same place are one plant. The column plant numbers the "
      "plants; 0 is no plant.",
      [](const PointCloud& c, const MeanShiftOptions& o, const Run& run) { return mean_shift(c, o, run); }));
  registry.add(trunks());
  registry.add(resect());
  registry.add(place());
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(from_stems());
  registry.add(edit_stage());
  registry.add(hedges());
  add_frame_steps(registry);
}

}  // namespace bole::rows
