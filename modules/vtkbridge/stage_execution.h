// One execution of a stage: from the cache when its key is known, by running it otherwise.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "pipeline/stage.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/result_cache.h"

namespace bole::vtkbridge {

using PortData = std::map<std::string, std::shared_ptr<LazyData>>;

// Where the data that a reader takes in place of its file stand among its inputs.
inline constexpr const char* given_port = "(given)";

struct StageExecution {
  PortData outputs;
  Report report;
  bool from_cache = false;
  std::vector<WrittenFile> files;  // that a sink wrote, where they lie at the end of the run
};

// Runs a stage or takes its result from `cache` (may be null). Outputs of a stored result are loaded when asked for;
// should an array prove damaged then, the stage is run after all. Results of a run that was asked to finish early are
// not stored, nor are those of a sink that could not write everything. A sink writes into Run::output_dir; `final_dir`
// is where its files lie at the end of the run (empty: there). Throws what run_stage() throws.
StageExecution execute_stage(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs,
                             const Run& run, const std::shared_ptr<ResultCache>& cache,
                             const std::filesystem::path& final_dir = {});

// The key of a result: stage type and version, Bole's version, every option, the content of input files, the keys of
// the inputs, and the folder in which the files of a sink lie at the end.
std::string stage_key(const pipeline::StageType& type, const OptionSet& options, const PortData& inputs, const Run& run,
                      ResultCache& cache, const std::filesystem::path& final_dir = {});

// The key of data that no stage made: its content.
std::string content_key(const Data& data);

}  // namespace bole::vtkbridge
