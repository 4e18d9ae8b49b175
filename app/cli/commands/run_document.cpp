#include "run_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "base/user_path.h"
#include "base/verdict.h"
#include "cloud/known_facts.h"
#include "console.h"
#include "vtkbridge/executor.h"

namespace bole::cli {
namespace {

// Those of a sterner kind are listed once, below the verdict.
bool is_listed_below(const Report& report, const std::string& warning) {
  return std::ranges::any_of(report.findings,
                             [&](const Finding& f) { return f.text == warning && f.severity != Severity::note; });
}

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
  for (const auto& w : report.warnings)
    if (!is_listed_below(report, w)) fmt::print("{:<16}   note: {}\n", "", w);
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

std::string count_of(std::int64_t n, const char* one, const char* several) {
  return n == 0 ? std::string() : fmt::format(", {} {}", n, n == 1 ? one : several);
}

// "Verdict: look - Look before you sign, 3 findings, see report.html" in the words of that page, then the findings that
// decide it. A run without a page (a film) has nothing that a person could sign: it says something only where something
// was found.
void print_verdict(const vtkbridge::RunOutcome& outcome) {
  const auto judgement = vtkbridge::judgement_of(outcome);
  const auto is_sterner = [](const StageFinding& f) { return f.finding.severity != Severity::note; };
  const auto count = std::ranges::count_if(judgement.findings, is_sterner);
  const bool has_page = std::ranges::any_of(outcome.stages, [](const vtkbridge::StageOutcome& stage) {
    return std::ranges::any_of(stage.files, [](const std::string& file) { return file.ends_with("report.html"); });
  });
  if (!has_page && judgement.verdict == Verdict::sign) return;
  std::int64_t trees = 0;
  for (const auto& stage : outcome.stages)
    if (const auto it = stage.record.report.counts.find(trees_to_look_at_count); it != stage.record.report.counts.end())
      trees += it->second;
  // Those of the verdict "sign" are in the headline.
  const auto more = judgement.verdict == Verdict::sign ? 0 : trees;
  fmt::print("\nVerdict: {} - {}{}{}{}\n", verdict_name(judgement.verdict),
             verdict_headline(judgement.verdict, static_cast<std::size_t>(trees)),
             count_of(count, "finding", "findings"), count_of(more, "tree to look at", "trees to look at"),
             has_page && !outcome.results.empty() ? ", see report.html" : "");
  for (const auto& f : judgement.findings)
    if (is_sterner(f))
      fmt::print("  {:<8} {}{}{}\n", severity_name(f.finding.severity), f.stage, f.stage.empty() ? "" : ": ",
                 f.finding.text);
}

// Where to look, in words that fit what became of the run.
void print_place(const vtkbridge::RunOutcome& outcome, const std::string& out) {
  if (outcome.exit_code == 0) {
    fmt::print("{}Results are in {}\n",
               outcome.finished_early() ? "Finished early: the results are not complete. " : "", out);
    return;
  }
  if (outcome.exit_code == 3) {
    fmt::print(stderr, "bole: the run was cancelled. {}\n",
               outcome.kept_before ? "The survey before is still in " + out + ", unchanged" : "There are no results");
    return;
  }
  if (outcome.kept_before)
    fmt::print(stderr, "bole: the run failed. The survey before is still in {}, {}; {}\n", out,
               outcome.not_marked.empty() ? std::string("marked as old")
                                          : "but could not be marked as old (" + outcome.not_marked + ")",
               outcome.results.empty() ? std::string("what this run wrote was removed to make room")
                                       : "what this run wrote is in " + outcome.results.string());
  else if (!outcome.results.empty())
    fmt::print(stderr, "bole: the run failed. What it wrote, not complete, is in {}\n", outcome.results.string());
  else
    fmt::print(stderr, "bole: the run failed. Nothing was written into {}\n", out);
}

}  // namespace

void add_run_flags(CLI::App& command, RunArguments& args) {
  command
      .add_option("--out", args.out, "Folder for results. They take the place of the survey before when the run ends")
      ->type_name("DIR")
      ->required();
  command.add_option("--set", args.sets, "Set an option: STAGE.OPTION=VALUE (bole stages TYPE lists them)")
      ->type_name("ASSIGNMENT");
  command.add_flag("--force", args.force, "Write over files in DIR that have names of results and are not Bole's");
  command.add_flag("--accept-partial", args.accept_partial,
                   "Go on with an input of which a part cannot be read (it is a finding then)");
  command.add_option("--cache", args.cache, "Folder of stored stage results (default: cache in the results' folder)")
      ->type_name("DIR");
  command.add_flag("--no-cache", args.no_cache, "Run every stage, store nothing");
  command.add_option("--threads", args.threads, "Threads that work at the same time. Default: one per processor")
      ->type_name("N")
      ->check(CLI::Range(1, 4096).description(""));
  command
      .add_option("--end-with", args.end_with,
                  "Process that started this one: the run is killed when that ends in any way (campaigns use it)")
      ->type_name("PID");
}

void run_document(Program& program, pipeline::PipelineDocument document, const RunArguments& args) {
  if (args.end_with > 0) end_with_parent(args.end_with);
  pipeline::apply_sets(document, args.sets);
  Interrupts interrupts(Interrupts::First::finishes);
  ProgressLine line;
  vtkbridge::RunSettings settings;
  settings.output_dir = expand_home(args.out);
  settings.replace_foreign = args.force;
  settings.accept_partial = args.accept_partial;
  if (!args.cache.empty()) settings.cache_dir = expand_home(args.cache);
  settings.use_cache = !args.no_cache;
  settings.threads = args.threads;
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
  if (!outcome.stages.empty() && outcome.exit_code != 3) print_verdict(outcome);
  if (!outcome.error.empty() && outcome.exit_code != 3) fmt::print(stderr, "bole: {}\n", outcome.error);
  for (const auto& text : outcome.kept_changed) fmt::print(stderr, "bole: warning: {}\n", text);
  print_place(outcome, args.out);
  program.exit_code = vtkbridge::program_exit_code(outcome);
}

}  // namespace bole::cli
