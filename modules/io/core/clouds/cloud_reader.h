// Reads any point cloud file: what it is, is seen from its content first and its extension second.
#pragma once

#include <filesystem>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

struct CloudReadOptions {
  std::string unit = "metre";
  std::string up = "z";
  std::string axes = "unknown";
  std::string columns;
  std::string delimiter = "auto";
  int skip_lines = 0;
  bool drop_withheld = false;
};
const OptionTable& option_table(const CloudReadOptions*);

struct CloudReading {
  PointCloud cloud;
  Report report;  // counts: points, dropped_points (not numbers), bad_lines; facts: format
};

// PLY, PCD, LAS, LAZ, text (XYZ, CSV, PTS, PTX) or one KITTI .bin frame. Coordinates are turned to metres with z up.
// Points whose coordinates are not numbers are dropped and counted. A file that is cut off gives what it holds, with a
// warning that says how much is missing. Throws Error{bad_input} when nothing can be made of it.
CloudReading read_cloud(const std::filesystem::path& path, const CloudReadOptions& options = {}, const Run& run = {});

// The same of a file in memory; `name` (its extension) decides where the content does not.
CloudReading read_cloud(Bytes file, const std::filesystem::path& name, const CloudReadOptions& options = {},
                        const Run& run = {});

// Metres per unit and the rotation to z up that the options ask for. Throws Error{bad_input}.
double metres_per_unit(const std::string& unit);
Eigen::Matrix3d rotation_to_z_up(const std::string& up);

}  // namespace bole::io
