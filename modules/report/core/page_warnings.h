// What went wrong or looks odd, of the whole run: a page that shows results shows it beside them.
#pragma once

#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"

namespace bole::report {

// "frame: the north target was not found", ...: the warnings of the stages that ran before (`record`, null: not known),
// then those of the report itself.
std::vector<std::string> page_warnings(const RunRecord* record, const Report& own);

}  // namespace bole::report
