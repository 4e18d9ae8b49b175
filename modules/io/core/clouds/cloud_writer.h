// Writes point clouds as PLY and text, and by extension as LAS too (las_writer.h).
#pragma once

#include <filesystem>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::io {

// Binary little-endian PLY with every column; coordinates are double when the cloud has an origin away from zero, so
// that they come back exactly, else float. Colours are written as uchar, as viewers expect, unless their low bytes are
// in use. Throws Error{failed} when the file cannot be written.
void write_ply(const std::filesystem::path& path, const PointCloud& cloud, const Run& run = {});

// One line per point with a header line: commas for CSV, blanks for XYZ. `decimals` of the coordinates; columns are
// written with the fewest digits that read back to the same value, as in "12.5".
void write_csv_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals = 4, const Run& run = {});
void write_xyz_cloud(const std::filesystem::path& path, const PointCloud& cloud, int decimals = 4, const Run& run = {});

// By extension: .las, .ply, .csv, .xyz, .txt. Throws Error{bad_input} for others.
void write_cloud(const std::filesystem::path& path, const PointCloud& cloud, const Run& run = {});

}  // namespace bole::io
