// Writes point clouds as PLY and text, or in the format that the ending names.
#pragma once

#include <filesystem>

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::io {

// Binary little-endian PLY with every column. Coordinates are double where the cloud has an origin away from zero, so
// that they come back exactly, else float. Colours are written as uchar, as viewers expect, unless their low bytes are
// in use. Facts go to a comment line (ply_reader.h). Throws Error{failed} when the file cannot be written.
void write_ply(const std::filesystem::path& path, const PointCloud& cloud, const Run& run = {});

// One line per point below a header line, with commas for CSV and blanks for XYZ. `decimals` is for the coordinates;
// other values get the fewest digits that read back to the same number, as in "12.5".
void write_csv_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals = 4, const Run& run = {});
void write_xyz_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals = 4, const Run& run = {});

// `.las`, `.laz`, `.copc.laz`, `.ply`, `.csv`, `.xyz`, ...: as the table of formats.h says. Throws Error{bad_input}
// that lists the endings where no format is written with this one. Warnings of the writer go to `report`.
void write_cloud(const std::filesystem::path& path, const PointCloud& cloud, const Run& run = {},
                 Report* report = nullptr);

}  // namespace bole::io
