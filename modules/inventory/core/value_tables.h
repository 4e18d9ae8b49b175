// Plot values as tables: what summary.json, the workbook, the report and Python show.
#pragma once

#include "cloud/table.h"
#include "inventory/core/plot_values.h"

namespace bole::inventory {

// A row per measure, always the same rows in the same order: measure, value, unit, and of the 95 % interval lo, hi
// (as measured), half (its half width) and sampled_half (the half width as a sample of a stand of trees at random).
// NaN where a number cannot be given. Fact class_width_cm: the width of the diameter classes.
Table plot_value_table(const PlotValues& values, const PlotValueOptions& options);

// min_dbh_cm, max_dbh_cm, stems, stems_per_ha, basal_area_m2, basal_area_m2_per_ha, mean_height_m; thin classes first.
Table class_table(const PlotValues& values);

// One row: breast_height_m, a, b, rmse_m, trees, min_dbh_cm, max_dbh_cm. No row where no curve was fitted or too few
// tops were seen.
Table height_curve_table(const PlotValues& values);

}  // namespace bole::inventory
