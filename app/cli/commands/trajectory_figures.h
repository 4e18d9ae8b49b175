// Figures of `bole evaluate trajectory`. A build without rendering refuses with a hint.
#pragma once

#include <string>

#include "cloud/table.h"
#include "cloud/trajectory.h"

namespace bole::cli {

// `estimate` in the axes of the reference; `loops` may be null. Writes one sheet to `figure_file` (svg, pdf, png by its
// ending) and each figure as SVG and PNG into `folder`; an empty path is left out. Throws Error{bad_input}.
void draw_trajectories(const Trajectory& estimate, const Trajectory& reference, const Table* loops,
                       const std::string& figure_file, const std::string& folder);

}  // namespace bole::cli
