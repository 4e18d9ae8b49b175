// The truth beside a simulated scan, as files.
#pragma once

#include <filesystem>

#include "cloud/raster.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "sim/core/plot/forest.h"
#include "sim/core/plot/vegetation.h"

namespace bole::sim {

// The reference trees: tree_id, x_m, y_m (at breast height), z_m (uphill ground), dbh_cm (taped), height_m, lean_deg,
// lean_azimuth_deg (clockwise from north), state (alive, dead), in_plot (0, 1), species, base_x_m, base_y_m, twin_of,
// and bark_mm (depth of the fissures) where the recipe names species. Poles are among them.
Table tree_table(const Forest& forest);
// Thin stems crossing breast height that are no trees of the plot: sapling_id, x_m, y_m, z_m, dbh_cm, height_m.
Table sapling_table(const std::vector<Sapling>& saplings);
// name, x_m, y_m, z_m (middle of the foil), diameter_m, height_m.
Table target_table(const Forest& forest);

// Throw Error{failed} when the file cannot be written.
void write_csv(const Table& table, const std::filesystem::path& file);
void write_tum(const Trajectory& trajectory, const std::filesystem::path& file);
void write_dem(const Raster& dem, const std::filesystem::path& file);  // GeoTIFF, float32, north up

}  // namespace bole::sim
