// The breast-height slice of every tree as a small drawing.
#pragma once

#include <string>
#include <vector>

#include "report/survey_data.h"

namespace bole::report {

// The slices of all stems in the plot, the least certain first; each is defined here and can be shown again elsewhere.
// Empty without stems or slice.
std::string slices_section(const SurveyData& data);

// The slice of a tree that slices_section() defines, again; empty where there is none.
std::string slice_again(const SurveyData& data, const std::string& tree);

}  // namespace bole::report
