// Registers report.plot, report.rows and report.steering. They live in bole_report and not with the stages of the core
// modules, because they draw.
#include "report/make_report.h"
#include "report/rows_report.h"
#include "report/steering_report.h"

namespace bole::report {

void register_stages(pipeline::StageRegistry& registry) {
  if (!registry.first_time("report")) return;
  pipeline::StageType type;
  type.name = "report.plot";
  type.vtk_class = "vtkBolePlotReport";
  type.version = 2;
  type.title = "Write the report";
  type.help =
      "Writes what a survey has found into the output folder: stems.csv and the other tables, survey.xlsx, "
      "trajectory.tum, loops.csv, odometry.csv, cloud.las, dem.tif, slope.tif, chm.tif, plot.gpkg, stems.geojson, the "
      "stems as solids (OBJ, PLY, VTP), figures as PNG, SVG and PDF, and report.html, one page that holds everything: "
      "values of the plot, trees to check, figures, comparison with a reference, the stem table, and how it was made "
      "with every option and the time and memory of each stage. Inputs that are not connected are left out.";
  type.source = "Bole";
  type.inputs = {{"stems", DataKind::table, "Stems with x_m, y_m and dbh_cm.", false, {}},
                 {"plot", DataKind::table, "Which trees count, from survey.plot; all of them when absent.", true, {}},
                 {"points",
                  DataKind::cloud,
                  "The map, coloured by height_above_ground, intensity and tree_id where it has them.",
                  true,
                  {}},
                 {"slice", DataKind::cloud, "Points around breast height, for the slice sheet.", true, {}},
                 {"dem", DataKind::raster, "Terrain model.", true, {}},
                 {"slope", DataKind::raster, "Slope of the terrain.", true, {}},
                 {"canopy", DataKind::raster, "Canopy height model.", true, {}},
                 {"trajectory", DataKind::trajectory, "The walk of the scanner.", true, {}},
                 {"reference_trajectory", DataKind::trajectory, "The true walk, in the same axes.", true, {}},
                 {"sections", DataKind::table, "Fitted cross-sections.", true, {}},
                 {"rejected", DataKind::table, "Candidates that are no stems, with their reasons.", true, {}},
                 {"edits", DataKind::table, "What a person changed, from stems.edit.", true, {}},
                 {"targets", DataKind::table, "Reflective targets of the plot frame.", true, {}},
                 {"matches", DataKind::table, "Stems matched with a reference.", true, {}},
                 {"summary", DataKind::table, "Measures of the evaluation beside published ones.", true, {}},
                 {"loops", DataKind::table, "Revisits of the walk, from slam.run.", true, {}},
                 {"odometry", DataKind::table, "What slam.run found for each frame.", true, {}}};
  type.options = &option_table(static_cast<const ReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return make_report(inputs, options.as<ReportOptions>(), run);
  };
  registry.add(std::move(type));
  registry.add(rows_report_stage());
  registry.add(steering_report_stage());
}

}  // namespace bole::report
