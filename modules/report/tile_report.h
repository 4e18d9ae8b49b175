// The work of the stage report.tile.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct TileReportOptions {
  std::string core;  // xmin,ymin,xmax,ymax; empty: everything
  bool cloud = true;
};

const OptionTable& option_table(const TileReportOptions*);

// Writes what is connected into run.output_dir: stems.csv, sections.csv, rejected.csv, evidence.csv, priors.csv and
// plot.gpkg of all rows, dem.tif of the cells whose centre lies in the core, cloud.laz of the points in it. The core is
// half open: what lies on its upper edges belongs to the next tile. Throws Error{bad_input}, Error{cancelled}.
pipeline::StageResult write_tile_report(const DataSet& inputs, const TileReportOptions& options, const Run& run);

pipeline::StageType tile_report_stage();

}  // namespace bole::report
