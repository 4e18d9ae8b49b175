// Reports as JSON: in the summary of a run, in the result cache, in the answers of VTK objects.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/report.h"
#include "base/run.h"

namespace bole::pipeline {

std::string_view status_name(Status status);  // "ok", "finished_early", "warning"

nlohmann::ordered_json finding_to_json(const Finding& finding);
nlohmann::ordered_json report_to_json(const Report& report);
// Throws nlohmann::json::exception or Error when the text is not one that report_to_json() made.
Report report_from_json(const nlohmann::ordered_json& json);

}  // namespace bole::pipeline
