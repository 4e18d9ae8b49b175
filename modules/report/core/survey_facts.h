// What was surveyed: the first lines of a report.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "report/survey_data.h"

namespace bole::report {

// Input, day of the recording, sensor, plot, coordinates, day of the report: names and values. What is not known says
// so. They go into the facts of `told` too. `record`: null where it is not known.
std::vector<std::pair<std::string, std::string>> survey_facts(const SurveyData& data, const RunRecord* record,
                                                              Report& told);

// The name of a coordinate reference system: the first text in quotes of its WKT; empty without one.
std::string crs_name(const std::string& wkt);

}  // namespace bole::report
