#include "vtkbridge/executor.h"

#include <tbb/global_control.h>
#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <mutex>
#include <set>

#include "base/atomic_file.h"
#include "base/core/path_list.h"
#include "base/exit_codes.h"
#include "base/option_text.h"
#include "pipeline/result_folder.h"
#include "pipeline/skipped_stages.h"
#include "vtkBoleStage.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/file_keys.h"
#include "vtkbridge/lazy_data.h"
#include "vtkbridge/stage_control.h"
#include "vtkbridge/stage_execution.h"
#include "vtkbridge/summary.h"

namespace bole::vtkbridge {
namespace fs = std::filesystem;

std::string_view stage_state_name(StageState state) {
  constexpr std::array<std::string_view, 5> names{"done", "from_cache", "failed", "skipped", "cancelled"};
  return names[static_cast<std::size_t>(state)];
}

struct PipelineExecutor::Graph {
  std::map<std::string, vtkSmartPointer<vtkBoleStage>, std::less<>> stages;
  std::map<std::string, int> executions;               // as counted when the last run ended
  std::map<std::string, std::string> stamps_of_input;  // of the files that a stage read then
  std::shared_ptr<ResultCache> cache;
  fs::path draft_dir;                  // of the results, while a run goes on
  vtkNew<vtkCallbackCommand> silence;  // an observer that does nothing
  std::mutex mutex;
  vtkBoleStage* running = nullptr;
};

namespace {

bool is_done(const StageOutcome& outcome) {
  return outcome.state == StageState::done || outcome.state == StageState::from_cache;
}

const StageOutcome* find_outcome(const RunOutcome& outcome, const std::string& id) {
  const auto it = std::ranges::find_if(outcome.stages, [&](const StageOutcome& s) { return s.record.id == id; });
  return it == outcome.stages.end() ? nullptr : &*it;
}

std::vector<OptionRecord> option_records(const OptionSet& options) {
  std::vector<OptionRecord> records;
  for (const auto& spec : options.table().specs)
    records.push_back({spec.name, option_text(options.get(spec.name)), std::string(unit_symbol(spec.unit)),
                       options.is_default(spec.name)});
  return records;
}

void check(const pipeline::PipelineDocument& document) {
  const auto problems = pipeline::validate(document);
  if (problems.empty()) return;
  std::string text;
  for (const auto& p : problems)
    text += (text.empty() ? "" : "\n") + (p.stage.empty() ? p.message : "stage '" + p.stage + "': " + p.message);
  throw bad_input(text);
}

void note_first_error(RunOutcome& outcome, int exit_code, const std::string& error) {
  if (outcome.exit_code != 0) return;
  outcome.exit_code = exit_code;
  outcome.error = error;
}

std::map<std::string, std::shared_ptr<const Table>> summary_tables(const pipeline::StageType& type,
                                                                   vtkBoleStage& stage) {
  std::map<std::string, std::shared_ptr<const Table>> tables;
  for (int i = 0; i < static_cast<int>(type.outputs.size()); ++i) {
    const auto& port = type.outputs[static_cast<std::size_t>(i)];
    if (!port.in_summary) continue;
    if (const auto data = attached(stage.GetOutputDataObject(i)))
      if (const auto held = data->get(); data_kind(held) == DataKind::table)
        tables[port.name] = std::get<std::shared_ptr<const Table>>(held);
  }
  return tables;
}

std::string stamps_of_input(const OptionSet& options) {
  std::string stamps;
  for (const auto& spec : options.table().specs)
    if (const auto value = options.get(spec.name); is_input_path(spec, value))
      for (const auto& path : input_paths(spec, option_text(value))) stamps += change_stamp(path);
  return stamps;
}

// A result that is not there must not look like a success, whatever the stage made of it.
void note_unwritten_outputs(RunOutcome& outcome) {
  for (const auto& stage : outcome.stages)
    for (const auto& finding : stage.record.report.findings)
      if (finding.code == finding_code::output_not_written)
        note_first_error(outcome, static_cast<int>(ExitCode::failed), finding.text);
      else if (finding.code == finding_code::input_not_usable)
        note_first_error(outcome, static_cast<int>(ExitCode::bad_input), finding.text);
}

// An input of which a part is missing ends the run, unless that was accepted.
void refuse_partial_input(StageOutcome& outcome) {
  for (const auto& finding : outcome.record.report.findings)
    if (finding.code == finding_code::input_incomplete) {
      outcome.state = StageState::failed;
      outcome.error = finding.text + ". Get a whole file, or go on with what there is (--accept-partial)";
      return;
    }
}

std::string finished_early_text(const RunOutcome& outcome) {
  std::string stages;
  for (const auto& stage : outcome.stages)
    if (stage.record.report.status == Status::finished_early) stages += (stages.empty() ? "" : ", ") + stage.record.id;
  return "This survey is not complete: the run was asked to finish early (" + stages +
         ").\nRun the same pipeline again to have it whole.\n";
}

// Of a run that failed, where there is a survey before it.
void keep_beside(pipeline::ResultFolder& folder, const fs::path& output_dir, RunOutcome& outcome) {
  outcome.kept_before = true;
  try {
    write_text_file(folder.draft() / "summary.json", outcome.summary_json);
  } catch (const Error&) {  // a full disk; the marks below matter more
  }
  const auto old = folder.keep_survey_before(outcome.error);
  outcome.not_marked = old.not_marked;
  outcome.results = old.results_kept ? output_dir / pipeline::failed_run_folder : fs::path();
}

// Puts what a run wrote where it belongs: in place of the survey before, beside it when the run failed, nowhere when it
// was cancelled.
void keep_results(pipeline::ResultFolder& folder, const fs::path& output_dir, RunOutcome& outcome) {
  const bool failed = outcome.exit_code != 0;
  const bool had_survey = folder.has_survey();
  if (failed && had_survey && outcome.exit_code == static_cast<int>(ExitCode::cancelled)) {
    outcome.kept_before = true;
    return;
  }
  if (failed && had_survey) return keep_beside(folder, output_dir, outcome);
  write_text_file(folder.draft() / "summary.json", outcome.summary_json);
  if (failed)
    write_text_file(folder.draft() / pipeline::failed_run_note,
                    "This run failed. What lies here is not complete:\n\n  " + outcome.error + "\n");
  if (!failed && outcome.finished_early())
    write_text_file(folder.draft() / pipeline::finished_early_note, finished_early_text(outcome));
  std::set<std::string> files;
  for (const auto& stage : outcome.stages)
    for (const auto& file : stage.files) files.insert(whole_path(file).lexically_relative(output_dir).generic_string());
  outcome.kept_changed = folder.publish(files);
  outcome.results = output_dir;
}

fs::path cache_folder(const RunSettings& settings) {
  if (!settings.use_cache) return {};
  if (settings.cache_dir) return *settings.cache_dir;
  return settings.output_dir.empty() ? fs::path() : settings.output_dir / "cache";
}

}  // namespace

PipelineExecutor::PipelineExecutor(pipeline::PipelineDocument document)
    : document_(std::move(document)), graph_(std::make_unique<Graph>()) {
  for (const auto& node : document_.stages()) {
    vtkNew<vtkBoleStage> stage;
    stage->SetStageType(node.type->name.c_str());
    stage->SetOptions(node.options);
    stage->SetGenerateVertices(false);
    // Errors are read from the stage; VTK shall not print them as well.
    stage->AddObserver(vtkCommand::ErrorEvent, graph_->silence);
    stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, graph_->silence);
    graph_->stages[node.id] = stage;
  }
}

