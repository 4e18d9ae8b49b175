#include "io/core/formats.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "io/core/bags/bag.h"
#include "io/core/bags/bag_source.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/clouds/kitti_frame.h"
#include "io/core/clouds/las_cloud.h"
#include "io/core/clouds/pcd_reader.h"
#include "io/core/clouds/ply_reader.h"
#include "io/core/clouds/ptx_reader.h"
#include "io/core/clouds/text_reader.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/e57/e57_pages.h"
#include "io/core/e57/e57_reader.h"
#include "io/core/las/las_writer.h"
#include "io/core/scans/frame_folder.h"
#include "io/core/scans/hesai_capture.h"
#include "io/core/scans/livox_lvx.h"
#include "io/core/scans/ouster_capture.h"
#include "io/core/scans/velodyne_pcap.h"
#include "io/core/tables/named_trajectory.h"
#include "io/core/tables/nmea_reader.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "io/core/views/view_layouts.h"

namespace bole::io {
namespace {

using namespace std::string_view_literals;
namespace fs = std::filesystem;

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

// The last part of the name, and of COPC both.
std::string ending_of(const fs::path& path) {
  constexpr auto copc_ending = ".copc.laz"sv;
  const std::string name = lower(path.filename().string());
  return name.ends_with(copc_ending) ? std::string(copc_ending) : lower(path.extension().string());
}

bool starts_with(Bytes file, std::string_view text) {
  return std::string_view(reinterpret_cast<const char*>(file.data()), file.size()).starts_with(text);
}

bool is_las(Bytes file) { return starts_with(file, "LASF"); }

bool is_laz(Bytes file) {
  constexpr std::size_t point_format = 104;  // LASzip sets the highest bit of this byte
  return is_las(file) && file.size() > point_format && (file[point_format] & 0x80) != 0;
}

bool is_capture(Bytes file) {
  constexpr std::array magics{"\xD4\xC3\xB2\xA1"sv, "\xA1\xB2\xC3\xD4"sv, "\x4D\x3C\xB2\xA1"sv, "\xA1\xB2\x3C\x4D"sv,
                              "\x0A\x0D\x0D\x0A"sv};
  return std::ranges::any_of(magics, [file](std::string_view magic) { return starts_with(file, magic); });
}

bool is_text(Bytes file) {
  const auto head = file.first(std::min<std::size_t>(file.size(), 4096));
  return !head.empty() &&
         std::ranges::none_of(head, [](std::uint8_t c) { return c < 9 || (c > 13 && c < 32 && c != 26); });
}

bool is_ending(const Candidate& c, std::initializer_list<std::string_view> endings) {
  return std::ranges::find(endings, c.ending) != endings.end();
}

// A file of ROS 2 that was compressed as a whole: "walk_0.db3.zstd".
bool is_compressed_bag(const Candidate& c, std::string_view ending) {
  return starts_with(c.bytes, "\x28\xB5\x2F\xFD"sv) && c.ending == ".zstd" &&
         lower(c.path.stem().extension().string()) == ending;
}

std::shared_ptr<const FrameSource> open_capture(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                                Report& report) {
  const auto source = std::make_shared<const VelodynePcapSource>(path, options, run);
  report = source->report();
  return source;
}

std::shared_ptr<const FrameSource> open_lvx(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                            Report& report) {
  const auto source = std::make_shared<const LvxSource>(path, options, run);
  report = source->report();
  return source;
}

std::shared_ptr<const FrameSource> open_folder(const fs::path& path, const FrameSourceOptions& options, const Run& run,
                                               Report& report) {
  const auto folder = FrameFolderSource::find_frames(path);
  if (!folder) throw bad_input("the folder '" + path.string() + "' holds no frames", format_list(FileContent::scan));
  const auto source = std::make_shared<const FrameFolderSource>(*folder, options, run);
  report = source->report();
  return source;
}

template <LasPacking packing>
void write_las_cloud(const fs::path& path, const PointCloud& cloud, const Run& run, Report* report) {
  LasWriteOptions options;
  options.packing = packing;
  write_las(path, cloud, options, run, report);
}

template <std::size_t layout>
bool matches_layout(const Candidate& candidate) {
  return view_layouts()[layout].matches(candidate.path);
}

// A row for each layout of views.
template <std::size_t... layouts>
void add_view_layouts(std::vector<Format>& rows, std::index_sequence<layouts...>) {
  (rows.push_back({.name = view_layouts()[layouts].title,
                   .note = view_layouts()[layouts].note,
                   .endings = {".png", ".jpg"},
                   .folder = true,
                   .matches = matches_layout<layouts>,
                   .access = ViewsAccess{open_views},
                   .fuzz_target = "views"}),
   ...);
}

std::vector<Format> make_formats() {
  std::vector<Format> rows;

  // Scans and clouds that are known by their first bytes.
  rows.push_back({.name = "COPC",
                  .endings = {".copc.laz"},
                  .matches = [](const Candidate& c) { return is_laz(c.bytes) && copc::looks_like_copc(c.bytes); },
                  .access = CloudAccess{.read = read_las_cloud, .write = write_las_cloud<LasPacking::copc>},
                  .fuzz_target = "copc"});
  rows.push_back({.name = "LAZ",
                  .endings = {".laz"},
                  .matches = [](const Candidate& c) { return is_laz(c.bytes); },
                  .access = CloudAccess{.read = read_las_cloud, .write = write_las_cloud<LasPacking::laz>},
                  .fuzz_target = "las"});
  rows.push_back({.name = "LAS",
                  .endings = {".las"},
                  .matches = [](const Candidate& c) { return is_las(c.bytes); },
                  .access = CloudAccess{.read = read_las_cloud, .write = write_las_cloud<LasPacking::plain>},
                  .fuzz_target = "las"});
  rows.push_back({.name = "E57",
                  .endings = {".e57"},
                  .matches = [](const Candidate& c) { return e57::looks_like_e57(c.bytes); },
                  .access = CloudAccess{.read = read_e57},
                  .fuzz_target = "e57"});
  rows.push_back({.name = "PLY",
                  .endings = {".ply"},
                  .matches = [](const Candidate& c) { return looks_like_ply(c.bytes); },
                  .access = CloudAccess{.read = read_ply,
                                        .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                                    Report*) { write_ply(path, cloud, run); }},
                  .fuzz_target = "ply"});
  rows.push_back({.name = "PCD",
                  .endings = {".pcd"},
                  .matches = [](const Candidate& c) { return looks_like_pcd(c.bytes); },
                  .access = CloudAccess{.read = read_pcd},
                  .fuzz_target = "pcd"});

