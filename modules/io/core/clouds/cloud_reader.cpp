#include "io/core/clouds/cloud_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "io/core/clouds/cloud_builder.h"
#include "io/core/clouds/pcd_reader.h"
#include "io/core/clouds/ply_reader.h"
#include "io/core/clouds/sensor_arrays.h"
#include "io/core/clouds/text_reader.h"
#include "io/core/las/las_reader.h"

namespace bole::io {
namespace {

struct NamedUnit {
  const char* name;
  double metres;
};
constexpr std::array units{NamedUnit{"metre", 1}, NamedUnit{"centimetre", 0.01}, NamedUnit{"millimetre", 0.001},
                           NamedUnit{"foot", 0.3048}, NamedUnit{"us_survey_foot", 1200.0 / 3937.0}};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool starts_with(Bytes file, std::string_view text) {
  return file.size() >= text.size() && std::equal(text.begin(), text.end(), file.begin(), [](char a, std::uint8_t b) {
           return static_cast<std::uint8_t>(a) == b;
         });
}

// Files that people drop in and that are something else.
void refuse_others(Bytes file) {
  using namespace std::string_view_literals;
  if (starts_with(file, "ASTM-E57"))
    throw bad_input("this is an E57 file", "PLY, PCD, LAS, LAZ or text",
                    "Export it as LAS or PLY from the scanner's program or CloudCompare");
  for (const auto magic :
       {"\xD4\xC3\xB2\xA1"sv, "\xA1\xB2\xC3\xD4"sv, "\x4D\x3C\xB2\xA1"sv, "\xA1\xB2\x3C\x4D"sv, "\x0A\x0D\x0D\x0A"sv})
    if (starts_with(file, magic))
      throw bad_input("this is a packet capture of a sensor", "a point cloud", "Read it as a scan: stage io.read_scan");
  for (const auto magic : {"PK\x03\x04"sv, "\x1F\x8B"sv, "7z\xBC\xAF"sv})
    if (starts_with(file, magic)) throw bad_input("this is a compressed archive", "a point cloud", "Unpack it first");
  if (starts_with(file, "\x89HDF")) throw bad_input("this is an HDF5 file", "PLY, PCD, LAS, LAZ or text");
}

bool looks_like_text(Bytes file) {
  const auto head = file.first(std::min<std::size_t>(file.size(), 4096));
  return std::ranges::none_of(head, [](std::uint8_t c) { return c < 9 || (c > 13 && c < 32 && c != 26); });
}

// One KITTI frame: x, y, z, intensity as float32.
CloudReading read_kitti_bin(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudBuilder builder({{"x", SourceType::float32},
                        {"y", SourceType::float32},
                        {"z", SourceType::float32},
                        {"intensity", SourceType::float32}},
                       options);
  constexpr std::size_t record = 16;
  std::array<double, 4> row{};
  builder.reserve(file.size() / record);
  for (std::size_t i = 0; i + record <= file.size(); i += record) {
    if (i % (record << 16) == 0) run.check_cancel();
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = source_value(SourceType::float32, file.data() + i + 4 * k);
    builder.add(row);
  }
  auto out = builder.finish();
  out.report.facts["format"] = "KITTI frame";
  if (file.size() % record != 0) out.report.warn("the file is cut off within its last point");
  return out;
}

// What the options ask of files whose reader gives coordinates as they are.
void to_metres_z_up(PointCloud& cloud, const CloudReadOptions& options) {
  const Eigen::Matrix3d matrix = metres_per_unit(options.unit) * rotation_to_z_up(options.up);
  if (options.axes != "unknown") cloud.axes = axes_from_name(options.axes);
  if (matrix.isIdentity(0)) return;
  const auto turn = [&matrix](Eigen::Vector3f& p) { p = (matrix * p.cast<double>()).cast<float>(); };
  auto positions = cloud.positions();
  for (auto& p : positions) turn(p);
  cloud.set_positions(std::move(positions));
  if (std::ranges::all_of(sensor_arrays, [&](const ArrayInfo& a) { return cloud.has(a); })) {
    std::array<std::vector<float>, 3> sensor;
    for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis] = cloud.values<float>(sensor_arrays[axis]);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      Eigen::Vector3f p(sensor[0][i], sensor[1][i], sensor[2][i]);
      turn(p);
      for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis][i] = p[static_cast<int>(axis)];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) cloud.set_column(sensor_arrays[axis], std::move(sensor[axis]));
  }
  cloud.origin = matrix * cloud.origin;
  cloud.scale = (matrix * cloud.scale).cwiseAbs();
}

