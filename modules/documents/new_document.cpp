#include "documents/new_document.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/option_text.h"
#include "base/resources.h"
#include "base/user_path.h"
#include "io/core/formats.h"

namespace bole::documents {
namespace fs = std::filesystem;
namespace {

constexpr const char* for_scans = "forest_plot";
constexpr const char* for_clouds = "stem_map_from_cloud";
constexpr const char* for_views = "seedling";
constexpr const char* only_views = R"({"title": "Views", "stages": [{"id": "frames", "type": "io.read_views"}]})";

std::string without_ending(std::string_view name) {
  return std::string(name.ends_with(".json") ? name.substr(0, name.size() - 5) : name);
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

[[noreturn]] void refuse_unknown(const std::string& path_or_name) {
  const auto names = shipped_pipelines();
  throw bad_input("there is no pipeline '" + path_or_name + "'",
                  "a pipeline document (JSON), or one that comes with Bole: " + listed(names),
                  did_you_mean(without_ending(path_or_name), names));
}

}  // namespace

fs::path pipelines_dir() { return resource_dir().parent_path() / "pipelines"; }

std::vector<std::string> shipped_pipelines() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(pipelines_dir(), ignored))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

pipeline::PipelineDocument shipped_pipeline(std::string_view name) {
  const auto path = pipelines_dir() / (without_ending(name) + ".json");
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) refuse_unknown(std::string(name));
  std::ifstream in(path);
  std::stringstream text;
  text << in.rdbuf();
  // It goes by its title: where the program was installed says nothing to who reads a report.
  return pipeline::PipelineDocument::parse(text.str(), pipeline::StageRegistry::global(), path.parent_path());
}

pipeline::PipelineDocument load_pipeline(const std::string& path_or_name) {
  const fs::path path = expand_home(path_or_name);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    if (path_or_name.find('/') != std::string::npos) refuse_unknown(path_or_name);
    return shipped_pipeline(path_or_name);
  }
  const bool is_document = path.extension() == ".json" && !fs::is_directory(path, ignored);
  if (!is_document && (fs::is_regular_file(path, ignored) || fs::is_directory(path, ignored))) {
    if (const auto* format = io::find_format(path))
      throw bad_input("'" + path.string() + "' is " + std::string(io::content_with_article(format->content())) + " (" +
                          std::string(format->name) + ")",
                      "a pipeline document (JSON)", "To survey it: bole survey " + path.string() + " --out DIR");
    if (fs::is_directory(path, ignored))
      throw bad_input("'" + path.string() + "' is a folder without frames of a scan", "a pipeline document (JSON)");
  }
  return pipeline::PipelineDocument::load(path, pipeline::StageRegistry::global());
}

pipeline::PipelineDocument document_for_file(const fs::path& path) {
  const auto& format = io::require_format(path);
  auto document = shipped_pipeline(format.content() == io::FileContent::scan ? for_scans : for_clouds);
  document.set("scan.file", fs::absolute(path).lexically_normal().string());
  return document;
}

pipeline::PipelineDocument document_for_views(const fs::path& path) {
  const auto names = shipped_pipelines();
  auto document = std::ranges::find(names, for_views) != names.end()
                      ? shipped_pipeline(for_views)
                      : pipeline::PipelineDocument::parse(only_views, pipeline::StageRegistry::global());
  document.set("frames.folder", fs::absolute(path).lexically_normal().string());
  return document;
}

}  // namespace bole::documents
