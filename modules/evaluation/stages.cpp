#include <optional>

#include "cloud/known_facts.h"
#include "evaluation/core/evaluate_stems.h"
#include "evaluation/core/evaluate_trajectory.h"
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

pipeline::StageResult evaluate_plot(const DataSet& in, const OptionSet& set, const Run& run) {
  const auto& options = set.as<EvaluationOptions>();
  const CountingRule rule = in.has("plot") ? counting_rule(in.table("plot")) : CountingRule{};
  pipeline::StageResult result;
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
      if (stems.matched == 0)
        r.warn("no stem matches a reference tree: are both in the same axes? align_stems and match_distance may help");
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
    summary = stacked(summary, trajectory.summary);
    if (const auto poses = fact_text(in.trajectory("trajectory").facts, facts::poses))
      result.report.facts[std::string(facts::poses.key)] = *poses;
  }
  copy_metrics(summary, result.report);
  result.report.message = message.empty() ? "nothing to compare with: no reference is connected" : message;
  result.outputs.set("matches", std::move(matches));
  result.outputs.set("summary", std::move(summary));
  return result;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  pipeline::StageType t;
  t.name = "evaluation.plot";
  t.vtk_class = "vtkBoleEvaluatePlot";
  t.title = "Evaluate a plot";
  t.help =
      "Compares stems and trajectory with a reference. Stems are matched one to one (Hungarian method) within distance "
      "and diameter gates; rejected stems take no part. Reports completeness and correctness, mean and covariance of "
      "the position error, and bias and RMSE of the diameters, overall, by diameter class and, where a plot is "
      "connected, by distance from its centre. Reports the absolute and relative error of the trajectory. Without a "
      "reference the tables are empty. Columns of a field list with other headings are guessed and the guess is reported.";
  t.source = "Kuhn (1955); Umeyama (1991); measures of the paper on forest plots by improved LOAM (SPEC A11)";
  t.inputs = {{"stems", DataKind::table, "The stems to be judged.", false, {}},
              {"plot", DataKind::table, "Which trees count, from survey.plot; all of them when absent.", true, {}},
              {"trajectory", DataKind::trajectory, "The sensor path to be judged.", true, {}},
              {"reference_stems", DataKind::table, "Reference trees: tree_id, x_m, y_m, dbh_cm.", true, {}},
              {"reference_trajectory", DataKind::trajectory, "Reference path, on the same clock.", true, {}}};
  t.outputs = {{"matches", DataKind::table, "Matched, missed and false stems.", false, {}},
               {"summary", DataKind::table, "Measures, with published figures beside them.", false, {}, true}};
  t.version = 2;
  t.options = &option_table(static_cast<const EvaluationOptions*>(nullptr));
  t.main_numbers = {"ate_rmse",    "ate_max",  "drift",    "completeness",
                    "correctness", "dbh_bias", "dbh_rmse", "height_bias"};
  t.run = evaluate_plot;
  registry.add(std::move(t));
}

}  // namespace bole::evaluation
