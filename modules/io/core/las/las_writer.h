// Writes point clouds as LAS.
#pragma once

#include <filesystem>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::io {

struct LasWriteOptions {
  std::string version = "1.4";
  double scale_m = 0.0001;
  bool extra_bytes = true;
};
const OptionTable& option_table(const LasWriteOptions*);

// LAS 1.4 in point format 6 (7 with colour, 8 with near infrared), or 1.2 in format 1 or 3 for older programs. Columns
// go to the fields of their names; those without a field (tree_id, height_above_ground, range, ...) become extra bytes,
// sensor positions as global coordinates to 0.1 mm. The CRS is written as WKT (1.4) or as the EPSG code in GeoTIFF keys
// (1.2). Facts go to a record of Bole's own (las_facts.h).
//
// Coordinates lie on the cloud's own grid (PointCloud::scale) when it has one, so that a cloud read from LAS comes back
// exactly; else they are rounded to `scale_m`. Values beyond the range of a field are clamped, with a warning.
//
// The file appears under its name only when it is whole. Throws Error{bad_input} when a coordinate is not finite or too
// far away for the grid, Error{failed} when the file cannot be written, Error{cancelled}.
void write_las(const std::filesystem::path& path, const PointCloud& cloud, const LasWriteOptions& options = {},
               const Run& run = {}, Report* report = nullptr);

}  // namespace bole::io
