// Plot values as tables: what summary.json, the workbook, the report and Python show.
#pragma once

#include "cloud/table.h"
#include "inventory/core/plot_values.h"

namespace bole::inventory {

// A row per measure, always the same rows in the same order: measure, value, unit, and of the 95 % interval lo, hi
// (as measured), half (its half width) and sampled_half (the half width as a sample of a stand of trees at random).
// NaN where a number cannot be given. Measures whose names end in _sound leave out the stems that are to be checked,
// all others are with them. Fact class_width_cm: the width of the diameter classes.
Table plot_value_table(const PlotValues& values, const PlotValueOptions& options);

// min_dbh_cm, max_dbh_cm, stems, stems_to_check, stems_per_ha, basal_area_m2, basal_area_m2_per_ha, mean_height_m; thin
// classes first.
Table class_table(const PlotValues& values);

// A row per stem that counts: tree_id, dbh_cm, to_check (0 or 1), height_m and height_source (top seen, height curve),
// curve_height_m and height_residual_m (of tops seen against the curve), volume_m3 with its 95 % interval
// (volume_lo_m3, volume_hi_m3) and volume_source. `stems` is the table that the values come from.
Table tree_value_table(const PlotValues& values, const Table& stems);

// One row: breast_height_m, a, b, rmse_m (standard deviation of the residuals, with n - 2), trees (the curve is fitted
// to), left_out (heights off by over 3 of these), min_dbh_cm, max_dbh_cm. No row where no curve was fitted or too few
// tops were seen.
Table height_curve_table(const PlotValues& values);

}  // namespace bole::inventory
