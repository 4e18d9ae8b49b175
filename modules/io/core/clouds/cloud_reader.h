// Reads any point cloud file. Which format it is, the table in formats.h decides.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/axes_choice.h"
#include "cloud/piece.h"
#include "cloud/point_cloud.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

enum class LengthUnit { metre, centimetre, millimetre, foot, us_survey_foot };
constexpr std::array<std::string_view, 5> choice_names(LengthUnit) {
  return {"metre", "centimetre", "millimetre", "foot", "us_survey_foot"};
}

enum class UpAxis { z, y, x };
constexpr std::array<std::string_view, 3> choice_names(UpAxis) { return {"z", "y", "x"}; }

enum class Delimiter { blank, comma, semicolon, tab };
constexpr std::array<std::string_view, 4> choice_names(Delimiter) { return {"blank", "comma", "semicolon", "tab"}; }

// Whether the poses of the scans of a file are places of the scanner, from which its rays go out.
enum class ScanPositions { automatic, given, none };
constexpr std::array<std::string_view, 3> choice_names(ScanPositions) { return {"auto", "given", "none"}; }

struct CloudReadOptions {
  LengthUnit unit = LengthUnit::metre;
  UpAxis up = UpAxis::z;
  Axes axes = Axes::unknown;
  std::string columns;
  std::optional<Delimiter> delimiter;  // of text; open: as the file says
  int skip_lines = 0;
  bool drop_withheld = false;
  std::string bounds;                                       // as parse_bounds() has it; empty: all points
  double resolution = 0;                                    // COPC: greatest spacing of the points; 0: all of them
  ScanPositions scan_positions = ScanPositions::automatic;  // E57
  // Of LAS, LAZ and COPC. Not an option of a stage: hosts with several processes ask for pieces.
  Piece piece{};
  bool origin_of_header = false;  // the origin that pieces have, whatever is selected
};
const OptionTable& option_table(const CloudReadOptions*);

struct CloudReading {
  PointCloud cloud;
  Report report;  // counts: points, dropped_points (not numbers), bad_lines; facts: format
};

// Coordinates are turned to metres with z up. Points whose coordinates are not numbers are dropped and counted. A file
// that is cut off gives the points it holds, with a warning that says how many are missing. Throws Error{bad_input}
// where the file cannot be used.
CloudReading read_cloud(const std::filesystem::path& path, const CloudReadOptions& options = {}, const Run& run = {});

// The same of a file in memory. The ending of `name` decides where the content does not.
CloudReading read_cloud(Bytes file, const std::filesystem::path& name, const CloudReadOptions& options = {},
                        const Run& run = {});

// A finding where some coordinates are none of this earth (farthest_m). Where many are, the finding refuses the result
// if the file itself declares such bounds, else throws Error{bad_input}. Does nothing once the finding is made.
void check_coordinates(CloudReading& reading, bool declared = false);

double metres_per_unit(LengthUnit unit);
Eigen::Matrix3d rotation_to_z_up(UpAxis up);

}  // namespace bole::io