  // Scans and clouds whose ending decides where the content does not.
  rows.push_back({.name = "LVX",
                  .note = "Livox, .lvx and .lvx2",
                  .endings = {".lvx", ".lvx2"},
                  .matches = [](const Candidate& c) { return looks_like_lvx(c.bytes); },
                  .access = ScanAccess{open_lvx},
                  .fuzz_target = "lvx"});
  rows.push_back(
      {.name = "Ouster capture",
       .note = "with the JSON file of the sensor",
       .endings = {".pcap", ".pcapng"},
       .matches = [](const Candidate& c) { return is_capture(c.bytes) && looks_like_ouster_capture(c.bytes); },
       .access = ScanAccess{open_ouster_capture},
       .fuzz_target = "ouster"});
  rows.push_back(
      {.name = "Hesai capture",
       .note = "PandarXT-32, Pandar40P",
       .endings = {".pcap", ".pcapng"},
       .matches = [](const Candidate& c) { return is_capture(c.bytes) && looks_like_hesai_capture(c.bytes); },
       .access = ScanAccess{open_hesai_capture},
       .fuzz_target = "hesai"});
  rows.push_back({.name = "Velodyne capture",
                  .endings = {".pcap", ".pcapng", ".cap"},
                  .matches =
                      [](const Candidate& c) {
                        return is_capture(c.bytes) || is_ending(c, {".pcap", ".pcapng", ".cap"});
                      },
                  .access = ScanAccess{open_capture},
                  .fuzz_target = "pcap"});
  rows.push_back({.name = "ROS 1 bag",
                  .endings = {".bag"},
                  .matches = [](const Candidate& c) { return is_ros1_bag(c.bytes); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "ros1_bag"});
  rows.push_back({.name = "MCAP",
                  .endings = {".mcap"},
                  .matches = [](const Candidate& c) { return is_mcap(c.bytes) || is_compressed_bag(c, ".mcap"); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "mcap"});
  rows.push_back({.name = "ROS 2 bag",
                  .endings = {".db3"},
                  .matches = [](const Candidate& c) { return is_sqlite(c.bytes) || is_compressed_bag(c, ".db3"); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "db3"});
  add_view_layouts(rows, std::make_index_sequence<choice_names(ViewLayout{}).size()>());
  rows.push_back({.name = "folder of a ROS 2 bag",
                  .endings = {".db3", ".mcap"},
                  .folder = true,
                  .matches = [](const Candidate& c) { return is_bag_folder(c.path); },
                  .access = ScanAccess{open_bag_source, true},
                  .fuzz_target = "db3"});
  rows.push_back({.name = "folder of frames",
                  .endings = {".bin", ".pcd"},
                  .folder = true,
                  .matches = [](const Candidate& c) { return FrameFolderSource::find_frames(c.path).has_value(); },
                  .access = ScanAccess{open_folder},
                  .fuzz_target = "kitti_frame"});
  rows.push_back({.name = "PTX",
                  .endings = {".ptx"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".ptx"}) && looks_like_ptx(c.bytes); },
                  .access = CloudAccess{.read = read_ptx},
                  .fuzz_target = "ptx"});
  rows.push_back(
      {.name = "KITTI frame",
       .endings = {".bin"},
       .matches = [](const Candidate& c) { return is_ending(c, {".bin"}) && looks_like_kitti_frame(c.bytes); },
       .access = CloudAccess{.read = read_kitti_frame},
       .fuzz_target = "kitti_frame"});
  rows.push_back({.name = "CSV",
                  .endings = {".csv"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".csv"}) && is_text(c.bytes); },
                  .access = CloudAccess{.read = read_text_cloud,
                                        .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                                    Report*) { write_csv_cloud(path, cloud, 4, run); }},
                  .fuzz_target = "text"});
  rows.push_back({.name = "PTS",
                  .endings = {".pts"},
                  .matches = [](const Candidate& c) { return is_ending(c, {".pts"}) && is_text(c.bytes); },
                  .access = CloudAccess{.read = read_text_cloud},
                  .fuzz_target = "text"});
  rows.push_back(
      {.name = "XYZ",
       .endings = {".xyz", ".txt", ".asc"},
       .matches =
           [](const Candidate& c) {
             return is_text(c.bytes) && (is_ending(c, {".xyz", ".txt", ".asc"}) || holds_text_points(c.bytes));
           },
       .access = CloudAccess{.read = read_text_cloud,
                             .write = [](const fs::path& path, const PointCloud& cloud, const Run& run,
                                         Report*) { write_xyz_cloud(path, cloud, 4, run); }},
       .fuzz_target = "text"});

  // Tables, tracks and trajectories are told apart by the stage that reads them, then by their content.
  rows.push_back(
      {.name = "CSV",
       .note = "with a header line",
       .endings = {".csv"},
       .matches = [](const Candidate&) { return true; },
       .access = TableAccess{.read = read_table,
                             .write = [](const fs::path& path, const Table& table) { write_table(path, table); }},
       .fuzz_target = "table"});
  rows.push_back({.name = "NMEA",
                  .note = "log of a receiver",
                  .endings = {".nmea", ".log", ".txt"},
                  .matches = [](const Candidate& c) { return looks_like_nmea(c.bytes); },
                  .access = TrackAccess{read_nmea_track},
                  .fuzz_target = "track"});
  rows.push_back({.name = "CSV",
                  .note = "with a header line",
                  .endings = {".csv"},
                  .matches = [](const Candidate& c) { return has_header_line(c.bytes); },
                  .access = TrackAccess{read_csv_track},
                  .fuzz_target = "track"});
  rows.push_back({.name = "columns",
                  .note = "of numbers, without names",
                  .endings = {".txt"},
                  .matches = [](const Candidate&) { return true; },
                  .access = TrackAccess{read_column_track},
                  .fuzz_target = "track"});
  rows.push_back(
      {.name = "SBET",
       .note = "binary, longitude and latitude",
       .endings = {".out", ".sbet"},
       .matches = [](const Candidate& c) { return !is_text(c.bytes) && looks_like_sbet(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_sbet(file, name); }},
       .fuzz_target = "trajectory"});
  rows.push_back(
      {.name = "named",
       .note = "columns with a header line: GeoSLAM, HDMapping, CSV",
       .endings = {".txt", ".csv", ".traj"},
       .matches = [](const Candidate& c) { return looks_like_named_trajectory(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file,
                                             const std::string& name) { return read_named_trajectory(file, name); }},
       .fuzz_target = "trajectory"});
  rows.push_back(
      {.name = "TUM",
       .note = "time tx ty tz qx qy qz qw",
       .endings = {".tum", ".txt"},
       .matches = [](const Candidate& c) { return !looks_like_kitti_poses(c.bytes); },
       .access = TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_tum(file, name); },
                                  .write = write_tum},
       .fuzz_target = "table"});
  rows.push_back(
      {.name = "KITTI",
       .note = "12 numbers per pose",
       .endings = {".txt"},
       .matches = [](const Candidate& c) { return looks_like_kitti_poses(c.bytes); },
       .access =
           TrajectoryAccess{.read = [](Bytes file, const std::string& name) { return read_kitti_poses(file, name); },
                            .write = write_kitti_poses},
       .fuzz_target = "table"});
  return rows;
}

