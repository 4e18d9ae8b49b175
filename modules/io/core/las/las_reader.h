// LAS 1.0 to 1.4 and LAZ, point formats 0 to 10, into a point cloud.
//
// Coordinates come back exactly: the cloud's origin lies on the file's grid, and a float32 offset rounded to the grid
// (exact_position()) is the coordinate of the file, up to 2^23 steps (8.4 km at 1 mm) from the middle of the cloud.
// Beyond that the reader warns.
#pragma once

#include <filesystem>
#include <optional>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/large_cloud.h"
#include "cloud/piece.h"
#include "cloud/point_cloud.h"
#include "io/core/clouds/cloud_bounds.h"
#include "io/core/las/las_bytes.h"
#include "io/core/las/las_info.h"

namespace bole::io {

struct LasReadOptions {
  bool drop_withheld = false;
  bool extra_bytes = true;
  std::optional<CloudBounds> bounds{};  // in the coordinates of the file; nothing: all points
  double resolution = 0;                // greatest spacing of the points of a COPC file; 0: all of them
  // Which of so many pieces to decode: every so many-th chunk of a compressed file, a run of the records of others. All
  // have the origin that the bounds in the header give.
  Piece piece{};
  // The origin that pieces have, also of the whole or of what lies within bounds.
  bool origin_of_header = false;
  // Bytes. Larger clouds have their columns on file. Not an option of a stage, because it changes no result.
  std::size_t columns_in_memory = large_columns_bytes;
};
const OptionTable& option_table(const LasReadOptions*);

// Columns: the fields of a LAS point under the names of base/arrays.h (scan_angle in degrees, time as GPS time), flags
// such as `withheld` and `synthetic` where they are set, and extra bytes under their own names. A column of zeros is
// left out. Facts that write_las() wrote come back (las_facts.h). Waveforms are skipped. Axes are `global` where the
// file names its CRS.
//
// A damaged file is read up to the damage, and a warning in `report` gives the number of points read and declared.
// Throws Error{bad_input} where it is not a LAS file or no point can be read, and Error{cancelled}.
PointCloud read_las(const std::filesystem::path& path, const LasReadOptions& options = {}, const Run& run = {},
                    Report* report = nullptr);

// The same of a file in memory; the CRS of GeoTIFF keys is left out when `with_crs` is false.
PointCloud read_las(Bytes file, const LasReadOptions& options = {}, const Run& run = {}, Report* report = nullptr,
                    bool with_crs = true);

}  // namespace bole::io
