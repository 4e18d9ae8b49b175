// summary.json: what ran, with which options, how it went, and every number of the reports.
#pragma once

#include <filesystem>
#include <string>

#include "vtkbridge/executor.h"

namespace bole::vtkbridge {

// `axes` at the top is the last that a stage told of. File names are relative to `output_dir`.
std::string summary_json(const pipeline::PipelineDocument& document, const RunOutcome& outcome, double seconds,
                         const std::filesystem::path& output_dir);

}  // namespace bole::vtkbridge