// Files that people take for scans or clouds and that cannot be read.
struct ForeignFile {
  std::string_view magic, name, remedy;
};
constexpr std::array foreign_files{ForeignFile{"PK\x03\x04"sv, "a compressed archive", "Unpack it first"},
                                   ForeignFile{"\x1F\x8B"sv, "a compressed archive", "Unpack it first"},
                                   ForeignFile{"7z\xBC\xAF"sv, "a compressed archive", "Unpack it first"},
                                   ForeignFile{"\x89HDF"sv, "an HDF5 file", "Export it as LAS or PLY"}};

std::string article(std::string_view noun) { return "a " + std::string(noun); }

const Format* first_match(const Candidate& candidate, bool folder, std::span<const FileContent> among) {
  for (const auto& format : formats())
    if ((format.folder == folder || format.content() == FileContent::views) &&
        std::ranges::find(among, format.content()) != among.end() && format.matches(candidate))
      return &format;
  return nullptr;
}

[[noreturn]] void refuse(Bytes file, const fs::path& name, std::string_view wanted, const std::string& list) {
  if (file.empty()) throw bad_input("the file is empty", article(wanted));
  for (const auto& foreign : foreign_files)
    if (starts_with(file, foreign.magic))
      throw bad_input("this is " + std::string(foreign.name), list, std::string(foreign.remedy));
  if (name.extension() == ".bin")
    throw bad_input("this is no KITTI frame (" + std::to_string(file.size()) +
                        " bytes): a .bin file holds nothing but "
                        "points of four 32-bit numbers, within 2 km of the sensor",
                    list);
  throw bad_input("the format of this file is not known (" + std::to_string(file.size()) + " bytes, ending '" +
                      name.extension().string() + "')",
                  list);
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) out += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  return out;
}

