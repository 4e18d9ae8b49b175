// Runs pipeline documents: a document becomes a graph of vtkBoleStage objects joined by SetInputConnection, and VTK's
// Update() runs it. Stages run in topological order; one that fails takes those that need its outputs with it, and no
// others.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/verdict.h"
#include "pipeline/document.h"
#include "vtkBoleBridgeModule.h"

class vtkBoleStage;
class vtkDataObject;

namespace bole::pipeline {
class ResultFolder;
}

namespace bole::vtkbridge {

struct StageControl;

struct RunSettings {
  // Where sinks and summary.json go, see pipeline/result_folder.h; empty: nothing is written.
  std::filesystem::path output_dir;
  bool replace_foreign = false;  // write over files in output_dir that no run of Bole wrote
  bool accept_partial = true;    // go on with an input that could be read in part only; a finding says so
  std::optional<std::filesystem::path> cache_dir;  // default: output_dir/cache
  bool use_cache = true;
  bool sinks = true;  // false: stages that write files (report) are left out, for a quick look after an edit
  std::uintmax_t cache_bytes = std::uintmax_t{20} << 30;  // results not used for longest go when the cache is larger
  std::filesystem::path scratch_dir;
  int threads = 0;  // that work at the same time; 0: one per processor
  std::function<void(const std::string& stage, double fraction, std::string_view what)> progress;
  // Who watches a stage at work; may give null. Called as each stage begins.
  std::function<std::shared_ptr<Preview>(const pipeline::StageNode&)> preview;
  std::stop_token cancel;
  std::stop_token finish;  // of the stage that runs when it is asked for; those after it run in full on its result
};

enum class StageState { done, from_cache, failed, skipped, cancelled };
std::string_view stage_state_name(StageState state);

struct StageOutcome {
  StageRecord record;
  StageState state = StageState::skipped;
  std::string error;
  std::vector<std::string> files;  // that it wrote
  // Its outputs that summary.json shows (Port::in_summary), by port.
  std::map<std::string, std::shared_ptr<const Table>> tables = {};
};

struct RunOutcome {
  int exit_code = 0;  // base/exit_codes.h; 0 also when a stage ended early; of the first stage that went wrong
  std::string error;  // empty when all went well
  std::vector<StageOutcome> stages;
  std::string summary_json;
  std::filesystem::path results;  // the folder with what this run wrote; empty: nothing was kept
  bool kept_before = false;       // the run failed, and the survey before is still in the output folder
  std::string not_marked;         // of that survey: what could not be marked as old, and why
  // A sentence on each result that a person had changed and that is kept under another name.
  std::vector<std::string> kept_changed;

  VTKBOLEBRIDGE_EXPORT bool finished_early() const;  // a stage ended early on request
};

// What the run means for a person who signs. One that failed is refused, whatever its stages found.
VTKBOLEBRIDGE_EXPORT Judgement judgement_of(const RunOutcome& outcome);
// The exit code of a program that runs this (base/exit_codes.h): an early end has one of its own.
VTKBOLEBRIDGE_EXPORT int program_exit_code(const RunOutcome& outcome);

class VTKBOLEBRIDGE_EXPORT PipelineExecutor {
 public:
  explicit PipelineExecutor(pipeline::PipelineDocument document);
  ~PipelineExecutor();
  PipelineExecutor(const PipelineExecutor&) = delete;
  PipelineExecutor& operator=(const PipelineExecutor&) = delete;

  const pipeline::PipelineDocument& document() const { return document_; }
  // "stage.option" = text, in the document and in the stage object. Throws Error{bad_input}.
  void set(std::string_view stage_and_option, std::string_view text);
  // A reader takes this data in place of its file. Throws Error{bad_input}.
  void take_data(std::string_view id, vtkDataObject* data);
  vtkBoleStage* stage(std::string_view id) const;  // nullptr when there is none

  // Runs what is not up to date, checks the document first. Errors are in the outcome, none are thrown. Results and
  // summary.json take the place of the survey before at the end; of a run that failed they lie beside it. Without sinks
  // the output folder is left as it is, but for the cache.
  RunOutcome run(const RunSettings& settings);

  // Asks the stage that runs now for its best result so far; from any thread.
  void finish_running_stage();

 private:
  struct Graph;
  StageControl control_for(const pipeline::StageNode& node, const RunSettings& settings,
                           const RunOutcome& so_far) const;
  void set_running(vtkBoleStage* running);
  StageOutcome run_stage_of(const pipeline::StageNode& node, const RunSettings& settings, RunOutcome& so_far);
  std::unique_ptr<pipeline::ResultFolder> open_results(const RunSettings& settings) const;
  void run_stages(const RunSettings& settings, RunOutcome& outcome);
  pipeline::PipelineDocument document_;
  std::unique_ptr<Graph> graph_;
};

VTKBOLEBRIDGE_EXPORT RunOutcome run_pipeline(const pipeline::PipelineDocument& document, const RunSettings& settings);

}  // namespace bole::vtkbridge
