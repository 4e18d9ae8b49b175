// What survey.check found, as files of a report: check.json, check.html and the tables.
#pragma once

#include <string>
#include <vector>

#include "base/run.h"
#include "report/core/picture.h"
#include "report/survey_data.h"

namespace bole::report {

// {"verdict": "sign", "findings": [{"code", "severity", "text", "x_m", "y_m", "distance_m", "bearing_deg"}],
//  "not_judged": "...", "measures": {"ground_unseen": {"value": 0.2, "unit": "%"}}}. What has no place has no x_m.
// Needs data.check. `record`: of the run, for the measures; may be null.
std::string check_json(const SurveyData& data, const RunRecord* record);

// One page: verdict, findings with where to go, trees on the boundary, a map per measure.
std::string check_html(const std::string& title, const SurveyData& data, const std::vector<ReportPicture>& pictures);

}  // namespace bole::report