PipelineExecutor::~PipelineExecutor() = default;

vtkBoleStage* PipelineExecutor::stage(std::string_view id) const {
  const auto it = graph_->stages.find(id);
  return it == graph_->stages.end() ? nullptr : it->second.Get();
}

void PipelineExecutor::set(std::string_view stage_and_option, std::string_view text) {
  document_.set(stage_and_option, text);
  const auto id = pipeline::parse_source(stage_and_option).id;
  stage(id)->SetOptions(document_.at(id).options);
}

void PipelineExecutor::take_data(std::string_view id, vtkDataObject* data) {
  document_.at(id);  // throws where there is none
  auto* const taker = stage(id);
  if (!taker->TakeData(data)) throw bad_input("stage '" + std::string(id) + "': " + taker->GetErrorText());
  const auto node = std::ranges::find(document_.stages(), id, &pipeline::StageNode::id);
  node->from_memory = data != nullptr;
}

void PipelineExecutor::finish_running_stage() {
  const std::lock_guard lock(graph_->mutex);
  if (graph_->running) graph_->running->Finish();
}

StageControl PipelineExecutor::control_for(const pipeline::StageNode& node, const RunSettings& settings,
                                           const RunOutcome& so_far) const {
  StageControl control;
  control.cancel = settings.cancel;
  if (!settings.finish.stop_requested()) control.finish = settings.finish;
  if (settings.progress)
    control.progress = [&settings, id = node.id](double fraction, std::string_view what) {
      settings.progress(id, fraction, what);
    };
  if (settings.preview) control.preview = settings.preview(node);
  control.record = [this, &so_far] {
    auto record = std::make_shared<RunRecord>();
    record->document = document_.source().empty() ? document_.title() : document_.source();
    for (const auto& s : so_far.stages)
      if (is_done(s)) record->stages.push_back(s.record);
    return record;
  };
  control.cache = graph_->cache;
  control.output_dir = settings.output_dir, control.scratch_dir = settings.scratch_dir;
  control.draft_dir = graph_->draft_dir;
  control.core_only = true;
  return control;
}

