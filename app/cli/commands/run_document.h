// Runs a pipeline document and tells about it: what `bole run` and `bole survey` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "commands.h"
#include "pipeline/document.h"

namespace bole::cli {

struct RunArguments {
  std::string out, cache;
  std::vector<std::string> sets;
  int threads = 0;    // 0: as many as there are processors
  long end_with = 0;  // the process that started this one; 0: any
  bool no_cache = false, force = false, accept_partial = false;
};

// --out, --set and the others.
void add_run_flags(CLI::App& command, RunArguments& args);

// Sets program.exit_code. Throws Error{bad_input} for options that the pipeline does not have.
void run_document(Program& program, pipeline::PipelineDocument document, const RunArguments& args);

}  // namespace bole::cli
