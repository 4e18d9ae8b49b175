#include "report/core/page_warnings.h"

namespace bole::report {

std::vector<std::string> page_warnings(const RunRecord* record, const Report& own) {
  std::vector<std::string> all;
  if (record != nullptr)
    for (const auto& stage : record->stages)
      for (const auto& w : stage.report.warnings) all.push_back(stage.id + ": " + w);
  for (const auto& w : own.warnings) all.push_back("report: " + w);
  return all;
}

}  // namespace bole::report
