#include "vtkbridge/summary.h"

#include <vtkVersion.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>

#include "base/memory.h"
#include "base/verdict.h"
#include "base/version.h"
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

ordered_json cell_json(const Table::Values& values, std::size_t row) {
  if (const auto* texts = std::get_if<std::vector<std::string>>(&values)) return (*texts)[row];
  if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&values)) return (*whole)[row];
  const double value = std::get<std::vector<double>>(values)[row];
  return std::isfinite(value) ? ordered_json(value) : ordered_json();  // JSON has no NaN: null says "not known"
}

// A list of rows, each with its cells by column.
ordered_json table_json(const Table& table) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    ordered_json row = ordered_json::object();
    for (const auto& column : table.columns()) row[column.name] = cell_json(column.values, i);
    rows.push_back(std::move(row));
  }
  return rows;
}

// Every library that takes part, by its name in small letters.
ordered_json versions_json() {
  ordered_json j{{"bole", version()}, {"vtk", vtkVersion::GetVTKVersion()}};
  for (auto [name, version] : library_versions()) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    j.emplace(name, version);
  }
  return j;
}

ordered_json stage_json(const StageOutcome& stage) {
  ordered_json j{{"id", stage.record.id}, {"type", stage.record.type}, {"state", stage_state_name(stage.state)}};
  if (!stage.error.empty()) j["error"] = stage.error;
  j["from_cache"] = stage.record.from_cache;
  j["options"] = ordered_json::object();
  j["defaults"] = ordered_json::object();
  for (const auto& option : stage.record.options)
    j[option.is_default ? "defaults" : "options"][option.name] = option.value;
  if (stage.state == StageState::done || stage.state == StageState::from_cache)
    j.update(pipeline::report_to_json(stage.record.report));
  for (const auto& [port, table] : stage.tables) j["tables"][port] = table_json(*table);
  return j;
}

std::string axes_of(const RunOutcome& outcome) {
  std::string axes = "unknown";
  for (const auto& stage : outcome.stages)
    if (const auto it = stage.record.report.facts.find("axes"); it != stage.record.report.facts.end())
      axes = it->second;
  return axes;
}

void add_judgement(ordered_json& j, const Judgement& judgement) {
  j["verdict"] = verdict_name(judgement.verdict);
  j["findings"] = ordered_json::array();
  for (const auto& [stage, finding] : judgement.findings) {
    auto entry = pipeline::finding_to_json(finding);
    if (!stage.empty()) entry["stage"] = stage;
    j["findings"].push_back(std::move(entry));
  }
}

}  // namespace

Judgement judgement_of(const RunOutcome& outcome) {
  std::vector<StageRecord> records;
  // A stage that failed because of what it found (an input that is not whole) says so by the code of the finding.
  for (const auto& stage : outcome.stages)
    if (stage.state != StageState::skipped && stage.state != StageState::cancelled) records.push_back(stage.record);
  auto judgement = judge(records);
  if (outcome.exit_code == 0) return judgement;
  judgement.verdict = Verdict::refused;
  judgement.findings.insert(judgement.findings.begin(), {"", {"run_failed", Severity::refused, outcome.error}});
  return judgement;
}

std::string summary_json(const pipeline::PipelineDocument& document, const RunOutcome& outcome, double seconds,
                         const std::filesystem::path& output_dir) {
  ordered_json j{{"bole", version()},
                 {"versions", versions_json()},
                 {"finished_at", now_utc()},
                 {"exit_code", program_exit_code(outcome)}};
  if (!outcome.error.empty()) j["error"] = outcome.error;
  add_judgement(j, judgement_of(outcome));
  j["axes"] = axes_of(outcome);
  j["seconds"] = seconds;
  j["peak_mib"] = peak_resident_mib();
  j["stages"] = ordered_json::array();
  std::set<std::string> files;
  for (const auto& stage : outcome.stages) {
    j["stages"].push_back(stage_json(stage));
    for (const auto& file : stage.files)
      files.insert(std::filesystem::absolute(file).lexically_normal().lexically_relative(output_dir).generic_string());
  }
  if (!output_dir.empty()) files.insert("summary.json");
  j["files"] = files;
  j["document"] = document_json(document);
  return j.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace bole::vtkbridge
