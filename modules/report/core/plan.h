// The plan of the plot on the first screen: every stem can be pointed at and selected.
#pragma once

#include <string>

#include "report/survey_data.h"

namespace bole::report {

// An SVG element with a legend below; empty without stems.
std::string plan_html(const SurveyData& data);

}  // namespace bole::report
