// The stems on the page: all of them, and those that a person should look at.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "report/survey_data.h"

namespace bole::report {

// Both put the numbers of rows that they list into the counts of `told`.
std::string stems_section(const SurveyData& data, Report& told);

// Warnings, stems to check, edits and rejected candidates.
std::string check_section(const SurveyData& data, const std::vector<std::string>& warnings, Report& told);

}  // namespace bole::report
