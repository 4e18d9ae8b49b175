// The XML of an E57 file: which scans there are, how their points are packed, and where they stood.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/core/bytes/mapped_file.h"

namespace bole::io::e57 {

enum class ValueType { integer, scaled_integer, float32, float64, text };

// A leaf of the prototype: one stream of values.
struct Field {
  std::string name;  // cartesianX, intensity, nor:normalX, ...
  ValueType type = ValueType::float64;
  std::int64_t minimum = 0, maximum = 0;  // of integers
  double scale = 1, offset = 0;           // of scaled integers: value = integer * scale + offset

  unsigned bits() const;    // of a value in the stream; 0: all values are the minimum
  double smallest() const;  // of the values an integer field can have
  double largest() const;
};

// Smallest and largest value as the scan declares them.
struct Limits {
  double min = 0, max = 0;
};

struct Scan {
  std::string name, sensor;
  std::uint64_t offset = 0;   // of the points, physical
  std::uint64_t records = 0;  // as declared
  std::vector<Field> fields;
  bool merged = false;       // put together from several scans
  bool other_codec = false;  // packed in a way that the standard does not define
  std::optional<Eigen::Isometry3d> T_file_scan;
  std::optional<double> start_s;  // GPS time
  std::optional<Limits> intensity;
  std::optional<Limits> colours[3];

  bool has(std::string_view field) const;
  bool is_spherical() const { return !has("cartesianX") && has("sphericalRange"); }
  // A grid of directions; writers of plain clouds may give indices that are all the same.
  bool is_structured() const { return varies("rowIndex") && varies("columnIndex"); }

 private:
  bool varies(std::string_view field) const;
};

// "scan 3 ('west')".
std::string described(const Scan& scan, std::size_t number);

struct Description {
  std::vector<Scan> scans;
  std::size_t images = 0;
  std::string crs;                    // as the file has it; empty where it has none
  std::vector<std::string> warnings;  // scans that cannot be read
};

// Throws Error{bad_input} where the text is no XML of an E57 file.
Description parse_description(Bytes xml);

}  // namespace bole::io::e57
