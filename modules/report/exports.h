// The data files of a run.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/run.h"
#include "report/report_options.h"
#include "report/survey_data.h"

namespace bole::report {

struct Export {
  std::string file;  // name within the output folder
  std::function<void(const std::filesystem::path& path, const Run& run, Report& report)> write;
};

// Those that the connected inputs and the options allow. `data` must outlive them.
std::vector<Export> survey_exports(const SurveyData& data, const ReportOptions& options);

}  // namespace bole::report
