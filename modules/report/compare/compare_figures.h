// The figures of a comparison of runs, those of the paper on improved LOAM: paths on the cloud (figure 8), slices side
// by side (9), positions (10), position errors (11), diameters (12) and their errors by class (13); and that of the
// paper on orchard mapping: path and map with their loop closures (4).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/table.h"
#include "render/draw/figure.h"
#include "report/compare/compare_report.h"

namespace bole::report {

// Inputs of report.compare; those from `poses` on may be null.
struct CompareData {
  const Table* runs = nullptr;
  const Table* compared = nullptr;
  const Table* trees = nullptr;
  const Table* stems = nullptr;
  const Table* poses = nullptr;
  const Table* boundaries = nullptr;
  const Table* reference_poses = nullptr;
  const Table* loops = nullptr;
  const Table* groups = nullptr;
};

struct ComparePlan {
  std::string what;  // for messages
  std::function<std::vector<render::Figure>()> make;
};

// Pooled figures first, then those of each plot. Figures of one plot have its number at the end of their name where
// there are several. Runs are the series where there is one plot, systems where there are more.
std::vector<ComparePlan> compare_figures(const CompareData& data, const CompareReportOptions& options, const Run& run);

}  // namespace bole::report