void PipelineExecutor::set_running(vtkBoleStage* running) {
  const std::lock_guard lock(graph_->mutex);
  graph_->running = running;
}

// Runs one stage whose producers have run. Required inputs from a stage that failed: skipped; optional ones: left out.
StageOutcome PipelineExecutor::run_stage_of(const pipeline::StageNode& node, const RunSettings& settings,
                                            RunOutcome& so_far) {
  auto* const vtk_stage = stage(node.id);
  StageOutcome outcome;
  outcome.record = {node.id, node.type->name, option_records(*vtk_stage->GetOptions()), {}, false};
  if (pipeline::is_skipped(document_, node)) {
    outcome.record.report.message = "Skipped: no file is given.";
    return outcome;
  }
  if (!settings.sinks && node.type->writes_files) {
    outcome.record.report.message = "Left out: nothing is written.";
    return outcome;
  }
  std::vector<std::string> left_out;
  bool any_usable = false;
  for (const auto& port : node.type->inputs) {
    const auto joint = node.inputs.find(port.name);
    const pipeline::SourcePort source =
        joint == node.inputs.end() ? pipeline::SourcePort{} : pipeline::parse_source(joint->second);
    const auto* producer = find_outcome(so_far, source.id);
    const bool usable = producer && is_done(*producer);
    any_usable = any_usable || usable;
    if (producer && !usable && !port.optional) {
      outcome.error = "stage '" + source.id + "' gave no " + source.port;
      return outcome;
    }
    if (producer && !usable && !producer->error.empty())
      left_out.push_back("input '" + port.name + "' is left out: stage '" + source.id + "' failed");
    vtk_stage->ConnectInput(port.name.c_str(), usable ? stage(source.id) : nullptr, source.port.c_str());
  }
  if (!any_usable && !left_out.empty()) {
    outcome.error = "all of its inputs failed";
    return outcome;
  }
  vtk_stage->SetControl(control_for(node, settings, so_far));
  auto& stamps = graph_->stamps_of_input[node.id];
  const auto stamps_now = stamps_of_input(*vtk_stage->GetOptions());
  if (!vtk_stage->OutputFilesPresent() || stamps != stamps_now) vtk_stage->Modified();
  stamps = stamps_now;
  set_running(vtk_stage);
  vtk_stage->Update();
  set_running(nullptr);
  vtk_stage->DetachControl();
  if (vtk_stage->GetExitCode() != 0) {
    outcome.state = vtk_stage->GetExitCode() == 3 ? StageState::cancelled : StageState::failed;
    outcome.error = vtk_stage->GetErrorText();
    note_first_error(so_far, vtk_stage->GetExitCode(), "stage '" + node.id + "': " + outcome.error);
    return outcome;
  }
  auto& counted = graph_->executions[node.id];
  outcome.record.from_cache = vtk_stage->GetExecutionCount() == counted;
  counted = vtk_stage->GetExecutionCount();
  outcome.state = outcome.record.from_cache ? StageState::from_cache : StageState::done;
  outcome.record.report = vtk_stage->GetReport();
  if (!settings.accept_partial) refuse_partial_input(outcome);
  if (outcome.state == StageState::failed) {
    note_first_error(so_far, 1, "stage '" + node.id + "': " + outcome.error);
    return outcome;
  }
  for (auto& text : left_out) outcome.record.report.warn(std::move(text));
  outcome.files = vtk_stage->GetOutputFiles();
  outcome.tables = summary_tables(*node.type, *vtk_stage);
  return outcome;
}

