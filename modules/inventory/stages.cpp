// Registers the stage of the module inventory.
#include "inventory/core/plot_values.h"
#include "inventory/core/value_tables.h"
#include "pipeline/stage.h"

namespace bole::inventory {
namespace {

std::string message_of(const PlotValues& values) {
  std::string text = std::to_string(values.stems) + (values.stems == 1 ? " stem counts" : " stems count");
  if (values.outside > 0) text += ", " + std::to_string(values.outside) + " outside the plot";
  if (values.too_thin > 0) text += ", " + std::to_string(values.too_thin) + " too thin";
  return text;
}

pipeline::StageResult run_plot_values(const DataSet& inputs, const OptionSet& set, const Run&) {
  const auto& options = set.as<PlotValueOptions>();
  const CountingRule rule = inputs.has("plot") ? counting_rule(inputs.table("plot")) : CountingRule{};
  const auto values = plot_values(inputs.table("stems"), rule, options);
  pipeline::StageResult result;
  result.report.counts["stems"] = static_cast<std::int64_t>(values.stems);
  result.report.message = message_of(values);
  result.outputs.set("plot_values", plot_value_table(values, options));
  result.outputs.set("diameter_classes", class_table(values));
  result.outputs.set("height_curve", height_curve_table(values));
  return result;
}

}  // namespace

void register_stages(pipeline::StageRegistry& registry) {
  pipeline::StageType type;
  type.name = "inventory.plot_values";
  type.vtk_class = "vtkBolePlotValues";
  type.title = "Compute plot values";
  type.help =
      "Computes stem density, basal area, mean diameters, heights and stem volume of a plot, with 95 % intervals, by "
      "diameter class too. Heights of stems whose top was not seen come from a height curve (Näslund); volumes come "
      "from the stem curves, else from diameter and height. Where too few tops were seen, heights and volumes are "
      "left out. Without a plot there are no values per hectare.";
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
       "Coefficients of the height curve; no row where there is none.",
       false,
       {},
       true}};
  type.options = &option_table(static_cast<const PlotValueOptions*>(nullptr));
  type.run = run_plot_values;
  registry.add(std::move(type));
}

}  // namespace bole::inventory
