// Writes point clouds as LAS, LAZ and COPC.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::io {

// Of the points of a file: as they are, compressed (LASzip 3 in LAS 1.4, LASzip 2 in 1.2), or compressed as an octree
// of which programs read the part and the resolution that they need (COPC 1.0, copc.io).
enum class LasPacking { plain, laz, copc };
constexpr std::array<std::string_view, 3> choice_names(LasPacking) { return {"plain", "laz", "copc"}; }

struct LasWriteOptions {
  std::string version = "1.4";
  double scale_m = 0.0001;
  bool extra_bytes = true;
  LasPacking packing = LasPacking::plain;  // write_cloud() decides by the ending
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
// Compressed files hold the same records as plain ones and are the same bytes at any number of threads; memory is taken
// for a few chunks of points for each thread. COPC orders the points anew and takes 9 bytes for each of them; it holds
// up to 2^32 - 1 points.
//
// The file appears under its name only when it is whole. Throws Error{bad_input} when a coordinate is not finite or too
// far away for the grid, Error{failed} when the file cannot be written, Error{cancelled}.
void write_las(const std::filesystem::path& path, const PointCloud& cloud, const LasWriteOptions& options = {},
               const Run& run = {}, Report* report = nullptr);

}  // namespace bole::io
