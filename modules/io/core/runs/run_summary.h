// What summary.json of a run says about how it was made.
#pragma once

#include <filesystem>
#include <string>

#include "cloud/breast_height.h"

namespace bole::io {

// Empty texts where the file does not say.
struct RunSummary {
  std::string system = "unknown";  // preset with the options of slam.run that were set, "given poses" or "cloud"
  std::string preset, scan, axes, verdict;
  std::string reference_columns, reference_rows;  // options of its evaluation
  bool poses_given = false;
  double breast_height_m = usual_breast_height_m;  // at which its stems were measured
};

// Throws Error{bad_input} for a file that is no JSON object. Entries of another kind than expected count as absent.
RunSummary read_run_summary(const std::filesystem::path& path);

}  // namespace bole::io
