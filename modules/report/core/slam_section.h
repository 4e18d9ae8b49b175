// What SLAM did, for the report: frames, loops, how well they agree, and where the time went.
#pragma once

#include <string>

#include "base/run.h"
#include "cloud/table.h"

namespace bole::report {

// HTML of a stage that tracked frames; empty for every other stage, and where the trajectory was read from a file.
// `loops` and `odometry` are its tables, or null. The sum of the times goes into the metrics of `told`.
std::string slam_html(const StageRecord& stage, const Table* loops, const Table* odometry, Report& told);

}  // namespace bole::report
