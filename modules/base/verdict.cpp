#include "base/verdict.h"

#include <algorithm>
#include <array>

namespace bole {
inline namespace base {
namespace {

bool is_finding(const Report& report, const std::string& warning) {
  return std::ranges::any_of(report.findings, [&](const Finding& f) { return f.text == warning; });
}

std::vector<Finding> findings_of(const StageRecord& stage) {
  const Report& report = stage.report;
  auto all = report.findings;
  for (const auto& warning : report.warnings)
    if (!is_finding(report, warning)) all.push_back({"warning", Severity::note, warning});
  if (report.status == Status::finished_early)
    all.push_back({finding_code::finished_early, Severity::look, "ended early: the result is not complete"});
  return all;
}

Verdict verdict_for(Severity worst) {
  switch (worst) {
    case Severity::refused:
      return Verdict::refused;
    case Severity::look:
      return Verdict::look;
    default:
      return Verdict::sign;
  }
}

}  // namespace

bool has_finding(const Report& report, std::string_view code) {
  return std::ranges::any_of(report.findings, [code](const Finding& f) { return f.code == code; });
}

std::string_view severity_name(Severity severity) {
  constexpr std::array<std::string_view, 3> names{"note", "look", "refused"};
  return names[static_cast<std::size_t>(severity)];
}

std::string_view verdict_name(Verdict verdict) {
  constexpr std::array<std::string_view, 3> names{"sign", "look", "refused"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string verdict_headline(Verdict verdict, std::size_t trees_to_look_at) {
  switch (verdict) {
    case Verdict::sign:
      return trees_to_look_at == 0 ? std::string("Nothing speaks against signing")
                                   : "Sign after a look at " + std::to_string(trees_to_look_at) +
                                         (trees_to_look_at == 1 ? " tree" : " trees");
    case Verdict::look:
      return "Look before you sign";
    case Verdict::refused:
      return "Do not use these values";
  }
  return {};
}

namespace {

// The check of the map looks at the whole survey once more: what another stage has found under the same code is listed
// once, by the more severe of the two.
constexpr const char* check_type = "survey.check";

void add_of_check(StageFinding found, std::vector<StageFinding>& all) {
  const auto same = std::ranges::find(all, found.finding.code, [](const StageFinding& f) { return f.finding.code; });
  if (same == all.end())
    all.push_back(std::move(found));
  else if (same->finding.severity < found.finding.severity)
    *same = std::move(found);
}

}  // namespace

Judgement judge(const std::vector<StageRecord>& stages) {
  Judgement out;
  std::vector<StageFinding> of_check;
  for (const auto& stage : stages)
    for (auto& finding : findings_of(stage))
      (stage.type == check_type ? of_check : out.findings).push_back({stage.id, std::move(finding)});
  for (auto& found : of_check) add_of_check(std::move(found), out.findings);
  std::ranges::stable_sort(out.findings, std::ranges::greater{},
                           [](const StageFinding& f) { return f.finding.severity; });
  if (!out.findings.empty()) out.verdict = verdict_for(out.findings.front().finding.severity);
  return out;
}

}  // namespace base
}  // namespace bole
