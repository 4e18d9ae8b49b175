// The part of the report that holds the survey against a reference.
#pragma once

#include <string>

#include "cloud/table.h"

namespace bole::report {

// `summary`: measure, value, unit, published (evaluation.plot). `poses_given`: the poses were an input of the run and
// not computed by it; errors of the walk that are nothing then say so. Empty HTML for an empty table.
std::string evaluation_html(const Table& summary, bool poses_given);

}  // namespace bole::report