// Null where nothing is to be written.
std::unique_ptr<pipeline::ResultFolder> PipelineExecutor::open_results(const RunSettings& settings) const {
  if (settings.output_dir.empty() || !settings.sinks) return nullptr;
  auto results = std::make_unique<pipeline::ResultFolder>(settings.output_dir, settings.replace_foreign);
  results->refuse_foreign_files(
      std::ranges::any_of(document_.stages(), [](const pipeline::StageNode& node) { return node.type->writes_files; }));
  return results;
}

void PipelineExecutor::run_stages(const RunSettings& settings, RunOutcome& outcome) {
  check(document_);
  const fs::path folder = cache_folder(settings);
  graph_->cache = folder.empty() ? nullptr : std::make_shared<ResultCache>(folder);
  std::map<std::string, int> waiting;  // consumers that have not run
  for (const auto& node : document_.stages())
    for (const auto& [port, source] : node.inputs) ++waiting[pipeline::parse_source(source).id];
  for (const auto* node : document_.in_order()) {
    if (settings.cancel.stop_requested()) {
      note_first_error(outcome, static_cast<int>(ExitCode::cancelled), "cancelled on request");
      outcome.stages.push_back({{node->id, node->type->name, option_records(node->options), {}, false},
                                StageState::cancelled,
                                "cancelled on request",
                                {}});
      continue;
    }
    outcome.stages.push_back(run_stage_of(*node, settings, outcome));
    // Results that no stage needs any more leave the memory; the cache has them.
    for (const auto& [port, source] : node->inputs)
      if (const auto id = pipeline::parse_source(source).id; --waiting[id] == 0) stage(id)->ReleaseResults();
    if (waiting[node->id] == 0) stage(node->id)->ReleaseResults();
  }
  if (graph_->cache) graph_->cache->prune(settings.cache_bytes);
}

RunOutcome PipelineExecutor::run(const RunSettings& asked) {
  RunSettings settings = asked;
  settings.output_dir = whole_path(asked.output_dir);
  std::optional<tbb::global_control> threads;
  if (asked.threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(asked.threads));
  const auto start = std::chrono::steady_clock::now();
  RunOutcome outcome;
  std::unique_ptr<pipeline::ResultFolder> results;
  try {
    results = open_results(settings);
    graph_->draft_dir = results ? results->draft() : fs::path();
    run_stages(settings, outcome);
  } catch (const Error& e) {
    note_first_error(outcome, e.exit_code(), e.what());
  } catch (const std::exception& e) {
    note_first_error(outcome, 1, e.what());
  }
  graph_->draft_dir.clear();
  note_unwritten_outputs(outcome);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  try {
    outcome.summary_json = summary_json(document_, outcome, seconds, settings.output_dir);
    if (results) keep_results(*results, settings.output_dir, outcome);
    return outcome;
  } catch (const Error& e) {
    note_first_error(outcome, e.exit_code(), e.what());
  } catch (const std::exception& e) {
    note_first_error(outcome, 1, e.what());
  }
  // The results could not be put in place.
  outcome.results.clear();
  try {
    outcome.summary_json = summary_json(document_, outcome, seconds, settings.output_dir);
    if (results && results->has_survey()) keep_beside(*results, settings.output_dir, outcome);
  } catch (const std::exception&) {  // nothing more can be written; the error above says why
    outcome.results.clear();
  }
  return outcome;
}

bool RunOutcome::finished_early() const {
  return std::ranges::any_of(
      stages, [](const StageOutcome& stage) { return stage.record.report.status == Status::finished_early; });
}

int program_exit_code(const RunOutcome& outcome) {
  if (outcome.exit_code == 0 && outcome.finished_early()) return static_cast<int>(ExitCode::finished_early);
  return outcome.exit_code;
}

RunOutcome run_pipeline(const pipeline::PipelineDocument& document, const RunSettings& settings) {
  return PipelineExecutor(document).run(settings);
}

}  // namespace bole::vtkbridge
