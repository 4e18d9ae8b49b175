// Registers the stages of the module plant.
#include "pipeline/stage.h"
#include "plant/core/edits/apply_plant_edits.h"
#include "plant/core/field/build_space.h"
#include "plant/core/field/field_cloud.h"
#include "plant/core/field/field_store.h"
#include "plant/core/field/render_view.h"
#include "plant/core/mvs/match_views.h"
#include "plant/core/separate/separate.h"
#include "plant/core/surface/surface_points.h"
#include "plant/core/surface/tsdf.h"
#include "plant/core/training/train_field.h"
#include "plant/core/traits/traits.h"

namespace bole::plant {
namespace {

// ---- surface and field ----

pipeline::StageType fuse_stage() {
  pipeline::StageType t;
  t.name = "plant.fuse_depth";
  t.version = 2;
  t.vtk_class = "vtkBoleFuseDepth";
  t.title = "Fuse depth images";
  t.help =
      "Fuses the depth images of all views into truncated signed distances on small voxels, and gives the surface as "
      "coloured points with normals, and as a mesh where asked. The region is found from the views. This is the start "
      "of plant.field, and the baseline to compare it with.";
  t.source = "Curless, Levoy: A volumetric method for building complex models from range images. SIGGRAPH 1996";
  t.inputs = {{"views", DataKind::views, "Views with depth.", false, {}},
              {"poses", DataKind::trajectory, "Pose of each view, at its time.", false, {}}};
  t.outputs = {{"points", DataKind::cloud, "Surface with normals and colours.", false, {}},
               {"vertices", DataKind::cloud, "Vertices of the mesh; empty unless asked for.", false, {}},
               {"triangles", DataKind::table, "Rows of the three vertices of each triangle: a, b, c.", false, {}}};
  t.options = &option_table(static_cast<const FuseOptions*>(nullptr));
  t.main_numbers = {"points", "voxel"};
  t.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    const auto& options = set.as<FuseOptions>();
    const auto& views = inputs.views("views");
    pipeline::StageResult result;
    const auto posed = posed_views(views, inputs.trajectory("poses"), 1, result.report);
    const auto given = region_from_text(options.region);
    const auto region = given ? *given : find_region(views, posed, options.min_share, run, result.report);
    const auto grid = fuse_depth(views, posed, region, options, run, result.report);
    auto points = surface_points(grid, options.min_weight);
    if (points.empty())
      result.report.find(Severity::refused, "no_surface",
                         "The depth images show no surface in the region: check the poses and the depth scale.");
    points.facts[std::string(region_fact)] = text_of(region);
    SurfaceMesh mesh;
    if (options.mesh) mesh = surface_mesh(grid, options.min_weight);
    result.report.counts["points"] = static_cast<std::int64_t>(points.size());
    result.report.counts["triangles"] = static_cast<std::int64_t>(mesh.triangles.rows());
    result.report.message =
        std::to_string(points.size()) + " surface points from " + std::to_string(posed.size()) + " views";
    result.outputs.set("points", std::move(points));
    result.outputs.set("vertices", std::move(mesh.vertices));
    result.outputs.set("triangles", std::move(mesh.triangles));
    return result;
  };
  return t;
}

pipeline::StageType field_stage() {
  pipeline::StageType t;
  t.name = "plant.field";
  t.vtk_class = "vtkBolePlantField";
  t.title = "Train a radiance field";
  t.help =
      "Learns density and colour of the plant from the colour and depth of all views by volume rendering, tests the "
      "field on views that were kept back, and makes a fine coloured cloud of it: points where half of the light of a "
      "ray is stopped, kept where several views agree. Finishing early keeps the best field so far.";
  t.source = "Mildenhall et al.: NeRF. ECCV 2020; SPEC C";
  t.inputs = {{"views", DataKind::views, "Views with colour, and depth where there is any.", false, {}},
              {"poses", DataKind::trajectory, "Pose of each view, at its time.", false, {}}};
  t.outputs = {
      {"points", DataKind::cloud, "Fine cloud with normals, colours and the number of views that agree.", false, {}},
      {"progress", DataKind::table, "step, loss, psnr_db (of two views kept back, thinned), seconds.", false, {}},
      {"field",
       DataKind::table,
       "The field itself, column value; plant.render_view shows it from anywhere.",
       false,
       {}},
      {"poses", DataKind::trajectory, "Poses of the views, refined where asked for.", false, {}},
      {"held_out", DataKind::table, "Views kept back: view, name, psnr_db (all pixels), psnr_region_db.", false, {}}};
  t.options = &option_table(static_cast<const FieldOptions*>(nullptr));
  t.main_numbers = {"held_out_psnr_db", "points", "voxel"};
  t.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    const auto& options = set.as<FieldOptions>();
    const auto& views = inputs.views("views");
    pipeline::StageResult result;
    auto& report = result.report;
    const auto posed = posed_views(views, inputs.trajectory("poses"), 3, report);
    const auto region = field_region(views, posed, options, run, report);
    auto field = train_field(views, posed, region, options, run.part(0, 0.8), report);
    auto points = field_cloud(field, options, run.part(0.8, 1), report);
    if (points.empty())
      report.find(Severity::refused, "no_points",
                  "No two views agree on a surface: check the poses, the region and the number of views.");
    points.facts[std::string(region_fact)] = text_of(region);
    result.outputs.set("points", std::move(points));
    result.outputs.set("field", store_field(field.model, field.views.front()));
    field.poses.axes = inputs.trajectory("poses").axes;
    field.poses.facts = inputs.trajectory("poses").facts;
    result.outputs.set("poses", std::move(field.poses));
    result.outputs.set("progress", std::move(field.progress));
    result.outputs.set("held_out", std::move(field.held_out));
    return result;
  };
  return t;
}

