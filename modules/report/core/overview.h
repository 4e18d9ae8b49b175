// The first screen of a report: what was surveyed, whether it may be signed, the values of the plot, the plan, and the
// trees to look at.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/verdict.h"
#include "report/survey_data.h"

namespace bole::report {

struct OverviewContent {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;
  std::optional<Judgement> judgement;  // absent where it is not known what ran before
};

std::string overview_html(const OverviewContent& content, const SurveyData& data);

}  // namespace bole::report
