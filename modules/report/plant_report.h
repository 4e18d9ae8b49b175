// The work of the stage report.plant.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct PlantReportOptions {
  bool figures = true;
  bool scene = true;
  double figure_width = 180;
  double dpi = 300;
};

const OptionTable& option_table(const PlantReportOptions*);

// Writes traits.csv, the other tables, trajectory.tum, cloud.ply, scene.ply, field.json, plant.xlsx, figures and
// report.html into run.output_dir. What cannot be written becomes a warning. Throws Error{bad_input} without an output
// folder or where nothing is connected, Error{cancelled}.
pipeline::StageResult write_plant_report(const DataSet& inputs, const PlantReportOptions& options, const Run& run);

pipeline::StageType plant_report_stage();

}  // namespace bole::report
