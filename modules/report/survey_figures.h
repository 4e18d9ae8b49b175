// Which figures a survey has.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/run.h"
#include "render/draw/figure.h"
#include "report/report_options.h"
#include "report/survey_data.h"

namespace bole::report {

// A figure still to be made: making may take seconds (3-D maps) and may throw.
struct FigurePlan {
  std::string name;                                   // for messages
  std::function<std::vector<render::Figure>()> make;  // one, or the pages of a sheet
  bool wide = true;                                   // over the whole page of the report
  bool picture = false;                               // embedded as pixels even where it could be vector
  double share = 1;                                   // of the time that all figures take, about
  bool on_page = true;                                // in report.html too
  double dpi = 0;                                     // of the PNG where it is not that of the options
};

// Those that the connected inputs allow, in the order of the report. `data`, `options` and `run` must outlive the
// plans.
std::vector<FigurePlan> survey_figures(const SurveyData& data, const ReportOptions& options, const Run& run);

}  // namespace bole::report
