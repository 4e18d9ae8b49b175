// Registers the stages of the module ground.
#include "cloud/core/height_facts.h"
#include "cloud/core/regions/point_edits.h"
#include "ground/core/given_ground.h"
#include "ground/core/model_ground.h"
#include "ground/core/rasters.h"
#include "pipeline/stage.h"

namespace bole::ground {
namespace {

GroundModel model_of(const DataSet& inputs, const GroundOptions& options, const Run& run) {
  const PointCloud& cloud = inputs.cloud("points");
  const Raster* terrain = inputs.has("terrain") ? &inputs.raster("terrain") : nullptr;
  if (inputs.has("point_edits")) {
    const auto given = given_classes(cloud, point_edits_in(inputs.table("point_edits")), run);
    if (!given.empty()) return model_edited_ground(cloud, given, terrain, options, run);
  }
  return terrain != nullptr ? ground_of(cloud, *terrain, options, run) : model_ground(cloud, options, run);
}

pipeline::StageResult run_model(const DataSet& inputs, const OptionSet& options, const Run& run) {
  const PointCloud& cloud = inputs.cloud("points");
  auto model = model_of(inputs, options.as<GroundOptions>(), run);
  PointCloud points = cloud;
  points.set_column(arrays::height_above_ground, std::move(model.height_above_ground));
  points.set_column(arrays::classification, std::move(model.classification));
  set_fact(points.facts, facts::terrain, choice_name(model.source));
  pipeline::StageResult result;
  result.outputs.set("slope", slope_deg(model.dem));
  result.outputs.set("canopy", canopy_height(points, model.dem, model.dem.cell_m, run));
  result.outputs.set("points", std::move(points));
  result.outputs.set("dem", std::move(model.dem));
  result.outputs.set("dem_filled", std::move(model.filled));
  result.report = std::move(model.report);
  return result;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "ground.model";
  type.vtk_class = "vtkBoleGroundModel";
  type.title = "Model the ground";
  type.help =
      "Separates ground from vegetation, makes a terrain model (DEM) and gives every point its height above it. The "
      "lowest "
      "groups of points of small cells are taken into a triangulation step by step; "
      "then a robust plane is fitted to the band of ground points around each cell, so that the model runs through the "
      "middle of the band and not along its lower edge or the top of the grass. "
      "Cells without ground points are interpolated and marked in dem_filled; further than fill_distance from any "
      "ground point the model has no value and points there have no height (NaN). Where a terrain is connected, "
      "heights are "
      "counted from that.";
  type.source =
      "Progressive TIN densification: P. Axelsson, DEM generation from laser scanner data using adaptive TIN models, "
      "IAPRS XXXIII B4/1, 2000; local fit: Bole";
  type.inputs = {{"points", DataKind::cloud, "A cloud whose z axis points up.", false, {}},
                 {"terrain",
                  DataKind::raster,
                  "A terrain model that was made before: heights are counted from it, and none is made.",
                  true,
                  {}},
                 {"point_edits",
                  DataKind::table,
                  "Points that a person gave to the ground or to noise, from survey.edit_points.",
                  true,
                  {}}};
  type.outputs = {
      {"points",
       DataKind::cloud,
       "The same points with heights and classes.",
       false,
       {arrays::height_above_ground, arrays::classification}},
      {"dem", DataKind::raster, "Terrain height per cell.", false, {}},
      {"dem_filled", DataKind::raster, "1 where the terrain model was filled, 0 where ground points were.", false, {}},
      {"slope", DataKind::raster, "Slope of the terrain in degrees.", false, {}},
      {"canopy", DataKind::raster, "Highest point above ground per cell.", false, {}}};
  type.options = &option_table(static_cast<const GroundOptions*>(nullptr));
  type.run = run_model;
  registry.add(std::move(type));
}

}  // namespace bole::ground
