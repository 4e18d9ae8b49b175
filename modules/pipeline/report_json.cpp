#include "pipeline/report_json.h"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/verdict.h"

namespace bole::pipeline {
namespace {

using nlohmann::ordered_json;

constexpr std::array<std::string_view, 3> status_names{"ok", "finished_early", "warning"};

// The unit whose symbol it is; symbols are unique.
Unit unit_from_symbol(std::string_view symbol) {
  for (int i = 0; i <= static_cast<int>(Unit::mebibyte); ++i)
    if (unit_symbol(static_cast<Unit>(i)) == symbol) return static_cast<Unit>(i);
  throw bad_input("unit '" + std::string(symbol) + "'", "a unit of Bole");
}

Finding finding_from_json(const ordered_json& j) {
  Finding finding{j.at("code").get<std::string>(), Severity::note, j.at("text").get<std::string>()};
  const auto name = j.at("severity").get<std::string>();
  for (const auto severity : {Severity::look, Severity::refused})
    if (severity_name(severity) == name) finding.severity = severity;
  return finding;
}

}  // namespace

std::string_view status_name(Status status) { return status_names[static_cast<std::size_t>(status)]; }

ordered_json finding_to_json(const Finding& finding) {
  return {{"code", finding.code}, {"severity", severity_name(finding.severity)}, {"text", finding.text}};
}

ordered_json report_to_json(const Report& report) {
  ordered_json j{{"status", status_name(report.status)},
                 {"message", report.message},
                 {"seconds", report.seconds},
                 {"peak_mib", report.peak_mib}};
  j["counts"] = report.counts;
  j["metrics"] = ordered_json::object();
  for (const auto& [name, metric] : report.metrics) {
    j["metrics"][name] = {{"value", nullptr}, {"unit", unit_symbol(metric.unit)}};
    if (std::isfinite(metric.value))
      j["metrics"][name]["value"] = metric.value;  // JSON has no NaN: null says "not known"
  }
  j["facts"] = report.facts;
  j["warnings"] = report.warnings;
  j["findings"] = ordered_json::array();
  for (const auto& finding : report.findings) j["findings"].push_back(finding_to_json(finding));
  return j;
}

Report report_from_json(const ordered_json& j) {
  Report report;
  const auto status = j.at("status").get<std::string>();
  for (std::size_t i = 0; i < status_names.size(); ++i)
    if (status_names[i] == status) report.status = static_cast<Status>(i);
  report.message = j.at("message").get<std::string>();
  report.seconds = j.at("seconds").get<double>();
  report.peak_mib = j.at("peak_mib").get<double>();
  report.counts = j.at("counts").get<std::map<std::string, std::int64_t>>();
  for (const auto& [name, metric] : j.at("metrics").items()) {
    const auto& value = metric.at("value");
    report.metrics[name] = {value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(),
                            unit_from_symbol(metric.at("unit").get<std::string>())};
  }
  report.facts = j.at("facts").get<std::map<std::string, std::string>>();
  report.warnings = j.at("warnings").get<std::vector<std::string>>();
  for (const auto& finding : j.at("findings")) report.findings.push_back(finding_from_json(finding));
  return report;
}

}  // namespace bole::pipeline
