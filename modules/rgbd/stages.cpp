// Registers the stages of the module rgbd.
#include "pipeline/stage.h"
#include "rgbd/core/poses/estimate_poses.h"

namespace bole::rgbd {
namespace {

pipeline::StageType estimate_poses_stage() {
  pipeline::StageType type;
  type.name = "rgbd.estimate_poses";
  type.vtk_class = "vtkBoleEstimateViewPoses";
  type.title = "Estimate camera poses";
  type.help =
      "Finds the pose of the camera for every view. Features are matched with neighbouring views and around loops, and "
      "screened by ratio, by their neighbours' motion and by depth. Bundle adjustment fits poses and points to pixels, "
      "depths and the corners of a ChArUco board, which gives axes and scale. Without a board the axes are those of "
      "the "
      "first view and the scale is that of the depth. Views that cannot be connected are reported as lost.";
  type.source = "SPEC C; SIFT: Lowe 2004; GMS: Bian et al. 2017; bundle adjustment with depth: Bole";
  type.inputs = {{"views", DataKind::views, "Colour and depth images with their camera.", false, {}},
                 {"given", DataKind::trajectory, "Poses at the times of the views, for source=given.", true, {}}};
  type.outputs = {{"poses", DataKind::trajectory, "T_world_camera of every view that was tracked.", false, {}},
                  {"points",
                   DataKind::cloud,
                   "Sparse points that several views see, with colours.",
                   false,
                   {arrays::red, arrays::green, arrays::blue}},
                  {"matches", DataKind::table, "Matches of a few pairs with what became of each.", false, {}},
                  {"tracking", DataKind::table, "One row per view: state, matches, residuals.", false, {}}};
  type.main_numbers = {"tracked", "lost", "residual_px"};
  type.options = &option_table(static_cast<const PoseOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    const Trajectory* given = inputs.has("given") ? &inputs.trajectory("given") : nullptr;
    auto found = estimate_poses(inputs.views("views"), given, options.as<PoseOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("poses", std::move(found.poses));
    result.outputs.set("points", std::move(found.points));
    result.outputs.set("matches", std::move(found.matches));
    result.outputs.set("tracking", std::move(found.tracking));
    result.report = std::move(found.report);
    return result;
  };
  return type;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) { registry.add(estimate_poses_stage()); }

}  // namespace bole::rgbd
