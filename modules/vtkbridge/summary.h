// summary.json: what ran, with which options, how it went, and every number of the report.
//
// At the top stand the "verdict" (sign, look, refused) and the "findings" of all stages (code, severity, text, stage),
// the most severe first. Each stage has its changed "options" and the "defaults" that it took for the others, its
// counts, metrics, facts and warnings, and under "tables" its tables of results (Port::in_summary) as lists of rows.
// Tables with a row per stem, section, candidate, edit, loop or frame lie beside it as CSV.
#pragma once

#include <filesystem>
#include <string>

#include "vtkbridge/executor.h"

namespace bole::vtkbridge {

// `axes` at the top is the last that a stage told of. File names are relative to `output_dir`.
std::string summary_json(const pipeline::PipelineDocument& document, const RunOutcome& outcome, double seconds,
                         const std::filesystem::path& output_dir);

}  // namespace bole::vtkbridge
