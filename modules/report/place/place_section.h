// Where the plot lies on the earth: control points with their residuals.
#pragma once

#include <string>

#include "base/run.h"
#include "report/survey_data.h"

namespace bole::report {

// Empty where the plot was not georeferenced. `record` gives what the stage survey.georeference said; null outside a
// pipeline.
std::string place_section(const SurveyData& data, const RunRecord* record);

}  // namespace bole::report
