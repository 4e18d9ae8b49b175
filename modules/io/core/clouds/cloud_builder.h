// Collects rows of numbers from any file format into a PointCloud.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/run.h"
#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Nothing on earth is further away than this from the origin of its coordinates: noise read as numbers.
inline constexpr double farthest_m = 1e8;

// How the values of a field are stored in the file. `text`: the file does not declare a type. packed_rgb: 0x00RRGGBB
// (PCD).
enum class SourceType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64, text, packed_rgb };
std::size_t source_type_bytes(SourceType type);  // 0 for text

// The value at `p` (unaligned), of the byte order of this machine or the other.
double source_value(SourceType type, const std::uint8_t* p, bool swap_bytes = false);

struct SourceField {
  std::string name;
  SourceType type = SourceType::text;
};

// Bole's name for a field of a file: "GpsTime", "scalar_Intensity" and "diffuse_red" become time, intensity and red.
// Unknown names become lower case with underscores.
std::string array_name(std::string_view file_name);

bool is_colour(std::string_view array);  // red, green or blue

// Call it for every point. Once in a while it polls for a cancel and reports the fraction read.
void poll_points(const Run& run, std::size_t point, double fraction);

// A finding where a file does not hold all points that its header declares, with the share that was read in `text`.
// From 1 % missing on the input counts as incomplete (finding_code::input_incomplete), which ends a run of the program.
void note_missing_points(Report& report, std::uint64_t declared, std::uint64_t present, const std::string& text);
// The same with the usual text.
void warn_cut_off(Report& report, std::uint64_t declared, std::uint64_t present);

class CloudBuilder {
 public:
  // Throws Error{bad_input} when x, y or z is not among the fields; the message lists what there is.
  CloudBuilder(const std::vector<SourceField>& fields, const CloudReadOptions& options);
  ~CloudBuilder();
  CloudBuilder(const CloudBuilder&) = delete;
  CloudBuilder& operator=(const CloudBuilder&) = delete;

  void reserve(std::size_t points);

  // One point: a value per field. Dropped and counted when a coordinate is not a finite number.
  void add(std::span<const double> row);
  std::size_t size() const;

  // The cloud, with counts in the report.
  CloudReading finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace bole::io
