// Registers the stages of the module rgbd.
#include "base/atomic_file.h"
#include "pipeline/result_names.h"
#include "pipeline/stage.h"
#include "rgbd/core/calibration/calibrate.h"
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

pipeline::StageType calibrate_stage() {
  pipeline::StageType type;
  type.name = "rgbd.calibrate";
  type.vtk_class = "vtkBoleCalibrateCamera";
  type.title = "Calibrate a camera";
  type.help =
      "Fits focal lengths, principal point and distortion to pictures of a chessboard or a ChArUco board (Zhang's "
      "method). Views that do not fit the others are left out. Depth images of the same views give the place of the "
      "depth camera and the bias of its depth, by the planes of the board; pictures of the depth camera (infrared) "
      "give "
      "its intrinsics too. Writes camera.json, which io.read_views takes, and residuals.svg.";
  type.source = "Zhang 2000; OpenCV calib3d; depth by planes of the board: Bole";
  type.inputs = {
      {"views", DataKind::views, "Pictures of the board; with depth, the depth is calibrated too.", true, {}},
      {"infrared", DataKind::views, "Pictures of the depth camera at the times of the views.", true, {}},
      {"corners",
       DataKind::table,
       "Corners found elsewhere, in place of views: view, x_px, y_px, board_x_m, board_y_m.",
       true,
       {}}};
  type.outputs = {
      {"camera", DataKind::table, "Parameters with standard deviations and 95 % intervals.", false, {}, true},
      {"residuals", DataKind::table, "One row per view: corners, residual, distance, tilt, state.", false, {}, true}};
  type.main_numbers = {"residual", "views_used"};
  type.options = &option_table(static_cast<const CalibrationOptions*>(nullptr));
  type.writes_files = true;
  pipeline::add_result_names({"camera.json", "residuals.svg"});
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    CalibrationInput input;
    if (inputs.has("views")) input.views = &inputs.views("views");
    if (inputs.has("infrared")) input.infrared = &inputs.views("infrared");
    if (inputs.has("corners")) input.corners = &inputs.table("corners");
    auto found = calibrate(input, options.as<CalibrationOptions>(), run);
    if (!run.output_dir.empty()) {
      write_text_file(run.output_dir / "camera.json", found.camera_json);
      write_text_file(run.output_dir / "residuals.svg", found.residual_picture);
    }
    pipeline::StageResult result;
    result.outputs.set("camera", std::move(found.parameters));
    result.outputs.set("residuals", std::move(found.residuals));
    result.report = std::move(found.report);
    return result;
  };
  return type;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(estimate_poses_stage());
  registry.add(calibrate_stage());
}

}  // namespace bole::rgbd
