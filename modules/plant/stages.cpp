// Registers the stages of the module plant.
#include "pipeline/stage.h"
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

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(fuse_stage());
}

}  // namespace bole::plant
