#include "vtkbridge/summary.h"

#include <vtkVersion.h>

#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>

#include "base/memory.h"
#include "pipeline/report_json.h"

namespace bole::vtkbridge {
namespace {

using nlohmann::ordered_json;

ordered_json document_json(const pipeline::PipelineDocument& document) {
  ordered_json j{{"title", document.title()}, {"source", document.source()}};
  j["pipeline"] = ordered_json::parse(document.to_json());
  return j;
}

std::string now_utc() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

ordered_json stage_json(const StageOutcome& stage) {
  ordered_json j{{"id", stage.record.id}, {"type", stage.record.type}, {"state", stage_state_name(stage.state)}};
  if (!stage.error.empty()) j["error"] = stage.error;
  j["from_cache"] = stage.record.from_cache;
  j["options"] = ordered_json::object();
  for (const auto& option : stage.record.options)
    if (!option.is_default) j["options"][option.name] = option.value;
  if (stage.state == StageState::done || stage.state == StageState::from_cache)
    j.update(pipeline::report_to_json(stage.record.report));
  return j;
}

std::string axes_of(const RunOutcome& outcome) {
  std::string axes = "unknown";
  for (const auto& stage : outcome.stages)
    if (const auto it = stage.record.report.facts.find("axes"); it != stage.record.report.facts.end())
      axes = it->second;
  return axes;
}

}  // namespace

std::string summary_json(const pipeline::PipelineDocument& document, const RunOutcome& outcome, double seconds,
                         const std::filesystem::path& output_dir) {
  ordered_json j{{"bole", BOLE_VERSION},
                 {"versions", {{"bole", BOLE_VERSION}, {"vtk", vtkVersion::GetVTKVersion()}}},
                 {"finished_at", now_utc()},
                 {"exit_code", outcome.exit_code}};
  if (!outcome.error.empty()) j["error"] = outcome.error;
  j["axes"] = axes_of(outcome);
  j["seconds"] = seconds;
  j["peak_mib"] = peak_resident_mib();
  j["stages"] = ordered_json::array();
  std::set<std::string> files;
  for (const auto& stage : outcome.stages) {
    j["stages"].push_back(stage_json(stage));
    for (const auto& file : stage.files)
      files.insert(std::filesystem::path(file).lexically_relative(output_dir).generic_string());
  }
  if (!output_dir.empty()) files.insert("summary.json");
  j["files"] = files;
  j["document"] = document_json(document);
  return j.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace bole::vtkbridge
