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

#include "pipeline/document.h"
#include "vtkBoleBridgeModule.h"

class vtkBoleStage;

namespace bole::vtkbridge {

struct StageControl;

struct RunSettings {
  std::filesystem::path output_dir;                // where sinks and summary.json go; empty: nothing is written
  std::optional<std::filesystem::path> cache_dir;  // default: output_dir/cache
  bool use_cache = true;
  bool sinks = true;  // false: stages that write files (report) are left out, for a quick look after an edit
  std::uintmax_t cache_bytes = std::uintmax_t{20} << 30;  // results not used for longest go when the cache is larger
  std::filesystem::path scratch_dir;
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
  int exit_code = 0;  // 0 ok, 1 failed, 2 bad input, 3 cancelled; of the first stage that went wrong
  std::string error;  // empty when all went well
  std::vector<StageOutcome> stages;
  std::string summary_json;
};

class VTKBOLEBRIDGE_EXPORT PipelineExecutor {
 public:
  explicit PipelineExecutor(pipeline::PipelineDocument document);
  ~PipelineExecutor();
  PipelineExecutor(const PipelineExecutor&) = delete;
  PipelineExecutor& operator=(const PipelineExecutor&) = delete;

  const pipeline::PipelineDocument& document() const { return document_; }
  // "stage.option" = text, in the document and in the stage object. Throws Error{bad_input}.
  void set(std::string_view stage_and_option, std::string_view text);
  vtkBoleStage* stage(std::string_view id) const;  // nullptr when there is none

  // Runs what is not up to date, checks the document first. Errors are in the outcome, none are thrown. Writes
  // summary.json.
  RunOutcome run(const RunSettings& settings);

  // Asks the stage that runs now for its best result so far; from any thread.
  void finish_running_stage();

 private:
  struct Graph;
  StageControl control_for(const pipeline::StageNode& node, const RunSettings& settings,
                           const RunOutcome& so_far) const;
  void set_running(vtkBoleStage* running);
  StageOutcome run_stage_of(const pipeline::StageNode& node, const RunSettings& settings, RunOutcome& so_far);
  pipeline::PipelineDocument document_;
  std::unique_ptr<Graph> graph_;
};

VTKBOLEBRIDGE_EXPORT RunOutcome run_pipeline(const pipeline::PipelineDocument& document, const RunSettings& settings);

}  // namespace bole::vtkbridge
