// Cuts a cloud of any size into files of tiles that overlap.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "io/core/tiles/tile_grid.h"

namespace bole::io {

struct CutOptions {
  std::string files;  // LAS, LAZ or COPC, separated by commas
  double tile_m = 50, buffer_m = 10;
  double shift_x = 0, shift_y = 0;  // of the grid of tiles from multiples of tile_m, metres
  std::optional<double> breast_height;
};
const OptionTable& option_table(const CutOptions*);

struct CutCloud {
  Table tiles;  // name, file, column, row, core bounds xmin_m ... ymax_m, points, core_points; by row, then column
  Report report;
};

// Writes NAME.laz for every tile whose core holds points into `folder`: the records as they are in the files, in their
// order, of the core and the buffer around it. Each file says of which cloud it is a part
// (cloud/core/whole/whole_cloud.h).
//
// Memory is taken for 256 MiB of points, whatever the size of the files; disk, while it works, for the records of all
// tiles uncompressed. Throws Error{bad_input} for files of other formats, that differ in their records or coordinate
// steps, or with coordinates that are not in metres, Error{failed}, Error{cancelled}.
CutCloud cut_cloud(const CutOptions& options, const std::filesystem::path& folder, const Run& run);

}  // namespace bole::io
