// Folders that `bole run` and `bole survey` wrote, read to be compared.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"

namespace bole::io {

struct RunFolderOptions {
  std::string folders, names, systems, plots;  // lists with commas
};
const OptionTable& option_table(const RunFolderOptions*);

struct RunFolders {
  // A row per run: run (1, 2, ...), name, system, plot, folder, scan, preset, poses_given (0, 1), axes, verdict, stems,
  // poses, loops (closures), has_plot (0, 1), shape, centre_x_m, centre_y_m, width_m, length_m, bearing_rad,
  // min_dbh_cm, breast_height_m, reference (where its trees come from: "reference_trees.csv", "matches.csv"; empty),
  // reference_columns, reference_rows, cloud (path, or empty).
  Table runs;
  Table stems;            // of all, with a column `run`
  Table poses;            // run, time_s, x_m, y_m, z_m, qx, qy, qz, qw
  Table boundaries;       // run, x_m, y_m: vertices of the plots
  Table loops;            // run, from_time_s, to_time_s: the loop closures of each run
  Table reference_stems;  // run, and the columns of the reference lists
  Table reference_poses;  // as `poses`
  Report report;
};

// A folder needs stems.csv. What else is missing or damaged becomes a finding. `system` is the preset of slam.run with
// the options that were set beside it, "given poses" or "cloud"; `plot` stays empty where the option does not name it.
// Throws Error{bad_input} for no folder, one without stems.csv, one that is named twice, and lists of names of another
// length.
RunFolders read_run_folders(const RunFolderOptions& options, const Run& run);

}  // namespace bole::io
