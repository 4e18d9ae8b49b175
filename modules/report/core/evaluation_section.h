// The part of the report that holds the survey against a reference.
#pragma once

#include <string>

#include "cloud/table.h"

namespace bole::report {

// `summary`: measure, value, unit, published (evaluation.plot). Both give empty HTML where the table has nothing for
// them.
// Detection, position, diameters and heights of the trees.
std::string evaluation_html(const Table& summary);

// The path of the scanner, and measures without a name of their own. `poses_given`: the poses were an input of the run
// and not computed by it; errors of the walk that are nothing then say so.
std::string walk_evaluation_html(const Table& summary, bool poses_given);

}  // namespace bole::report
