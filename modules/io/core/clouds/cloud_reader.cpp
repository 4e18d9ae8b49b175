#include "io/core/clouds/cloud_reader.h"

#include "base/error.h"
#include "base/verdict.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/formats.h"

namespace bole::io {

const OptionTable& option_table(const CloudReadOptions*) {
  using S = CloudReadOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, LengthUnit>{"unit", &S::unit, Tier::basic, "Unit of the coordinates in the file."},
      Option<S, UpAxis>{"up", &S::up, Tier::basic,
                        "Axis of the file that points up. It is z in most files, and y in most files from phones and "
                        "cameras."},
      Option<S, Axes>{"axes", &S::axes, Tier::advanced,
                      "Coordinate system of the file. global: projected coordinates; plot: x to the east and y to the "
                      "north of the plot centre."},
      Option<S, std::string>{"bounds",
                             &S::bounds,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Part of the file to read: xmin,ymin,xmax,ymax in the coordinates of the file (or six "
                             "numbers, with z). Of a COPC file only what lies there is decoded. Empty: all points."},
      Option<S, double>{"resolution",
                        &S::resolution,
                        Unit::none,
                        {0, 1e6},
                        Tier::advanced,
                        "Spacing of the points, in the unit of the file, that is fine enough: a COPC file is read down "
                        "to the first level of its octree that has it. 0: all points. Other formats have no levels."},
      Option<S, ScanPositions>{"scan_positions", &S::scan_positions, Tier::advanced,
                               "Whether the poses of the scans of an E57 file are places of the scanner, from which "
                               "rays go out. auto: where scans have angles, a grid, or poses that say something."},
      Option<S, std::string>{"columns",
                             &S::columns,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Columns of a text file in their order, for instance \"x y z intensity\"; _ skips a "
                             "column. Empty: from the header line, or guessed from the number of columns."},
      Option<S, std::optional<Delimiter>>{"delimiter", &S::delimiter, "auto", Tier::advanced,
                                          "Character between the columns of a text file."},
      Option<S, bool>{"drop_withheld", &S::drop_withheld, Tier::advanced,
                      "Leave out LAS points that are flagged as withheld."},
      Option<S, int>{"skip_lines",
                     &S::skip_lines,
                     Unit::none,
                     {0, 1000000},
                     Tier::advanced,
                     "Number of lines to skip at the beginning of a text file."},
  });
  return table;
}

double metres_per_unit(LengthUnit unit) {
  constexpr std::array metres{1.0, 0.01, 0.001, 0.3048, 1200.0 / 3937.0};
  return metres[static_cast<std::size_t>(unit)];
}

Eigen::Matrix3d rotation_to_z_up(UpAxis up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == UpAxis::y) rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == UpAxis::x) rotation << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  return rotation;
}

// Noise read as numbers reaches 1e38; the unit of a file may be another than metres.
void check_coordinates(CloudReading& reading, bool declared) {
  constexpr double doubtful_share = 0.01;
  constexpr const char* code = "implausible_coordinates";
  if (has_finding(reading.report, code)) return;
  const auto& cloud = reading.cloud;
  std::size_t far = 0;
  for (const auto& p : cloud.positions())
    if (!((p.cast<double>() + cloud.origin).cwiseAbs().maxCoeff() <= farthest_m)) ++far;
  if (far == 0) return;
  const auto found =
      std::to_string(far) + " of " + std::to_string(cloud.size()) + " points lie more than 100 000 km from the origin";
  const bool many = static_cast<double>(far) > doubtful_share * static_cast<double>(cloud.size());
  if (many && !declared)
    throw bad_input(found + ": these are no coordinates in metres", "a point cloud",
                    "Is the file damaged or of another kind? Else set the option unit, or the columns of a text file");
  if (many)
    reading.report.find(Severity::refused, code,
                        found +
                            ", as the bounds in the header of the file say: these are no coordinates in metres. "
                            "Set the option unit, or repair scale and offset in the header");
  else
    reading.report.find(Severity::look, code, found + ": crop or repair the cloud");
}

CloudReading read_cloud(Bytes file, const std::filesystem::path& name, const CloudReadOptions& options,
                        const Run& run) {
  try {
    const auto& format = require_format(FileContent::cloud, file, name);
    auto reading = std::get<CloudAccess>(format.access).read(file, options, run);
    check_coordinates(reading);
    if (options.resolution > 0 && !reading.report.counts.contains("copc_nodes"))
      reading.report.find(
          Severity::look, "resolution_ignored",
          "the option resolution has no effect: this file of the format " + std::string(format.name) +
              " has no levels that can be used, all of its points were read. Convert it to COPC, or set resolution=0");
    return reading;
  } catch (const Error& e) {
    throw e.at("'" + name.string() + "'");
  }
}

CloudReading read_cloud(const std::filesystem::path& path, const CloudReadOptions& options, const Run& run) {
  if (path.empty()) throw bad_input("no point cloud is named", format_list(FileContent::cloud), "Set the option file");
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    const auto* format = find_format(path);
    throw bad_input("'" + path.string() + "' is a folder", "a point cloud file",
                    format == nullptr ? "" : "Read it with the stage " + std::string(format->stage()));
  }
  const MappedFile file(path);
  CloudReading out = read_cloud(file.bytes(), path, options, run);
  out.report.message = path.filename().string() + ": " + std::to_string(out.cloud.size()) + " points (" +
                       out.report.facts["format"] + ")";
  return out;
}

}  // namespace bole::io
