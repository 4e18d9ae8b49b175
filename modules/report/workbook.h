// The survey as a workbook for people who go on in a spreadsheet.
#pragma once

#include <filesystem>
#include <vector>

#include "base/run.h"
#include "report/survey_data.h"

namespace bole::report {

// Sheets: Plot (values as on the page), Plot values (the same unrounded, with intervals), Classes (of diameter), Height
// curve, Trees (stem table), Sections, Rejected, Edits, Options (all stages that ran before, by `run.record`). Those
// whose input is not connected or has no rows are left out; Trees is always there. Numbers are numbers; a missing one
// is an empty cell. Throws Error{failed} where the file cannot be written.
void write_workbook(const std::filesystem::path& path, const SurveyData& data, const Run& run);

// A sheet per table, and Options. Tables without columns are left out.
struct NamedTable {
  const char* sheet;
  const Table* table;
};
void write_workbook(const std::filesystem::path& path, const std::vector<NamedTable>& tables, const Run& run);

}  // namespace bole::report