// "XYZ (.xyz, .txt)", and "LAS" alone where the name says the ending.
std::string described(const Format& format) {
  std::string bracket(format.note);
  if (bracket.empty() && !(format.endings.size() == 1 && format.endings[0].substr(1) == format.word()))
    for (const auto ending : format.endings) bracket += (bracket.empty() ? "" : ", ") + std::string(ending);
  return std::string(format.name) + (bracket.empty() ? "" : " (" + bracket + ")");
}

}  // namespace

std::string_view content_name(FileContent content) {
  constexpr std::array names{"scan"sv, "point cloud"sv, "table"sv, "track"sv, "trajectory"sv, "folder of views"sv};
  return names[static_cast<std::size_t>(content)];
}

std::string_view stage_of(FileContent content) {
  constexpr std::array names{"io.read_scan"sv,  "io.read_cloud"sv,      "io.read_table"sv,
                             "io.read_track"sv, "io.read_trajectory"sv, "io.read_views"sv};
  return names[static_cast<std::size_t>(content)];
}

std::string Format::word() const { return lower(name); }

bool Format::has_ending(std::string_view ending) const { return std::ranges::find(endings, ending) != endings.end(); }

bool Format::writable() const {
  return std::visit(
      [](const auto& a) {
        if constexpr (requires { a.write; })
          return a.write != nullptr;
        else
          return false;
      },
      access);
}

