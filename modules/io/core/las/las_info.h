// Header and variable length records of a LAS or LAZ file, without its points.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/core/las/las_bytes.h"

namespace bole::io {

// A variable length record; `extended` ones lie behind the points.
struct LasVlr {
  std::string user_id;
  int record_id = 0;
  std::string description;
  bool extended = false;
  std::uint64_t offset = 0, length = 0;  // of its data in the file, checked to lie within it
};

struct LasInfo {
  int version_major = 1, version_minor = 2;
  int point_format = 0;     // 0 to 10
  bool compressed = false;  // LAZ
  int record_length = 0;    // bytes per point, extra bytes included
  int file_source_id = 0;
  unsigned global_encoding = 0;   // bit 0: time is GPS time minus 1e9 s; bit 4: the CRS is WKT
  std::uint64_t points = 0;       // as declared; the file may hold fewer
  std::uint64_t data_offset = 0;  // of the first point
  std::uint64_t data_end = 0;     // behind the last byte that may hold points
  std::array<std::uint64_t, 15> points_by_return{};
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  // coordinate = integer * scale + offset
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  Eigen::Vector3d min = Eigen::Vector3d::Zero();  // as declared
  Eigen::Vector3d max = Eigen::Vector3d::Zero();
  std::string system, software;
  int creation_day = 0, creation_year = 0;
  std::string crs_wkt;  // from the WKT record, else made of the GeoTIFF keys; empty when there is neither
  std::vector<LasVlr> vlrs;
  std::vector<std::string> extra_columns;  // names of the documented extra bytes
  std::vector<std::string> warnings;       // errors in the header
};

// Reads header and variable length records. Throws Error{bad_input} where it is not a LAS file or its header cannot be
// used (truncated, unknown version or format, impossible record length or data offset).
LasInfo las_info(const std::filesystem::path& path);

namespace las {

// The same of a file in memory. `with_crs`: GeoTIFF keys are converted to WKT and the unit is checked, which needs the
// database of PROJ.
LasInfo parse_info(Bytes file, bool with_crs = true);

// The first record of that kind, or nullptr.
const LasVlr* find_vlr(const LasInfo& info, std::string_view user_id, int record_id);

inline Bytes vlr_data(Bytes file, const LasVlr& vlr) { return file.subspan(vlr.offset, vlr.length); }

}  // namespace las

}  // namespace bole::io
