#include "io/core/formats.h"

#include <algorithm>

#include "base/error.h"
#include "io/core/format_probes.h"
#include "io/core/format_rows.h"

namespace bole::io {
namespace {

using namespace std::string_view_literals;
namespace fs = std::filesystem;

std::vector<Format> make_formats() {
  std::vector<Format> rows;
  add_scan_formats(rows);
  add_table_formats(rows);
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

const Format* first_match(const Candidate& candidate, bool folder, std::span<const FileContent> among) {
  for (const auto& format : formats())
    if ((format.folder == folder || format.content() == FileContent::views) &&
        std::ranges::find(among, format.content()) != among.end() && format.matches(candidate))
      return &format;
  return nullptr;
}

[[noreturn]] void refuse(Bytes file, const fs::path& name, std::string_view wanted, const std::string& list) {
  if (file.empty()) throw bad_input("the file is empty", std::string(wanted));
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

}  // namespace

std::string_view content_with_article(FileContent content) {
  constexpr std::array names{"a scan"sv,  "a point cloud"sv, "a table"sv,
                             "a track"sv, "a trajectory"sv,  "a folder of views"sv};
  return names[static_cast<std::size_t>(content)];
}

std::string_view content_name(FileContent content) { return content_with_article(content).substr(2); }

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
    refuse(MappedFile(path).bytes(), path, "a scan or a point cloud", list);
  } catch (const Error& e) {
    throw e.at("'" + path.string() + "'");
  }
}

const Format& require_format(FileContent content, Bytes file, const fs::path& name) {
  const auto* format = find_format(file, name);
  if (format != nullptr && format->content() == content) return *format;
  if (format != nullptr && !file.empty())
    throw bad_input(
        "this is " + std::string(content_with_article(format->content())) + ": " + std::string(format->name),
        std::string(content_with_article(content)), "Read it with the stage " + std::string(format->stage()));
  refuse(file, name, content_with_article(content), format_list(content));
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
    throw bad_input(found + " is a " + std::string(format->name), std::string(content_with_article(content)),
                    "Read it with the stage " + std::string(format->stage()));
  return *format;
}

const Format& format_named(FileContent content, std::string_view name) {
  for (const auto& format : formats())
    if (format.content() == content && format.word() == lower(name)) return format;
  throw bad_input("there is no format '" + std::string(name) + "' of " + std::string(content_with_article(content)),
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
      std::string(content_with_article(content)) + " cannot be written as '" + path.extension().string() + "'",
      joined(endings));
}

std::vector<ListedFormat> listed_formats(FileContent content) {
  std::vector<ListedFormat> list;
  for (const auto& format : formats()) {
    if (format.content() != content) continue;
    std::string bracket(format.note);
    if (bracket.empty() && !(format.endings.size() == 1 && format.endings[0].substr(1) == format.word()))
      for (const auto ending : format.endings) bracket += (bracket.empty() ? "" : ", ") + std::string(ending);
    list.push_back({std::string(format.name), std::move(bracket)});
  }
  return list;
}

std::string format_list(std::span<const FileContent> contents) {
  std::vector<std::string> names;
  for (const auto content : contents)
    for (const auto& [name, bracket] : listed_formats(content))
      names.push_back(name + (bracket.empty() ? "" : " (" + bracket + ")"));
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