pipeline::StageType render_stage() {
  pipeline::StageType t;
  t.name = "plant.render_view";
  t.vtk_class = "vtkBoleRenderPlantView";
  t.title = "Render a view of a field";
  t.help =
      "Renders a trained field from a pose: one of the poses connected, or that of the first view. Gives colours (0 to "
      "1) and depth as rasters whose rows run upwards.";
  t.source = "Bole";
  t.inputs = {{"field", DataKind::table, "Output field of plant.field.", false, {}},
              {"poses", DataKind::trajectory, "Poses to choose from.", true, {}}};
  t.outputs = {
      {"red", DataKind::raster, "Red, 0 to 1.", false, {}},
      {"green", DataKind::raster, "Green, 0 to 1.", false, {}},
      {"blue", DataKind::raster, "Blue, 0 to 1.", false, {}},
      {"depth", DataKind::raster, "Depth along the axis of the camera; no value where light passes.", false, {}}};
  t.options = &option_table(static_cast<const RenderOptions*>(nullptr));
  t.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    const Trajectory* poses = inputs.has("poses") ? &inputs.trajectory("poses") : nullptr;
    auto view = render_view(inputs.table("field"), poses, set.as<RenderOptions>(), run);
    pipeline::StageResult result;
    result.report.message = std::to_string(view.depth.nx) + " x " + std::to_string(view.depth.ny) + " pixels";
    result.outputs.set("red", std::move(view.red));
    result.outputs.set("green", std::move(view.green));
    result.outputs.set("blue", std::move(view.blue));
    result.outputs.set("depth", std::move(view.depth));
    return result;
  };
  return t;
}

pipeline::StageType match_stage() {
  pipeline::StageType t;
  t.name = "plant.match_views";
  t.vtk_class = "vtkBoleMatchViews";
  t.title = "Match views (multi-view stereo)";
  t.help =
      "Finds the depth of each view from its colour and that of its neighbours by PatchMatch stereo, and keeps the "
      "points "
      "on which several views agree. This is the baseline without a depth camera and without a field.";
  t.source =
      "Bleyer et al.: PatchMatch stereo. BMVC 2011; Galliani et al.: Massively parallel multiview stereopsis. ICCV "
      "2015";
  t.inputs = {{"views", DataKind::views, "Views with colour.", false, {}},
              {"poses", DataKind::trajectory, "Pose of each view, at its time.", false, {}}};
  t.outputs = {
      {"points", DataKind::cloud, "Points with normals, colours and the number of views that agree.", false, {}}};
  t.options = &option_table(static_cast<const MatchOptions*>(nullptr));
  t.main_numbers = {"points"};
  t.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    pipeline::StageResult result;
    const auto& views = inputs.views("views");
    const auto posed = posed_views(views, inputs.trajectory("poses"), 3, result.report);
    auto points = match_views(views, posed, set.as<MatchOptions>(), run, result.report);
    result.report.message = std::to_string(points.size()) + " points from " + std::to_string(posed.size()) + " views";
    result.outputs.set("points", std::move(points));
    return result;
  };
  return t;
}

