// What loop closures did to the paths and maps of runs of one plot.
#pragma once

#include <vector>

#include "cloud/trajectory.h"
#include "render/draw/color.h"
#include "report/compare/compare_figures.h"

namespace bole::report {

struct ComparedRunPath {
  std::size_t run = 0;  // row of the table of runs
  render::Color color;
  Trajectory path;
};

bool any_loops(const CompareData& data, const std::vector<std::size_t>& runs);

// The first four runs below each other. `reference` may be empty. `common_axes`: the paths and clouds are in the axes
// of one plot; else each is aligned with the reference, or with the first run where there is none. Reads of each cloud
// the part that is drawn. Needs two paths.
render::Figure loop_figure(const CompareData& data, std::vector<ComparedRunPath> paths, const Trajectory& reference,
                           bool common_axes, double width_mm, const Run& run);

}  // namespace bole::report