std::span<const Format> formats() {
  static const std::vector<Format> rows = make_formats();
  return rows;
}

const Format* find_format(Bytes file, const fs::path& name, std::span<const FileContent> among) {
  return first_match({name, file, ending_of(name)}, false, among);
}

const Format* find_format(const fs::path& path, std::span<const FileContent> among) {
  std::error_code ignored;
  const Candidate by_name{path, {}, ending_of(path)};
  if (fs::is_directory(path, ignored)) return first_match(by_name, true, among);
  if (fs::exists(path, ignored)) return find_format(MappedFile(path).bytes(), path, among);
  for (const auto& format : formats())
    if (!format.folder && std::ranges::find(among, format.content()) != among.end() &&
        format.has_ending(by_name.ending))
      return &format;
  return nullptr;
}

const Format& require_format(const fs::path& path) {
  if (const auto* format = find_format(path)) return *format;
  std::error_code ignored;
  const auto list = format_list(scans_and_clouds);
  if (fs::is_directory(path, ignored)) throw bad_input("the folder '" + path.string() + "' holds no frames", list);
  if (!fs::exists(path, ignored)) throw bad_input("there is no file or folder '" + path.string() + "'", list);
  try {
    refuse(MappedFile(path).bytes(), path, "scan or a point cloud", list);
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

const Format& require_format(FileContent content, Bytes file, const fs::path& name) {
  const auto* format = find_format(file, name);
  if (format != nullptr && format->content() == content) return *format;
  if (format != nullptr && !file.empty())
    throw bad_input("this is a " + std::string(content_name(format->content())) + ": " + std::string(format->name),
                    article(content_name(content)), "Read it with the stage " + std::string(format->stage()));
  refuse(file, name, content_name(content), format_list(content));
}

const Format& require_format(FileContent content, const fs::path& path) {
  std::error_code ignored;
  const auto found = "'" + path.string() + "'";
  if (!fs::exists(path, ignored)) throw bad_input("there is no " + found, format_list(content));
  if (!fs::is_directory(path, ignored)) {
    try {
      return require_format(content, MappedFile(path).bytes(), path);
    } catch (const Error& e) {
      throw e.at(found);
    }
  }
  const auto* format = find_format(path);
  if (format == nullptr) throw bad_input("the folder " + found + " holds no frames", format_list(content));
  if (format->content() != content)
    throw bad_input(found + " is a " + std::string(format->name), article(content_name(content)),
                    "Read it with the stage " + std::string(format->stage()));
  return *format;
}

const Format& format_named(FileContent content, std::string_view name) {
  for (const auto& format : formats())
    if (format.content() == content && format.word() == lower(name)) return format;
  throw bad_input("there is no format '" + std::string(name) + "' of a " + std::string(content_name(content)),
                  format_list(content));
}

const Format& written_format(FileContent content, const fs::path& path) {
  const auto ending = ending_of(path);
  std::vector<std::string> endings;
  for (const auto& format : formats()) {
    if (format.content() != content || !format.writable()) continue;
    if (format.has_ending(ending)) return format;
    endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  }
  throw bad_input(
      "a " + std::string(content_name(content)) + " cannot be written as '" + path.extension().string() + "'",
      joined(endings));
}

std::string format_list(std::span<const FileContent> contents) {
  std::vector<std::string> names;
  for (const auto content : contents)
    for (const auto& format : formats())
      if (format.content() == content) names.push_back(described(format));
  return joined(names);
}

std::string format_list(FileContent content) { return format_list(std::span(&content, 1)); }

std::vector<std::string> file_patterns(std::span<const FileContent> contents) {
  std::vector<std::string> patterns;
  for (const auto& format : formats()) {
    if (format.folder || std::ranges::find(contents, format.content()) == contents.end()) continue;
    for (const auto ending : format.endings)
      if (const auto pattern = "*" + std::string(ending); std::ranges::find(patterns, pattern) == patterns.end())
        patterns.push_back(pattern);
  }
  return patterns;
}

}  // namespace bole::io
