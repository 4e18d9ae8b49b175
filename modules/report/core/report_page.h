// The report as one HTML page that needs nothing beside it: pictures, style and the few lines of script are inside.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "report/core/picture.h"
#include "report/survey_data.h"

namespace bole::report {

struct ReportContent {
  std::string title;
  const SurveyData& data;
  const std::vector<ReportPicture>& pictures;
  std::vector<std::string> warnings;
  std::shared_ptr<const RunRecord> record;
  std::vector<std::pair<std::string, std::string>> versions;  // program, libraries
  const std::vector<std::string>& files;                      // written beside the report
  std::string view_data;                                      // of view_data_json(); empty: the page has no 3-D view
};

// The page as in a report that is read from the top: first screen, values, trees, figures, signature, and everything
// about how it was made at the end. What the page counts or adds up itself goes into the counts and metrics of `told`,
// so that summary.json has it.
std::string report_html(const ReportContent& content, Report& told);

}  // namespace bole::report
