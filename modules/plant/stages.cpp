// Registers the stages of the module plant.
#include "pipeline/stage.h"
#include "plant/core/field/field_cloud.h"
#include "plant/core/field/train_field.h"
#include "plant/core/surface/surface_points.h"
#include "plant/core/surface/tsdf.h"

namespace bole::plant {
namespace {

// --- surface and field -----------------------------------------------------------------------------------------------

pipeline::StageType fuse_stage() {
  pipeline::StageType t;
  t.name = "plant.fuse_depth";
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
    SurfaceMesh mesh;
    if (options.mesh) mesh = surface_mesh(grid, options.min_weight);
    result.report.counts["points"] = static_cast<std::int64_t>(points.size());
    result.report.counts["triangles"] = static_cast<std::int64_t>(mesh.triangles.rows());
    result.report.message = std::to_string(points.size()) + " surface points from " + std::to_string(posed.size()) +
                            " views";
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
      "ray is stopped, kept where several views agree. Finishing early keeps the field as it is.";
  t.source = "Mildenhall et al.: NeRF. ECCV 2020; SPEC C";
  t.inputs = {{"views", DataKind::views, "Views with colour, and depth where there is any.", false, {}},
              {"poses", DataKind::trajectory, "Pose of each view, at its time.", false, {}}};
  t.outputs = {{"points", DataKind::cloud, "Fine cloud with normals, colours and the number of views that agree.", false, {}},
               {"progress", DataKind::table, "step, loss, psnr_db (of two views kept back, thinned), seconds.", false, {}},
               {"held_out", DataKind::table, "Views kept back: view, name, psnr_db (all pixels), region_psnr_db.", false, {}}};
  t.options = &option_table(static_cast<const FieldOptions*>(nullptr));
  t.main_numbers = {"held_out_psnr_db", "points", "voxel"};
  t.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    const auto& options = set.as<FieldOptions>();
    const auto& views = inputs.views("views");
    pipeline::StageResult result;
    auto& report = result.report;
    const auto posed = posed_views(views, inputs.trajectory("poses"), 3, report);
    const auto given = region_from_text(options.region);
    const auto region = given ? *given : find_region(views, posed, options.min_share, run, report);
    auto field = train_field(views, posed, region, options, run.part(0, 0.8), report);
    auto points = field_cloud(field, options, run.part(0.8, 1), report);
    if (points.empty())
      report.find(Severity::refused, "no_points",
                  "No two views agree on a surface: check the poses, the region and the number of views.");
    result.outputs.set("points", std::move(points));
    result.outputs.set("progress", std::move(field.progress));
    result.outputs.set("held_out", std::move(field.held_out));
    return result;
  };
  return t;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(fuse_stage());
  registry.add(field_stage());
}

}  // namespace bole::plant
