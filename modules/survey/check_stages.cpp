// The stages survey.check and survey.revisit.
#include <fmt/format.h>

#include "base/no_number.h"
#include "cloud/known_facts.h"
#include "cloud/table_columns.h"
#include "survey/core/check/check_survey.h"
#include "survey/core/revisit/revisit.h"
#include "survey/survey_stages.h"

namespace bole::survey {
namespace {

pipeline::StageResult run_check(const DataSet& inputs, const OptionSet& options, const Run& run) {
  CheckInputs in;
  const auto table = [&](const char* port) { return inputs.has(port) ? &inputs.table(port) : nullptr; };
  if (inputs.has("points")) in.points = &inputs.cloud("points");
  if (inputs.has("dem")) in.dem = &inputs.raster("dem");
  if (inputs.has("trajectory")) in.trajectory = &inputs.trajectory("trajectory");
  in.stems = table("stems");
  in.plot = table("plot");
  in.loops = table("loops");
  in.targets = table("targets");
  auto check = check_survey(in, options.as<CheckOptions>(), run);
  pipeline::StageResult result;
  result.outputs.set("findings", std::move(check.findings));
  result.outputs.set("cells", std::move(check.cells));
  result.outputs.set("stem_measures", std::move(check.stems));
  result.outputs.set("boundary", std::move(check.boundary));
  result.report = std::move(check.report);
  return result;
}

}  // namespace

void register_check(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.check";
  type.vtk_class = "vtkBoleSurveyCheck";
  type.title = "Check the map";
  type.help =
      "Checks a surveyed plot before somebody signs it: ground never seen, density and directions of view in every "
      "cell, places that were not walked, surfaces of different passes, scatter about the bark, loop closures "
      "against "
      "the final trajectory, common lean of the stems, targets, trees on the boundary, stems in each other, stems "
      "without ground or points, heights without tops, and upright structures without a stem. The verdict is sign, "
      "look or walk again, with the reasons and where to go. What an input is missing for is listed as not judged.";
  type.source = "Bole";
  type.inputs = {
      {"points",
       DataKind::cloud,
       "The map; uses height_above_ground, sensor_x/y, pass or time where present.",
       true,
       {}},
      {"dem", DataKind::raster, "Terrain, for clouds without height_above_ground.", true, {}},
      {"trajectory", DataKind::trajectory, "The walk in the axes of the points.", true, {}},
      {"stems", DataKind::table, "Stems: x_m, y_m, and dbh_cm, lean_deg, height_seen where known.", true, {}},
      {"plot", DataKind::table, "Boundary and minimum diameter, from survey.plot.", true, {}},
      {"loops", DataKind::table, "Accepted loop closures, from slam.run.", true, {}},
      {"targets", DataKind::table, "Targets, from survey.frame.", true, {}}};
  type.outputs = {
      {.name = "findings",
       .kind = DataKind::table,
       .help = "What was found: code, severity, text, and where to go; the verdict is a fact.",
       .arrays = {},
       .in_summary = true},
      {"cells", DataKind::table, "The measures of every cell of the plot.", false, {}},
      {"stem_measures", DataKind::table, "Scatter about the bark and distance of the passes at each stem.", false, {}},
      {"boundary", DataKind::table, "Trees on the boundary, in or out by the rule.", false, {}}};
  type.main_numbers = {"ground_unseen", "one_sided", "ground_pass_spread", "stem_pass_spread", "wall", "common_lean"};
  type.options = &option_table(static_cast<const CheckOptions*>(nullptr));
  type.run = run_check;
  registry.add(std::move(type));
}

void register_revisit(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "survey.revisit";
  type.vtk_class = "vtkBoleSurveyRevisit";
  type.title = "Compare two surveys";
  type.help =
      "Brings two surveys of one plot together by the places and diameters of their stems, whatever the axes of the "
      "two, and tells what became of every tree: growth of its diameter with a 95 % interval, ingrowth, trees that "
      "are "
      "gone, and trees that one of the two missed, told apart by where they stand, how thick they are, whether their "
      "neighbours were found again and what the other survey rejected there. Maps that do not go together, or in "
      "more "
      "than one way, are refused.";
  type.source = "Bole";
  type.inputs = {
      {"first", DataKind::table, "Stems of the first survey: x_m, y_m, dbh_cm, dbh_lo_cm, dbh_hi_cm.", false, {}},
      {"second", DataKind::table, "Stems of the second survey.", false, {}},
      {"first_rejected", DataKind::table, "Candidates that the first survey rejected: x_m, y_m.", true, {}},
      {"second_rejected", DataKind::table, "Candidates that the second survey rejected.", true, {}}};
  type.outputs = {{"growth", DataKind::table, "A row per tree, in the axes of the first survey.", false, {}},
                  {.name = "values",
                   .kind = DataKind::table,
                   .help = "Values of the stand with their intervals.",
                   .arrays = {},
                   .in_summary = true}};
  type.main_numbers = {"matched", "grew", "shrank", "ingrowth", "gone", "distance_rms"};
  type.options = &option_table(static_cast<const RevisitOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    const auto table = [&](const char* port) { return inputs.has(port) ? &inputs.table(port) : nullptr; };
    auto found = revisit(inputs.table("first"), inputs.table("second"), table("first_rejected"),
                         table("second_rejected"), options.as<RevisitOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("growth", std::move(found.growth));
    result.outputs.set("values", std::move(found.values));
    result.report = std::move(found.report);
    return result;
  };
  registry.add(std::move(type));
}

}  // namespace bole::survey
