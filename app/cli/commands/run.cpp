#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "cloud/known_facts.h"
#include "commands.h"
#include "console.h"
#include "pipeline/document.h"
#include "vtkbridge/executor.h"

namespace bole::cli {
namespace {

struct Arguments {
  std::string pipeline, out, cache;
  std::vector<std::string> sets;
  bool no_cache = false;
};

// The report's numbers in the order a person looks for them: message, then warnings.
void print_stage(const vtkbridge::StageOutcome& outcome) {
  const auto& record = outcome.record;
  const auto& report = record.report;
  switch (outcome.state) {
    case vtkbridge::StageState::done:
    case vtkbridge::StageState::from_cache:
      fmt::print("{:<16} {:>8.1f} s {:>6.0f} MiB{}  {}\n", record.id, report.seconds, report.peak_mib,
                 record.from_cache ? " (cached)" : "", report.message);
      break;
    default:
      fmt::print("{:<16} {}{}{}\n", record.id, vtkbridge::stage_state_name(outcome.state),
                 outcome.error.empty() ? "" : ": ", outcome.error);
  }
  for (const auto& w : report.warnings) fmt::print("{:<16}   note: {}\n", "", w);
}

// One measure of an evaluation, or nothing where it was not taken.
std::string measure(const Report& report, const char* label, std::initializer_list<const char*> names, int decimals,
                    const char* unit) {
  std::string values;
  for (const char* name : names) {
    const auto it = report.metrics.find(name);
    if (it == report.metrics.end() || !std::isfinite(it->second.value)) return {};
    values += fmt::format("{}{:.{}f}", values.empty() ? "" : ", ", it->second.value, decimals);
  }
  return fmt::format("  {:<28} {} {}\n", label, values, unit);
}

// What a person wants to know first when a reference was connected.
void print_evaluation(const vtkbridge::StageOutcome& outcome) {
  const auto& report = outcome.record.report;
  // Errors of a trajectory that was read from a file say nothing about SLAM.
  const bool poses_given = pose_origin(Facts(report.facts.begin(), report.facts.end())) == PoseOrigin::given;
  const auto count = [&](const char* name) {
    const auto it = report.counts.find(name);
    return it == report.counts.end() ? std::int64_t{0} : it->second;
  };
  std::string lines;
  if (report.counts.contains("matched"))
    lines += fmt::format("  {:<28} {} / {} / {}\n", "stems found/missed/false", count("matched"), count("missed"),
                         count("false"));
  lines += measure(report, "DBH bias, RMSE", {"dbh_bias", "dbh_rmse"}, 2, "cm");
  lines += measure(report, "position RMSE x, y", {"position_rmse_x", "position_rmse_y"}, 3, "m");
  lines += measure(report, "trajectory RMSE (ATE)", {"ate_rmse"}, 3, poses_given ? "m (given poses)" : "m");
  if (!lines.empty()) fmt::print("\nAgainst the reference ({}):\n{}", outcome.record.id, lines);
}

void run_document(Program& program, const Arguments& args) {
  auto document = pipeline::PipelineDocument::load(args.pipeline, pipeline::StageRegistry::global());
  pipeline::apply_sets(document, args.sets);
  Interrupts interrupts(Interrupts::First::finishes);
  ProgressLine line;
  vtkbridge::RunSettings settings;
  settings.output_dir = args.out;
  if (!args.cache.empty()) settings.cache_dir = args.cache;
  settings.use_cache = !args.no_cache;
  settings.finish = interrupts.finish();
  settings.cancel = interrupts.cancel();
  settings.progress = [&line](const std::string& stage, double fraction, std::string_view what) {
    line.update(stage, fraction, what);
  };
  const auto outcome = vtkbridge::run_pipeline(document, settings);
  line.clear();
  for (const auto& stage : outcome.stages) print_stage(stage);
  for (const auto& stage : outcome.stages)
    if (stage.record.type.starts_with("evaluation.")) print_evaluation(stage);
  if (!outcome.error.empty()) fmt::print(stderr, "bole: {}\n", outcome.error);
  if (!args.out.empty()) fmt::print("\nResults are in {}\n", args.out);
  program.exit_code = outcome.exit_code;
}

}  // namespace

void add_run(Program& program) {
  auto args = std::make_shared<Arguments>();
  auto* command = program.app.add_subcommand("run", "Run a pipeline document");
  command->add_option("pipeline", args->pipeline, "Pipeline document (JSON)")->required();
  command->add_option("--set", args->sets, "Set an option: STAGE.OPTION=VALUE (bole stages TYPE lists them)")
      ->type_name("ASSIGNMENT");
  command->add_option("--out", args->out, "Folder for results")->type_name("DIR")->required();
  command->add_option("--cache", args->cache, "Folder of stored stage results (default: cache in the results' folder)")
      ->type_name("DIR");
  command->add_flag("--no-cache", args->no_cache, "Run every stage, store nothing");
  command->callback([args, &program] { run_document(program, *args); });
}

}  // namespace bole::cli
