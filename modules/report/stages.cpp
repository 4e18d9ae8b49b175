// Registers report.plot, report.compare, report.flythrough, report.rows, report.steering, report.sample and
// report.plant. They live in
// bole_report and not with the stages of the core modules, because they draw.
#include "pipeline/result_names.h"
#include "report/compare/compare_report.h"
#include "report/flight/flythrough.h"
#include "report/make_report.h"
#include "report/plant_report.h"
#include "report/revisit_report.h"
#include "report/rows/rows_report.h"
#include "report/sample_report.h"
#include "report/steering_report.h"
#include "report/survey_data.h"
#include "report/tile_report.h"

namespace bole::report {

namespace {

// What the reports may write, at the top of the output folder.
void register_result_names() {
  pipeline::add_result_names({"ab_lines.geojson",
                              "check.html",
                              "check.json",
                              "check_boundary.csv",
                              "check_cells.csv",
                              "chm.tif",
                              "cloud.copc.laz",
                              "cloud.las",
                              "cloud.laz",
                              "cloud.ply",
                              "compared_trees.csv",
                              "comparison.json",
                              "contours.csv",
                              "control_points.csv",
                              "dem.tif",
                              "detection.csv",
                              "diameter_classes.csv",
                              "diameters.csv",
                              "edits.csv",
                              "evidence.csv",
                              "field.json",
                              "growth.csv",
                              "growth_values.csv",
                              "figures",
                              "flythrough",
                              "flythrough.mp4",
                              "height_curve.csv",
                              "held_out.csv",
                              "internodes.csv",
                              "leaves.csv",
                              "loop_candidates.csv",
                              "loop_edits.csv",
                              "loops.csv",
                              "matches.csv",
                              "mesh.ply",
                              "odometry.csv",
                              "pairs.csv",
                              "plant.xlsx",
                              "plants.csv",
                              "plot.csv",
                              "plot.gpkg",
                              "plot_values.csv",
                              "pose_graph.csv",
                              "positions.csv",
                              "priors.csv",
                              "reference_trajectory.tum",
                              "reference_trees.csv",
                              "rejected.csv",
                              "report.html",
                              "row_matches.csv",
                              "rows.csv",
                              "rows.geojson",
                              "rows.gpkg",
                              "runs.csv",
                              "sample_plots.csv",
                              "sample_summary.csv",
                              "scene.ply",
                              "sections.csv",
                              "sensor_marks.csv",
                              "sensor_pose.csv",
                              "slope.tif",
                              "steering_errors.csv",
                              "steering_gains.csv",
                              "steering_headlands.csv",
                              "steering_lines.csv",
                              "steering_log.csv",
                              "steering_passes.csv",
                              "steering_summary.csv",
                              "steering_tuning.csv",
                              "stem.csv",
                              "stem_curves.vtp",
                              "stems.csv",
                              "stems.geojson",
                              "stems.obj",
                              "stems.ply",
                              "stems.vtp",
                              "stems_global.vtp",
                              "strays.csv",
                              "survey.xlsx",
                              "tally.html",
                              "tracking.csv",
                              "traits.csv",
                              "trajectories.csv",
                              "trajectory.tum",
                              "trajectory_global.csv",
                              "tree_values.csv"});
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  if (!registry.first_time("report")) return;
  register_result_names();
  pipeline::StageType type;
  type.name = "report.plot";
  type.vtk_class = "vtkBolePlotReport";
  type.version = 6;
  type.title = "Write the report";
  type.help =
      "Writes what a survey has found into the output folder: stems.csv and the other tables, plot.csv with the "
      "boundary, "
      "reference_trees.csv and reference_trajectory.tum that it was compared with, survey.xlsx, "
      "trajectory.tum, plot_values.csv, diameter_classes.csv, height_curve.csv, tree_values.csv, loops.csv, "
      "odometry.csv, loop_candidates.csv, pose_graph.csv, cloud.laz, "
      "dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, trajectory_global.csv and stems_global.vtp where the "
      "plot "
      "was georeferenced, check.json and check.html with the check of the map, the "
      "stems as solids (OBJ, PLY, VTP), the figures, tally.html to take into the plot, and report.html, one page that "
      "holds everything: what was surveyed and whether it may be signed, values of the plot, trees to look at, the "
      "stem "
      "table with plan, slices and a 3-D view, figures, comparison with a reference, and how it was made with every "
      "option and the time and memory of each stage. Inputs that are not connected are left out.";
  type.source = "Bole";
  type.inputs = survey_ports();
  type.options = &option_table(static_cast<const ReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return make_report(inputs, options.as<ReportOptions>(), run);
  };
  registry.add(std::move(type));
  registry.add(rows_report_stage());
  registry.add(revisit_report_stage());
  registry.add(steering_report_stage());
  registry.add(sample_report_stage());
  registry.add(plant_report_stage());
  registry.add(compare_report_stage());
  registry.add(tile_report_stage());
  registry.add(flythrough_stage());
}

}  // namespace bole::report