void add_field_stages(pipeline::StageRegistry& registry) {
  registry.add(fuse_stage());
  registry.add(field_stage());
  registry.add(render_stage());
  registry.add(match_stage());
}

// ---- parts and traits ----

pipeline::StageType separate_stage() {
  pipeline::StageType t;
  t.name = "plant.separate";
  t.vtk_class = "vtkBoleSeparatePlant";
  t.title = "Separate the plant";
  t.help =
      "Divides the cloud of a potted plant into plant, pot, soil, mat and floaters. The table is the lowest level "
      "surface, the pot a body of revolution on it, the soil the surface inside of its rim; the plant is what grows "
      "out "
      "of the soil, with the parts that a gap separates from it.";
  t.source = "Bole";
  t.inputs = {
      {"points", DataKind::cloud, "Coloured cloud in world axes.", false, {}},
      {"views", DataKind::views, "Views that the cloud was made from: tell whether the scale is known.", true, {}},
      {"poses", DataKind::trajectory, "Poses of the views: tell which way is up.", true, {}},
      {"depth_surface", DataKind::cloud, "Surface of the fused depth images: tells where the soil is.", true, {}}};
  t.outputs = {{"points",
                DataKind::cloud,
                "The points with `part`: 0 other, 1 plant, 2 pot, 3 soil, 4 mat, 5 floater. Facts hold the soil, the "
                "foot of the stem and the pot.",
                false,
                {}}};
  t.options = &option_table(static_cast<const SeparateOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    const bool depth = in.has("views") && in.views("views").has_depth();
    const Trajectory* poses = in.has("poses") ? &in.trajectory("poses") : nullptr;
    auto separated = separate(in.cloud("points"), poses, depth, options.as<SeparateOptions>(), run,
                              in.has("depth_surface") ? &in.cloud("depth_surface") : nullptr);
    pipeline::StageResult result;
    result.outputs.set("points", std::move(separated.points));
    result.report = std::move(separated.report);
    return result;
  };
  return t;
}

