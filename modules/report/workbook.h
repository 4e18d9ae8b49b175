// The survey as a workbook for people who go on in a spreadsheet.
#pragma once

#include <filesystem>

#include "base/run.h"
#include "report/report_options.h"
#include "report/survey_data.h"

namespace bole::report {

// Sheets: Plot (values per hectare), Classes (of diameter), Trees (stem table), Sections, Rejected, Edits, Options (all
// stages that ran before, by `run.record`); those without rows are left out, Plot and Trees are always there. Numbers
// are numbers; a missing one is an empty cell. Throws Error{failed} when the file cannot be written.
void write_workbook(const std::filesystem::path& path, const SurveyData& data, const ReportOptions& options,
                    const Run& run);

}  // namespace bole::report
