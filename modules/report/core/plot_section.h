// The values of the plot on the page.
#pragma once

#include <string>

#include "report/survey_data.h"

namespace bole::report {

// The table of values and the diameter classes. Without plot values it names the stage that makes them.
std::string plot_section(const SurveyData& data);

}  // namespace bole::report
