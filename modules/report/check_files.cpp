#include "report/check_files.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/report_json.h"
#include "report/core/simple_page.h"

namespace bole::report {
namespace {

using nlohmann::ordered_json;

std::string fact(const Table& table, const std::string& name) {
  const auto it = table.facts.find(name);
  return it == table.facts.end() ? std::string() : it->second;
}

ordered_json findings_json(const Table& t) {
  ordered_json all = ordered_json::array();
  const auto &code = t.texts("code"), &severity = t.texts("severity"), &text = t.texts("text");
  for (std::size_t i = 0; i < t.rows(); ++i) {
    ordered_json j{{"code", code[i]}, {"severity", severity[i]}, {"text", text[i]}};
    for (const char* column : {"x_m", "y_m", "distance_m", "bearing_deg"})
      if (const double v = t.numbers(column)[i]; std::isfinite(v)) j[column] = v;
    all.push_back(std::move(j));
  }
  return all;
}

std::string words_of(const std::string& verdict) {
  if (verdict == "sign") return "Sign: no measure speaks against it.";
  if (verdict == "look") return "Look before you sign: the findings below may or may not matter.";
  return "Walk again, or run slam again: the map is not whole.";
}

}  // namespace

std::string check_json(const SurveyData& data, const RunRecord* record) {
  ordered_json j{{"verdict", fact(*data.check, "verdict")},
                 {"findings", findings_json(*data.check)},
                 {"not_judged", fact(*data.check, "not_judged")}};
  j["measures"] = ordered_json::object();
  if (record != nullptr)
    for (const auto& stage : record->stages)
      if (stage.type == "survey.check") {
        const auto told = pipeline::report_to_json(stage.report);
        j["measures"] = told.at("metrics");
        j["counts"] = told.at("counts");
      }
  return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string check_html(const std::string& title, const SurveyData& data, const std::vector<ReportPicture>& pictures) {
  SimplePage page;
  page.title = title + ": the check of the map";
  page.paragraphs.push_back(words_of(fact(*data.check, "verdict")));
  if (const auto skipped = fact(*data.check, "not_judged"); !skipped.empty())
    page.paragraphs.push_back("Not judged - " + skipped + ".");
  Table findings = *data.check;
  std::vector<std::int64_t> number(findings.rows());
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<std::int64_t>(i) + 1;
  findings.set("number", std::move(number));
  if (findings.rows() > 0)
    page.tables.push_back(
        {"What was found",
         "Numbers as in the maps. Places in the axes of the plot; bearings from the centre, clockwise "
         "from north (y).",
         &findings,
         {{"number", "No."},
          {"severity", "severity"},
          {"text", "finding"},
          {"x_m", "x (m)"},
          {"y_m", "y (m)"},
          {"distance_m", "distance (m)"},
          {"bearing_deg", "bearing (deg)"}},
         1});
  if (data.check_boundary != nullptr && data.check_boundary->rows() > 0)
    page.tables.push_back({"Trees on the boundary",
                           "In (1) or out (0) by the rule \"" + fact(*data.check_boundary, "boundary_rule") +
                               "\". Inside: distance to the boundary, negative outside.",
                           data.check_boundary,
                           {{"tree_id", "tree"},
                            {"x_m", "x (m)"},
                            {"y_m", "y (m)"},
                            {"dbh_cm", "DBH (cm)"},
                            {"inside_m", "inside (m)"},
                            {"in", "in"},
                            {"in_doubt", "in doubt"}},
                           2});
  page.pictures = pictures;
  return simple_page_html(page);
}

}  // namespace bole::report
