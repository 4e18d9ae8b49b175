// What SLAM did, for the report: frames, loops, how well they agree, and where the time went.
#pragma once

#include <string>

#include "base/run.h"
#include "cloud/table.h"

namespace bole::report {

// HTML of the stage slam.run; empty when it took the walk from a file. `loops` and `odometry` are its tables, or null.
std::string slam_html(const StageRecord& stage, const Table* loops, const Table* odometry);

}  // namespace bole::report
