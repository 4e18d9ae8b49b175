// The one table of file formats. Dispatch, messages, help, file dialogs, drag and drop and the list of fuzz targets
// come from it: a new format is a row of scan_format_rows.cpp or table_format_rows.cpp.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/clouds/cloud_reader.h"
#include "io/core/scans/frame_source.h"
#include "io/core/tables/track_file.h"
#include "io/core/views/open_views.h"

namespace bole::io {

// What a file holds. The order is that of the alternatives of Format::access.
enum class FileContent { scan, cloud, table, track, trajectory, views };
inline constexpr std::array all_contents{FileContent::scan,  FileContent::cloud,      FileContent::table,
                                         FileContent::track, FileContent::trajectory, FileContent::views};

std::string_view content_name(FileContent content);          // "point cloud"
std::string_view content_with_article(FileContent content);  // "a point cloud"
std::string_view stage_of(FileContent content);              // "io.read_cloud"

// How each kind of content is read, and written where `write` is not null.
struct ScanAccess {
  std::shared_ptr<const FrameSource> (*open)(const std::filesystem::path& path, const FrameSourceOptions& options,
                                             const Run& run, Report& report) = nullptr;
  bool has_topics = false;  // a recording of many sensors: the option topic names one
};
struct CloudAccess {
  CloudReading (*read)(Bytes file, const CloudReadOptions& options, const Run& run) = nullptr;
  bool has_pieces = false;  // `read` respects CloudReadOptions::piece
  // Warnings go to `report` where it is not null.
  void (*write)(const std::filesystem::path& path, const PointCloud& cloud, const Run& run, Report* report) = nullptr;
};
struct TableAccess {
  Table (*read)(Bytes file, const std::string& name, const Run& run) = nullptr;
  void (*write)(const std::filesystem::path& path, const Table& table) = nullptr;
};
struct TrackAccess {
  Table (*read)(Bytes file, const std::string& name, const TrackOptions& options, Report& report,
                const Run& run) = nullptr;
};
struct TrajectoryAccess {
  Trajectory (*read)(Bytes file, const std::string& name) = nullptr;
  void (*write)(const std::filesystem::path& path, const Trajectory& trajectory) = nullptr;
};
// Folders, and files that stand for one: rows of views know both.
struct ViewsAccess {
  std::shared_ptr<const ViewSource> (*open)(const std::filesystem::path& path, const ReadViewsOptions& options,
                                            const Run& run, Report& report) = nullptr;
};

// What a probe sees.
struct Candidate {
  const std::filesystem::path& path;  // of a file in memory: its name
  Bytes bytes;                        // empty for a folder and for a file that cannot be opened
  std::string ending;                 // of the path, in lower case, with the dot
};

struct Format {
  std::string_view name{};                  // as messages and forms print it: "LAS"
  std::string_view note{};                  // printed behind the name; where it is empty, the endings are
  std::vector<std::string_view> endings{};  // in lower case, with the dot; of a folder: those of the files in it
  bool folder = false;
  bool (*matches)(const Candidate& candidate) = nullptr;
  std::variant<ScanAccess, CloudAccess, TableAccess, TrackAccess, TrajectoryAccess, ViewsAccess> access{};
  std::string_view fuzz_target{};  // tests/fuzz/NAME_fuzz.cpp

  FileContent content() const { return static_cast<FileContent>(access.index()); }
  std::string_view stage() const { return stage_of(content()); }
  std::string word() const;  // the name in lower case, as options and reports have it
  bool has_ending(std::string_view ending) const;
  bool writable() const;
};

// Rows are asked in this order, so that formats known by their first bytes come before those known by their ending.
std::span<const Format> formats();

// The contents that the window opens, and those that `bole info` describes.
inline constexpr std::array scans_and_clouds{FileContent::scan, FileContent::cloud};
inline constexpr std::array described_contents{FileContent::scan, FileContent::cloud, FileContent::views};

// The first format with one of these contents that recognises the file, or null.
const Format* find_format(Bytes file, const std::filesystem::path& name,
                          std::span<const FileContent> among = scans_and_clouds);
// The same of a file or folder on disk. A path that does not exist is judged by its ending.
const Format* find_format(const std::filesystem::path& path, std::span<const FileContent> among = scans_and_clouds);

// As find_format() among scans and clouds, or Error{bad_input} that says what the file is instead and which formats
// there are: with `content` only formats of that content will do.
const Format& require_format(const std::filesystem::path& path);
const Format& require_format(FileContent content, const std::filesystem::path& path);
const Format& require_format(FileContent content, Bytes file, const std::filesystem::path& name);

// The format of this content with this name, in upper or lower case. Throws Error{bad_input}.
const Format& format_named(FileContent content, std::string_view name);

// The format of this content that a file with this ending is written in. Throws Error{bad_input} that lists the
// endings.
const Format& written_format(FileContent content, const std::filesystem::path& path);

// A row as lists name it: "XYZ" and ".xyz, .txt"; "LAS" and nothing, where the name says the ending.
struct ListedFormat {
  std::string name, bracket;
};
std::vector<ListedFormat> listed_formats(FileContent content);

// "LAS, LAZ or XYZ (.xyz, .txt)": for help and messages.
std::string format_list(std::span<const FileContent> contents);
std::string format_list(FileContent content);

// "*.las", "*.laz", ...: for file dialogs. Folders have none.
std::vector<std::string> file_patterns(std::span<const FileContent> contents);

}  // namespace bole::io