CloudReading read_las_cloud(Bytes file, const CloudReadOptions& options, const Run& run) {
  CloudReading out;
  LasReadOptions las;
  las.drop_withheld = options.drop_withheld;
  out.cloud = read_las(file, las, run, &out.report);
  to_metres_z_up(out.cloud, options);
  out.report.counts["points"] = static_cast<std::int64_t>(out.cloud.size());
  out.report.facts.try_emplace("format", "LAS");
  if (out.cloud.empty()) out.report.warn("the file holds no points");
  return out;
}

CloudReading dispatch(Bytes file, const std::filesystem::path& name, const CloudReadOptions& options, const Run& run) {
  const std::string extension = lower(name.extension().string());
  if (starts_with(file, "LASF")) return read_las_cloud(file, options, run);
  if (looks_like_ply(file)) return read_ply(file, options, run);
  if (looks_like_pcd(file)) return read_pcd(file, options, run);
  refuse_others(file);
  if (file.empty()) throw bad_input("the file is empty", "a point cloud");
  if (looks_like_text(file) && extension != ".bin") return read_text_cloud(file, extension, options, run);
  if (extension == ".bin" && file.size() >= 16) return read_kitti_bin(file, options, run);
  throw bad_input("this is no point cloud file that is known (" + std::to_string(file.size()) + " bytes, extension '" +
                      extension + "')",
                  "PLY, PCD, LAS, LAZ, text (XYZ, CSV, PTS, PTX) or a KITTI .bin frame");
}

}  // namespace

const OptionTable& option_table(const CloudReadOptions*) {
  using S = CloudReadOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"unit",
                             &S::unit,
                             TextKind::choice,
                             {"metre", "centimetre", "millimetre", "foot", "us_survey_foot"},
                             Tier::basic,
                             "Unit of the coordinates in the file."},
      Option<S, std::string>{"up",
                             &S::up,
                             TextKind::choice,
                             {"z", "y", "x"},
                             Tier::basic,
                             "Axis of the file that points up: z as usual, y in most files of phones and cameras."},
      Option<S, std::string>{"axes",
                             &S::axes,
                             TextKind::choice,
                             {"unknown", "sensor", "map", "plot", "global"},
                             Tier::advanced,
                             "What the coordinates are: global for projected coordinates, plot for x east and y north "
                             "from the plot centre."},
      Option<S, std::string>{"columns",
                             &S::columns,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Columns of a text file in order, for instance \"x y z intensity\", with _ for one to "
                             "skip; empty: from the header line, or as usual."},
      Option<S, std::string>{"delimiter",
                             &S::delimiter,
                             TextKind::choice,
                             {"auto", "blank", "comma", "semicolon", "tab"},
                             Tier::advanced,
                             "What stands between the columns of a text file."},
      Option<S, bool>{"drop_withheld", &S::drop_withheld, Tier::advanced,
                      "Leave out LAS points that are flagged as withheld."},
      Option<S, int>{"skip_lines",
                     &S::skip_lines,
                     Unit::none,
                     {0, 1000000},
                     Tier::advanced,
                     "Lines of a text file to pass over before anything else."},
  });
  return table;
}

double metres_per_unit(const std::string& unit) {
  const auto it = std::ranges::find(units, unit, [](const NamedUnit& u) { return std::string(u.name); });
  if (it == units.end())
    throw bad_input("unit '" + unit + "'", "metre, centimetre, millimetre, foot or us_survey_foot");
  return it->metres;
}

Eigen::Matrix3d rotation_to_z_up(const std::string& up) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  if (up == "y") rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  if (up == "x") rotation << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  if (up != "x" && up != "y" && up != "z") throw bad_input("up axis '" + up + "'", "x, y or z");
  return rotation;
}

CloudReading read_cloud(Bytes file, const std::filesystem::path& name, const CloudReadOptions& options,
                        const Run& run) {
  try {
    return dispatch(file, name, options, run);
  } catch (const Error& e) {
    throw e.at("'" + name.string() + "'");
  }
}

CloudReading read_cloud(const std::filesystem::path& path, const CloudReadOptions& options, const Run& run) {
  if (path.empty()) throw bad_input("no cloud is named", "a PLY, PCD, LAS, LAZ or text file", "Set the option file");
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw bad_input("'" + path.string() + "' is a folder", "a point cloud file",
                    "A folder of frames is read as a scan: stage io.read_scan");
  const MappedFile file(path);
  CloudReading out = read_cloud(file.bytes(), path, options, run);
  out.report.message = path.filename().string() + ": " + std::to_string(out.cloud.size()) + " points (" +
                       out.report.facts["format"] + ")";
  return out;
}

}  // namespace bole::io
