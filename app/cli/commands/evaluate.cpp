#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/user_path.h"
#include "commands.h"
#include "evaluation/core/evaluate_loops.h"
#include "evaluation/core/evaluate_plants.h"
#include "evaluation/core/evaluate_rows.h"
#include "evaluation/core/evaluate_stems.h"
#include "evaluation/core/evaluate_trajectory.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "option_flags.h"
#include "survey/core/plot_options.h"
#include "trajectory_figures.h"

namespace bole::cli {
namespace {

struct EvaluateArguments {
  OptionSet options{option_table(static_cast<const evaluation::EvaluationOptions*>(nullptr))};
  OptionSet plot{option_table(static_cast<const survey::PlotOptions*>(nullptr))};
  std::string estimate, reference;
  std::string figure, out, loops;  // of trajectories
  bool json = false;
};

void print_summary(const Table& summary, bool json) {
  const auto values = summary.numbers("value");
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < summary.rows(); ++i)
      list[summary.text("measure", i)] = {
          {"value", std::isfinite(values[i]) ? nlohmann::ordered_json(values[i]) : nlohmann::ordered_json(nullptr)},
          {"unit", summary.text("unit", i)},
          {"published", summary.text("published", i)}};
    fmt::print("{}\n", list.dump(2));
    return;
  }
  for (std::size_t i = 0; i < summary.rows(); ++i) {
    const auto published = summary.text("published", i);
    fmt::print("{:<36} {:>12.4f} {:<6}{}\n", summary.text("measure", i), values[i], summary.text("unit", i),
               published.empty() ? "" : " published " + published);
  }
  if (const auto it = summary.facts.find("published"); it != summary.facts.end())
    fmt::print("published figures: {}\n", it->second);
}

std::shared_ptr<EvaluateArguments> add_comparison(CLI::App& parent, const std::string& name, const std::string& help,
                                                  std::function<void(const EvaluateArguments&)> compare) {
  auto args = std::make_shared<EvaluateArguments>();
  auto* command = parent.add_subcommand(name, help);
  command->add_option("estimate", args->estimate, "What was measured")->required();
  command->add_option("reference", args->reference, "What it is held against")->required();
  command->add_flag("--json", args->json, "Print JSON");
  if (name == "trajectory") {
    command->add_option("--figure", args->figure, "Draw both paths and the error along the way (.svg, .pdf or .png)");
    command->add_option("--out", args->out, "Folder for figures and the table of errors");
    command->add_option("--loops", args->loops, "Revisits to be drawn (CSV: from_time_s, to_time_s)");
  }
  add_option_flags(*command, args->options);
  add_option_flags(*command, args->plot, "plot-");
  command->callback([args, compare = std::move(compare)] {
    for (auto* path : {&args->estimate, &args->reference, &args->figure, &args->out, &args->loops})
      *path = expand_home(*path);
    args->options.check_all();
    args->plot.check_all();
    compare(*args);
  });
  return args;
}

void compare_trajectories(const EvaluateArguments& args) {
  auto estimate = io::read_trajectory(args.estimate);
  const auto reference = io::read_trajectory(args.reference);
  const auto options = args.options.as<evaluation::EvaluationOptions>();
  const auto result = evaluation::evaluate_trajectory(estimate, reference, options);
  print_summary(result.summary, args.json);
  if (args.figure.empty() && args.out.empty()) return;
  for (auto& pose : estimate.poses) pose.T_target_sensor = result.T_reference_estimate * pose.T_target_sensor;
  std::optional<Table> loops;
  if (!args.loops.empty()) loops = evaluation::evaluate_loops(io::read_table(args.loops), reference, options).loops;
  draw_trajectories(estimate, reference, loops ? &*loops : nullptr, args.figure, args.out);
  if (!args.out.empty()) io::write_table(std::filesystem::path(args.out) / "trajectory_errors.csv", result.errors);
}

}  // namespace

void add_evaluate(Program& program) {
  auto* command = program.app.add_subcommand("evaluate", "Compare a table or trajectory with a reference");
  command->require_subcommand(1);
  add_comparison(*command, "stems", "Stem tables (CSV: tree_id, x_m, y_m, dbh_cm)", [](const EvaluateArguments& args) {
    const auto result = evaluation::evaluate_stems(
        io::read_table(args.estimate), io::read_table(args.reference), args.options.as<evaluation::EvaluationOptions>(),
        survey::counting_rule_for(args.plot.as<survey::PlotOptions>(), Axes::unknown, nullptr));
    if (!result.guessed_columns.empty())
      fmt::print(stderr,
                 "note: the columns of the reference were taken by their headings: {}; --reference-columns "
                 "names others\n",
                 result.guessed_columns);
    for (const auto& warning : result.warnings) fmt::print(stderr, "warning: {}\n", warning);
    print_summary(result.summary, args.json);
  });
  add_comparison(*command, "trajectory", "Trajectories (TUM: time x y z qx qy qz qw; or KITTI)",
                 [](const EvaluateArguments& args) { compare_trajectories(args); });
  add_comparison(*command, "rows", "Rows (CSV: row_id, x0_m, y0_m, x1_m, y1_m) or plants in rows (row_id, x_m, y_m)",
                 [](const EvaluateArguments& args) {
                   print_summary(
                       evaluation::evaluate_rows(io::read_table(args.estimate), io::read_table(args.reference),
                                                 args.options.as<evaluation::EvaluationOptions>())
                           .summary,
                       args.json);
                 });
  add_comparison(
      *command, "plants", "Traits of plants (CSV: plant_id, height_mm, stem_diameter_mm, ...)",
      [](const EvaluateArguments& args) {
        print_summary(
            evaluation::evaluate_plants(io::read_table(args.estimate), io::read_table(args.reference)).summary,
            args.json);
      });
  add_comparison(*command, "loops", "Revisits (CSV: from_time_s, to_time_s) against a trajectory",
                 [](const EvaluateArguments& args) {
                   print_summary(
                       evaluation::evaluate_loops(io::read_table(args.estimate), io::read_trajectory(args.reference),
                                                  args.options.as<evaluation::EvaluationOptions>())
                           .summary,
                       args.json);
                 });
}

}  // namespace bole::cli
