#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cloud/known_facts.h"
#include "evaluation/core/compare_runs.h"
#include "evaluation/core/evaluate_rows.h"
#include "evaluation/core/evaluate_stems.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "evaluation/core/field_table.h"
#include "evaluation/core/published.h"
#include "evaluation/core/same_plot.h"
#include "pipeline/stage.h"

namespace bole::evaluation {
namespace {

// `a` with the rows of `b` below it.
Table stacked(const Table& a, const Table& b) {
  auto measure = a.texts("measure"), unit = a.texts("unit"), published = a.texts("published");
  auto value = a.numbers("value");
  for (std::size_t i = 0; i < b.rows(); ++i) {
    measure.push_back(b.texts("measure")[i]);
    unit.push_back(b.texts("unit")[i]);
    published.push_back(b.texts("published")[i]);
    value.push_back(b.numbers("value")[i]);
  }
  Table t;
  t.set("measure", measure);
  t.set("value", value);
  t.set("unit", unit);
  t.set("published", published);
  return t;
}

Unit unit_named(const std::string& symbol) {
  for (const Unit u : {Unit::metre, Unit::centimetre, Unit::degree, Unit::percent})
    if (symbol == unit_symbol(u)) return u;
  return Unit::none;
}

void copy_metrics(const Table& summary, Report& report) {
  const auto& measure = summary.texts("measure");
  const auto& unit = summary.texts("unit");
  const auto value = summary.numbers("value");
  for (std::size_t i = 0; i < summary.rows(); ++i) report.metrics[measure[i]] = {value[i], unit_named(unit[i])};
}

// A list whose columns nobody named and no heading tells is left out and told: the survey itself is whole without it.
std::optional<StemEvaluation> compare_stems(const Table& stems, const Table& reference,
                                            const EvaluationOptions& options, const CountingRule& rule,
                                            Report& report) {
  if (!options.reference_columns.empty() || reference.has("x_m"))
    return evaluate_stems(stems, reference, options, rule);
  try {
    auto found = evaluate_stems(stems, reference, options, rule);
    if (!found.guessed_columns.empty())
      report.find(Severity::note, "reference_columns_guessed",
                  "the columns of the reference were taken by their headings: " + found.guessed_columns +
                      ". Set evaluate.reference_columns where that is wrong");
    return found;
  } catch (const Error& error) {
    report.find(Severity::look, "reference_not_read",
                std::string("the stems were compared with no reference: ") + error.what());
    return std::nullopt;
  }
}

// With the system of the paper whose figures stand beside the results: that of the preset which was run.
EvaluationOptions with_published_system(EvaluationOptions options, const DataSet& in, Report& report) {
  if (options.published_plot == PublishedPlot::none || options.published_system) return options;
  std::string preset;
  if (in.has("trajectory")) {
    const auto& facts = in.trajectory("trajectory").facts;
    if (const auto it = facts.find("preset"); it != facts.end()) preset = it->second;
  }
  options.published_system = paper_system(preset);
  if (options.published_system) return options;
  options.published_system = PaperSystem::improved_loam;
  report.find(Severity::note, "published_of_another_system",
              (preset.empty() ? std::string("the preset that made the trajectory is not known")
                              : "the paper has no figures of the preset " + preset) +
                  ": those of its improved LOAM are listed. Set evaluate.published_system for others");
  return options;
}

// Pairs that met by chance give figures, too: they mean nothing.
void tell_agreement(const DataSet& in, const StemEvaluation& found, const EvaluationOptions& options,
                    const CountingRule& rule, Report& report) {
  constexpr std::size_t min_trees = 6;  // of the shorter list, to judge by
  const auto agreement = agreement_of(found);
  if (agreement.smaller < min_trees) {
    if (found.matched == 0)
      report.warn(
          "no stem matches a reference tree: are both in the same axes? align_stems and match_distance may help");
    return;
  }
  if (100 * agreement.share() >= usual_agreement_pct) return;
  auto own = options;
  own.columns.clear(), own.rows.clear(), own.reference_columns.clear(), own.reference_rows.clear();
  std::string ignored;
  report.find(
      Severity::look, "reference_disagrees",
      fmt::format("{} of {} trees agree with the reference: its figures mean nothing; {}", agreement.matched,
                  agreement.smaller,
                  why_they_differ(field_table(in.table("stems"), options.columns, options.rows),
                                  reference_in_our_columns(in.table("reference_stems"), options, ignored), own, rule)));
}

pipeline::StageResult evaluate_plot(const DataSet& in, const OptionSet& set, const Run& run) {
  const CountingRule rule = in.has("plot") ? counting_rule(in.table("plot")) : CountingRule{};
  pipeline::StageResult result;
  const auto options = with_published_system(set.as<EvaluationOptions>(), in, result.report);
  // The columns that options name are those of the tables that are connected, not of this empty one.
  const Table none = in.table("stems").subset({});
  Table matches = evaluate_stems(none, none, {}, rule).matches;
  Table summary = SummaryRows(PublishedPlot::none).table();
  std::string message;
  if (in.has("reference_stems")) {
    auto& r = result.report;
    auto compared = compare_stems(in.table("stems"), in.table("reference_stems"), options, rule, r);
    message = "the reference could not be read";
    if (compared) {
      auto& stems = *compared;
      r.counts["matched"] = static_cast<std::int64_t>(stems.matched);
      r.counts["missed"] = static_cast<std::int64_t>(stems.missed);
      r.counts["false"] = static_cast<std::int64_t>(stems.extra);
      message = std::to_string(stems.matched) + " stems matched, " + std::to_string(stems.missed) + " missed, " +
                std::to_string(stems.extra) + " false";
      tell_agreement(in, stems, options, rule, r);
      for (auto& w : stems.warnings) r.warn(std::move(w));
      matches = std::move(stems.matches);
      summary = std::move(stems.summary);
    }
  }
  run.check_cancel();
  if (in.has("reference_trajectory")) {
    if (!in.has("trajectory"))
      throw bad_input("a reference trajectory is connected but no trajectory", "both",
                      "Connect the input 'trajectory'");
    const auto trajectory =
        evaluate_trajectory(in.trajectory("trajectory"), in.trajectory("reference_trajectory"), options);
    message += (message.empty() ? "" : "; ") + std::to_string(trajectory.poses) + " poses compared";
    auto both = stacked(summary, trajectory.summary);
    both.facts = summary.facts;
    summary = std::move(both);
    if (const auto poses = fact_text(in.trajectory("trajectory").facts, facts::poses))
      result.report.facts[std::string(facts::poses.key)] = *poses;
  }
  copy_metrics(summary, result.report);
  if (const auto it = summary.facts.find("published"); it != summary.facts.end())
    result.report.facts["published"] = it->second;
  result.report.message = message.empty() ? "nothing to compare with: no reference is connected" : message;
  result.outputs.set("matches", std::move(matches));
  result.outputs.set("summary", std::move(summary));
  return result;
}

pipeline::StageResult compare(const DataSet& in, const OptionSet& set, const Run& run) {
  const auto table = [&](const char* port) { return in.has(port) ? &in.table(port) : nullptr; };
  auto runs = runs_of({table("runs"), table("stems"), table("poses"), table("boundaries"), table("run_references"),
                       table("run_reference_poses")});
  std::optional<Table> reference;
  if (in.has("reference_stems")) reference = in.table("reference_stems");
  const auto* path = in.has("reference_trajectory") ? &in.trajectory("reference_trajectory") : nullptr;
  auto found = compare_runs(std::move(runs), reference, path, set.as<CompareOptions>(), run);
  pipeline::StageResult result;
  result.report = std::move(found.report);
  result.outputs.set("runs", std::move(found.runs));
  result.outputs.set("groups", std::move(found.groups));
  result.outputs.set("pairs", std::move(found.pairs));
  result.outputs.set("trees", std::move(found.trees));
  return result;
}

pipeline::StageType compare_stage() {
  pipeline::StageType t;
  t.name = "evaluation.compare";
  t.vtk_class = "vtkBoleCompareRuns";
  t.title = "Compare runs";
  t.help =
      "Compares two or more runs with a reference and with each other. Stems are matched as by evaluation.plot. Gives "
      "for each run, and for the runs of one system together, found, missed and extra trees, mean and covariance of "
      "the "
      "position error, RMSE in x and y, BIAS, relBIAS, RMSE and relRMSE of the diameters, and ATE and RPE of the "
      "trajectory; for each two runs of a plot their differences. Runs whose stems agree share a plot. Lists that do "
      "not agree (other axes, other units, another plot) are reported and never pooled. Without a reference the runs "
      "are compared with each other only.";
  t.source = "The paper on forest plots by improved LOAM, equations 25 to 27, tables 2 and 3 (SPEC A11)";
  t.inputs = {
      {"runs", DataKind::table, "A row per run, from io.read_runs.", false, {}},
      {"stems", DataKind::table, "The stems of all runs.", false, {}},
      {"poses", DataKind::table, "The trajectories of all runs.", true, {}},
      {"boundaries", DataKind::table, "Vertices of the plot boundaries.", true, {}},
      {"run_references", DataKind::table, "The reference trees that the runs carry.", true, {}},
      {"run_reference_poses", DataKind::table, "The reference trajectories that the runs carry.", true, {}},
      {"reference_stems", DataKind::table, "Reference trees for all runs, in place of their own.", true, {}},
      {"reference_trajectory", DataKind::trajectory, "Reference path for all runs, in place of their own.", true, {}}};
  t.outputs = {{"runs", DataKind::table, "Each run with its plot and system.", false, {}},
               {"groups", DataKind::table, "Measures of each run and pooled.", false, {}, true},
               {"pairs", DataKind::table, "Differences of each two runs of a plot.", false, {}, true},
               {"trees", DataKind::table, "Matched, missed and extra trees of each run.", false, {}}};
  t.options = &option_table(static_cast<const CompareOptions*>(nullptr));
  t.run = compare;
  return t;
}

pipeline::StageResult evaluate_row_tables(const DataSet& in, const OptionSet& set, const Run&) {
  EvaluationOptions options;
  options.match_distance_m = set.as<RowMatchOptions>().match_distance_m;
  auto found = evaluate_rows(in.table("plants"), in.table("reference"), options);
  pipeline::StageResult result;
  copy_metrics(found.summary, result.report);
  const auto& kind = found.rows.texts("kind");
  const auto count = [&](const char* name, const char* of) {
    return result.report.counts[name] = std::ranges::count(kind, std::string(of));
  };
  const auto matched = count("rows_matched", "matched"), missed = count("rows_missed", "missed"),
             extra = count("rows_false", "false");
  if (matched == 0)
    result.report.warn(
        "no row matches a reference row: are both in the same axes? Place the frame (place.x, place.y, place.yaw, or "
        "marks), or raise match_distance");
  result.report.message = std::to_string(matched) + " rows matched, " + std::to_string(missed) + " missed, " +
                          std::to_string(extra) + " false";
  result.outputs.set("matches", std::move(found.rows));
  result.outputs.set("summary", std::move(found.summary));
  result.outputs.set("lines", std::move(found.reference_lines));
  return result;
}

pipeline::StageType rows_stage() {
  pipeline::StageType t;
  t.name = "evaluation.rows";
  t.vtk_class = "vtkBoleEvaluateRows";
  t.title = "Evaluate rows";
  t.help =
      "Compares plant rows with reference rows. Plants that stand within match_distance of one another are the same; a "
      "row is right when 90 % of its plants are those of one reference row. Gives the error of each row's direction "
      "against the least-squares line through its reference plants, and the share of rows, plants and gaps found.";
  t.source = "SPEC B: plant rows from a 3-D LiDAR (Zhao et al. 2023), tables 2 and 3";
  t.inputs = {{"plants", DataKind::table, "Plants in their rows: row_id, x_m, y_m; state where known.", false, {}},
              {"reference", DataKind::table, "Reference plants: row_id, x_m, y_m; state where known.", false, {}}};
  t.outputs = {{"matches", DataKind::table, "Matched, missed and false rows with their angles.", false, {}, true},
               {"summary", DataKind::table, "Measures of the comparison.", false, {}, true},
               {"lines", DataKind::table, "Ends of the lines through the reference plants.", false, {}}};
  t.options = &option_table(static_cast<const RowMatchOptions*>(nullptr));
  t.main_numbers = {"angle_error_mean", "angle_error_max", "row_recall"};
  t.run = evaluate_row_tables;
  return t;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(compare_stage());
  registry.add(rows_stage());
  pipeline::StageType t;
  t.name = "evaluation.plot";
  t.vtk_class = "vtkBoleEvaluatePlot";
  t.title = "Evaluate a plot";
  t.help =
      "Compares stems and trajectory with a reference. Stems are matched one to one (Hungarian method) within distance "
      "and diameter gates; rejected stems take no part. Reports completeness and correctness, mean and covariance of "
      "the position error, and bias and RMSE of the diameters, overall, by diameter class and, where a plot is "
      "connected, by distance from its centre. Reports the absolute and relative error of the trajectory. Without a "
      "reference the tables are empty. Columns of a field list with other headings are guessed and the guess is "
      "reported.";
  t.source = "Kuhn (1955); Umeyama (1991); measures of the paper on forest plots by improved LOAM (SPEC A11)";
  t.inputs = {{"stems", DataKind::table, "The stems to be judged.", false, {}},
              {"plot", DataKind::table, "Which trees count, from survey.plot; all of them when absent.", true, {}},
              {"trajectory", DataKind::trajectory, "The sensor path to be judged.", true, {}},
              {"reference_stems", DataKind::table, "Reference trees: tree_id, x_m, y_m, dbh_cm.", true, {}},
              {"reference_trajectory", DataKind::trajectory, "Reference path, on the same clock.", true, {}}};
  t.outputs = {{"matches", DataKind::table, "Matched, missed and false stems.", false, {}},
               {"summary", DataKind::table, "Measures, with published figures beside them.", false, {}, true}};
  t.version = 3;
  t.options = &option_table(static_cast<const EvaluationOptions*>(nullptr));
  t.main_numbers = {"ate_rmse",    "ate_max",  "drift",    "completeness",
                    "correctness", "dbh_bias", "dbh_rmse", "height_bias"};
  t.run = evaluate_plot;
  registry.add(std::move(t));
}

}  // namespace bole::evaluation