pipeline::StageType traits_stage() {
  pipeline::StageType t;
  t.name = "plant.traits";
  t.vtk_class = "vtkBolePlantTraits";
  t.title = "Measure the plant";
  t.help =
      "Measures height, breadth and stem of a separated plant, each with a 95 % interval. Height is the highest point "
      "above the soil at the stem, breadth the rectangle of least area around the plant in plan; both are corrected "
      "for "
      "the noise of the points. The diameter of the stem comes from its edges in the pictures: a tapered, bowed "
      "cylinder "
      "is fitted to them, with the point spread of each picture. Leaves, internodes, branches and the whole main stem "
      "are followed in the points from the foot upwards; leaves that touch or are hidden are marked for a check.";
  t.source = "Noise of extents: Cook and Stefanski (1994), JASA 89 (simulation extrapolation); otherwise Bole";
  t.inputs = {{"points", DataKind::cloud, "Points of plant.separate.", false, {}},
              {"views", DataKind::views, "Pictures for the stem; without them the cloud must do.", true, {}},
              {"poses", DataKind::trajectory, "Poses of the views in the axes of the points.", true, {}}};
  t.outputs = {{"traits", DataKind::table, "One row: the traits with their intervals.", false, {}},
               {"stem", DataKind::table, "Sections of the stem.", false, {}},
               {"leaves", DataKind::table, "One row per leaf.", false, {}},
               {"internodes", DataKind::table, "One row per internode.", false, {}},
               {"branches", DataKind::table, "One row per branch.", false, {}},
               {"contours", DataKind::table, "Edges of the stem in the pictures.", false, {}}};
  t.options = &option_table(static_cast<const TraitOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& options, const Run& run) {
    TraitInputs inputs;
    inputs.points = &in.cloud("points");
    if (in.has("views")) inputs.views = &in.views("views");
    if (in.has("poses")) inputs.poses = &in.trajectory("poses");
    auto traits = measure_traits(inputs, options.as<TraitOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("traits", std::move(traits.traits));
    result.outputs.set("stem", std::move(traits.stem));
    result.outputs.set("leaves", std::move(traits.leaves));
    result.outputs.set("internodes", std::move(traits.internodes));
    result.outputs.set("branches", std::move(traits.branches));
    result.outputs.set("contours", std::move(traits.contours));
    result.report = std::move(traits.report);
    return result;
  };
  return t;
}

pipeline::StageType plant_edit_stage() {
  pipeline::StageType t;
  t.name = "plant.edit";
  t.vtk_class = "vtkBoleEditPlant";
  t.title = "Edit the plant";
  t.help =
      "Applies the edits of a person to a measured plant: set_base, set_stem_height, assign (points near a place, "
      "in a box or behind an outline become another part, for instance a leaf that is cut off), set_value, accept, "
      "reject and note. The plant is measured "
      "anew where its points, its base or the height of measurement changed. The inputs do not change; an edit that no "
      "longer fits is a conflict, which changes nothing and is listed.";
  t.source = "Bole";
  t.inputs = {{"points", DataKind::cloud, "Points of plant.separate.", false, {}},
              {"traits", DataKind::table, "Traits of plant.traits.", false, {}},
              {"stem", DataKind::table, "Sections of the stem.", true, {}},
              {"leaves", DataKind::table, "Leaves.", true, {}},
              {"internodes", DataKind::table, "Internodes.", true, {}},
              {"branches", DataKind::table, "Branches.", true, {}},
              {"contours", DataKind::table, "Edges of the stem in the pictures.", true, {}},
              {"views", DataKind::views, "The views that the traits were measured with.", true, {}},
              {"poses", DataKind::trajectory, "Their poses.", true, {}}};
  t.outputs = {{"points", DataKind::cloud, "Points after the edits.", false, {}},
               {"traits", DataKind::table, "Traits after the edits; state is edited, accepted or rejected.", false, {}},
               {"stem", DataKind::table, "Sections of the stem.", false, {}},
               {"leaves", DataKind::table, "Leaves.", false, {}},
               {"internodes", DataKind::table, "Internodes.", false, {}},
               {"branches", DataKind::table, "Branches.", false, {}},
               {"contours", DataKind::table, "Edges of the stem in the pictures.", false, {}},
               {"log", DataKind::table, "Every edit, whether it was applied, and why not.", false, {}}};
  t.options = &option_table(static_cast<const PlantEditOptions*>(nullptr));
  t.run = [](const DataSet& in, const OptionSet& set, const Run& run) {
    const auto& options = set.as<PlantEditOptions>();
    const auto table = [&](const char* port) { return in.has(port) ? &in.table(port) : nullptr; };
    PlantEditInputs inputs{&in.cloud("points"), &in.table("traits"), table("stem"), table("leaves"),
                           table("internodes"), table("contours"),   nullptr,       nullptr};
    if (in.has("views")) inputs.views = &in.views("views");
    if (in.has("poses")) inputs.poses = &in.trajectory("poses");
    inputs.branches = table("branches");
    auto edited = apply_plant_edits(inputs, edits_of(options.file, options.edits, parse_plant_edits), run);
    pipeline::StageResult result;
    result.outputs.set("points", std::move(edited.points));
    result.outputs.set("traits", std::move(edited.traits.traits));
    result.outputs.set("stem", std::move(edited.traits.stem));
    result.outputs.set("leaves", std::move(edited.traits.leaves));
    result.outputs.set("internodes", std::move(edited.traits.internodes));
    result.outputs.set("branches", std::move(edited.traits.branches));
    result.outputs.set("contours", std::move(edited.traits.contours));
    result.outputs.set("log", std::move(edited.log));
    result.report = std::move(edited.traits.report);
    return result;
  };
  return t;
}

void add_trait_stages(pipeline::StageRegistry& registry) {
  registry.add(separate_stage());
  registry.add(traits_stage());
  registry.add(plant_edit_stage());
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  add_field_stages(registry);
  add_trait_stages(registry);
}

}  // namespace bole::plant
