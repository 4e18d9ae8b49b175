// LAS 1.0 to 1.4 and LAZ, point formats 0 to 10, into a point cloud.
//
// Coordinates come back exactly: the cloud's origin lies on the file's grid, and a float32 offset rounded to the grid
// (exact_position()) is the coordinate of the file, up to 2^23 steps (8.4 km at 1 mm) from the middle of the cloud.
// Beyond that the reader warns.
#pragma once

#include <filesystem>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/large_cloud.h"
#include "cloud/point_cloud.h"
#include "io/core/las/las_bytes.h"
#include "io/core/las/las_info.h"

namespace bole::io {

struct LasReadOptions {
  bool drop_withheld = false;
  bool extra_bytes = true;
  std::size_t columns_in_memory = large_columns_bytes;  // bytes; with more of them columns lie on file: no option of a
                                                        // pipeline, for it changes no result
};
const OptionTable& option_table(const LasReadOptions*);

// Columns: the vocabulary's names for the fields of a LAS point (intensity as the file has it; scan_angle in degrees;
// time as GPS time), flags as `withheld`, `synthetic` and so on where set, extra bytes under their own names. A column
// that is zero throughout is left out. Waveforms are skipped. Axes are `global` when the file names its CRS.
//
// A damaged file is read as far as it is sound, with a warning in `report` that says how many of how many points that
// is. Throws Error{bad_input} when it is no LAS file or none of its points can be read, Error{cancelled}.
PointCloud read_las(const std::filesystem::path& path, const LasReadOptions& options = {}, const Run& run = {},
                    Report* report = nullptr);

// The same of a file in memory; the CRS of GeoTIFF keys is left out when `with_crs` is false.
PointCloud read_las(Bytes file, const LasReadOptions& options = {}, const Run& run = {}, Report* report = nullptr,
                    bool with_crs = true);

}  // namespace bole::io
