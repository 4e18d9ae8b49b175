#include "pipeline/written_files.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/content_hash.h"
#include "pipeline/old_survey.h"

namespace bole::pipeline {
namespace fs = std::filesystem;
using nlohmann::ordered_json;

ordered_json record_of(const fs::path& file) {
  // Files that a person types into are small; reading all points of a large cloud again takes too long.
  constexpr std::uintmax_t largest_hashed = std::uintmax_t{64} << 20;
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  if (error) return nullptr;
  if (bytes > largest_hashed) return {{"bytes", bytes}};
  std::stringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  auto text = std::move(content).str();
  if (file.extension() == ".html") text = without_banner(std::move(text));
  return {{"bytes", text.size()}, {"hash", content_hash(std::as_bytes(std::span(text)))}};
}

std::set<std::string> changed_files(const fs::path& folder, const ordered_json& records) {
  std::set<std::string> changed;
  if (!records.is_object()) return changed;
  std::error_code ignored;
  for (const auto& [name, record] : records.items())
    if (fs::is_regular_file(fs::symlink_status(folder / name, ignored)) && record_of(folder / name) != record)
      changed.insert(name);
  return changed;
}

std::string name_of_changed(const fs::path& folder, const std::string& name) {
  struct stat status {};
  ::stat((folder / name).c_str(), &status);
  const fs::path path(name);
  const auto stem = (path.parent_path() / path.stem()).generic_string() +
                    fmt::format(".changed-{:%Y-%m-%dT%H%M%SZ}", fmt::gmtime(status.st_mtime));
  std::error_code ignored;
  std::string free = stem + path.extension().string();
  for (int n = 2; fs::exists(fs::symlink_status(folder / free, ignored)); ++n)
    free = fmt::format("{}-{}{}", stem, n, path.extension().string());
  return free;
}

}  // namespace bole::pipeline
