// The boundary of a plot and its minimum diameter as a file (plot.csv).
#pragma once

#include <filesystem>

#include "cloud/plot_area.h"

namespace bole::io {

// A row for each vertex of the outline (x_m, y_m; one row without them where there is no boundary). Every row repeats
// shape, centre_x_m, centre_y_m, width_m, length_m, bearing_deg and min_dbh_cm.
void write_plot(const std::filesystem::path& path, const CountingRule& rule);

// Throws Error{bad_input} for a table that write_plot() did not write.
CountingRule read_plot(const std::filesystem::path& path);

}  // namespace bole::io
