// Registers the stages of the module inventory.
#include <fmt/format.h>

#include <cmath>

#include "inventory/core/plot_values.h"
#include "inventory/core/sample_plots.h"
#include "inventory/core/value_tables.h"
#include "pipeline/stage.h"

namespace bole::inventory {
namespace {

// "21.3 m2/ha", or in m2 where there is no plot area.
std::string basal_area_text(const PlotValues& values, double per_ha, double total) {
  return std::isfinite(values.area_m2) ? fmt::format("{:.1f} m2/ha", per_ha) : fmt::format("{:.2f} m2", total);
}
std::string sound_basal_area(const PlotValues& v) {
  return basal_area_text(v, v.sound.basal_area_m2_per_ha, v.sound.basal_area_m2);
}
std::string whole_basal_area(const PlotValues& v) {
  return basal_area_text(v, v.basal_area_m2_per_ha, v.basal_area_m2);
}

// "15 sound, 17 to check: basal area 21.3 m2/ha (23.9 m2/ha with them); 3 outside the plot"
std::string message_of(const PlotValues& values) {
  std::string text;
  if (values.to_check > 0)
    text = fmt::format("{} sound, {} to check: basal area {} ({} with them)", values.sound.stems, values.to_check,
                       sound_basal_area(values), whole_basal_area(values));
  else
    text = std::to_string(values.stems) + (values.stems == 1 ? " stem counts" : " stems count");
  if (values.to_check == 0 && values.stems > 0) text += ": basal area " + whole_basal_area(values);
  if (values.outside > 0) text += "; " + std::to_string(values.outside) + " outside the plot";
  if (values.too_thin > 0) text += "; " + std::to_string(values.too_thin) + " too thin";
  return text;
}

void judge_doubtful(const PlotValues& v, Report& report) {
  report.counts["stems_sound"] = static_cast<std::int64_t>(v.sound.stems);
  report.counts["stems_to_check"] = static_cast<std::int64_t>(v.to_check);
  if (!many_to_check(v)) return;
  const bool most = mostly_to_check(v);
  report.find(most ? Severity::refused : Severity::look, "stems_to_check",
              fmt::format("{} of the {} stems that count are to be checked: the basal area is {} without and {} with "
                          "them. {} (column 'reasons' of the stem table), then accept, resize or reject them",
                          v.to_check, v.stems, sound_basal_area(v), whole_basal_area(v),
                          most ? "If most have one reason, look for its cause in the cloud (registration, wind, unit, "
                                 "density); else look at their slices"
                               : "Look at their slices"));
}

pipeline::StageResult run_plot_values(const DataSet& inputs, const OptionSet& set, const Run&) {
  const auto& options = set.as<PlotValueOptions>();
  const CountingRule rule = inputs.has("plot") ? counting_rule(inputs.table("plot")) : CountingRule{};
  const auto values = plot_values(inputs.table("stems"), rule, options);
  pipeline::StageResult result;
  result.report.counts["stems"] = static_cast<std::int64_t>(values.stems);
  result.report.message = message_of(values);
  judge_doubtful(values, result.report);
  result.outputs.set("plot_values", plot_value_table(values, options));
  result.outputs.set("diameter_classes", class_table(values));
  result.outputs.set("height_curve", height_curve_table(values));
  result.outputs.set("tree_values", tree_value_table(values, inputs.table("stems")));
  return result;
}

pipeline::StageType sample_stage() {
  pipeline::StageType type;
  type.name = "inventory.sample";
  type.vtk_class = "vtkBoleSamplePlots";
  type.title = "Sample a known stand";
  type.help =
      "Lays many circular sample plots of several sizes at random into a stand whose trees are all known, and compares "
      "what they say with the truth: bias and scatter of stems and basal area per hectare. Four ways to treat the edge "
      "of the stand stand side by side: ignored, plots that fit in only, the area inside, and mirrored plots (mirage).";
  type.source = "Schmid-Haas (1969); Gregoire and Valentine (2008)";
  type.inputs = {{"stems", DataKind::table, "All trees of the stand: x_m, y_m, dbh_cm.", false, {}},
                 {"stand", DataKind::table, "The rectangle that is sampled, from survey.plot.", false, {}}};
  type.outputs = {{"summary", DataKind::table, "A row per radius and treatment of the edge.", false, {}, true},
                  {"plots", DataKind::table, "A row per sample plot.", false, {}}};
  type.options = &option_table(static_cast<const SampleOptions*>(nullptr));
  type.run = [](const DataSet& inputs, const OptionSet& set, const Run& run) {
    auto study =
        sample_plots(inputs.table("stems"), counting_rule(inputs.table("stand")), set.as<SampleOptions>(), run);
    pipeline::StageResult result;
    result.outputs.set("summary", std::move(study.summary));
    result.outputs.set("plots", std::move(study.plots));
    result.report = std::move(study.report);
    return result;
  };
  return type;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  registry.add(sample_stage());
  pipeline::StageType type;
  type.name = "inventory.plot_values";
  type.vtk_class = "vtkBolePlotValues";
  type.title = "Compute plot values";
  type.help =
      "Computes stem density, basal area, mean diameters, heights and stem volume of a plot, with 95 % intervals, by "
      "diameter class too. Heights of stems whose top was not seen come from a height curve (Näslund); volumes come "
      "from the stem curves, else from diameter and height. Where too few tops were seen, heights and volumes are "
      "left out. Without a plot there are no values per hectare. Values without the stems that are to be checked stand "
      "beside those with them.";
  type.source = "Näslund (1936); van Laar and Akça (2007); volumes by form and intervals: Bole";
  type.inputs = {{"stems", DataKind::table, "Stems with x_m, y_m and dbh_cm.", false, {}},
                 {"plot", DataKind::table, "Which trees count, from survey.plot; all of them when absent.", true, {}}};
  type.outputs = {
      {"plot_values",
       DataKind::table,
       "A row per measure: measure, value, unit, lo, hi, half, sampled_half.",
       false,
       {},
       true},
      {"diameter_classes", DataKind::table, "Stems, basal area and mean height by diameter class.", false, {}, true},
      {"height_curve",
       DataKind::table,
       "Coefficients of the height curve, spread and number of its residuals; no row where there is none.",
       false,
       {},
       true},
      {"tree_values",
       DataKind::table,
       "A row per stem that counts: height with its source and residual, volume with its 95 % interval.",
       false,
       {},
       true}};
  type.version = 2;
  type.options = &option_table(static_cast<const PlotValueOptions*>(nullptr));
  type.run = run_plot_values;
  registry.add(std::move(type));
}

}  // namespace bole::inventory
