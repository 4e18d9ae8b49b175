// A sheet to take into the plot: every stem with empty fields for what a person measures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/survey_data.h"

namespace bole::report {

// A page for printing: the plan with numbers, and a row for each stem in the plot with its place (distance and bearing
// from the centre of the plot, coordinates where there is no boundary) and fields for species, diameter by tape, height
// and remarks. Diameters of the survey are left out on purpose, so that the tape is read without them.
std::string tally_html(const std::string& title, const std::vector<std::pair<std::string, std::string>>& facts,
                       const SurveyData& data);

}  // namespace bole::report
