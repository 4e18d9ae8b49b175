#include "report/sample_report.h"

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "io/core/tables/table_file.h"
#include "render/charts/sample_charts.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"

namespace bole::report {

const OptionTable& option_table(const SampleReportOptions*) {
  using S = SampleReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the curves and write them as PNG, SVG and PDF."},
      figure_width_row<S>(),
      dpi_row<S>(),
      OnlyIf{"figures", {"true"}, {"figure_width", "dpi"}},
  });
  return table;
}

namespace {

io::Decimals decimals_of(const Table& table) {
  io::Decimals d;
  for (const auto& column : table.columns()) d[column.name] = 4;
  return d;
}

PageTable measure_table(const Table& summary, const std::string& title, const std::string& measure,
                        const std::string& unit) {
  return {title,
          "Bias: mean of all sample plots minus the truth, with its standard error. SD: of single plots; at random: of "
          "trees that stand at random. All in percent of the truth.",
          &summary,
          {{"radius_m", "radius (m)"},
           {"edge", "edge"},
           {"partial_pct", "plots beyond the edge (%)"},
           {measure + "_true", "truth (" + unit + ")"},
           {measure + "_mean", "mean (" + unit + ")"},
           {measure + "_bias_pct", "bias (%)"},
           {measure + "_bias_se_pct", "standard error (%)"},
           {measure + "_sd_pct", "SD (%)"},
           {measure + "_poisson_sd_pct", "at random (%)"}},
          2};
}

}  // namespace

pipeline::StageResult write_sample_report(const DataSet& inputs, const SampleReportOptions& o, const Run& run) {
  ReportWriter writer(run);
  const auto& summary = inputs.table("summary");
  const auto add = [&](const char* file, const Table& table) {
    writer.write(file, [&](const auto& path) { io::write_table(path, table, decimals_of(table)); });
  };
  add("sample_summary.csv", summary);
  if (inputs.has("plots")) add("sample_plots.csv", inputs.table("plots"));
  if (o.figures)
    writer.attempt("curves", [&] { writer.save(render::sample_curves(summary, o.figure_width), {.dpi = o.dpi}); });
  SimplePage page;
  page.title = "Sample plots";
  page.paragraphs.emplace_back(
      "Circular sample plots at random places of a stand whose trees are all known. Edge, where a plot reaches beyond "
      "the "
      "stand: ignore divides by its whole area; inside places plots that fit in only; area divides by the area inside; "
      "mirage counts trees again in the plot's mirror image.");
  page.tables.push_back(measure_table(summary, "Basal area", "basal_area_m2_per_ha", "m2/ha"));
  page.tables.push_back(measure_table(summary, "Stems", "stems_per_ha", "1/ha"));
  page.pictures = writer.pictures();
  page.warnings = page_warnings(run.record.get(), writer.report());
  writer.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page)); });
  return writer.finish();
}

pipeline::StageType sample_report_stage() {
  pipeline::StageType type;
  type.name = "report.sample";
  type.vtk_class = "vtkBoleSampleReport";
  type.title = "Write the sample plots";
  type.help =
      "Writes what sample plots say about a known stand: tables by size and treatment of the edge, a row per plot, "
      "curves of bias and scatter, and report.html.";
  type.source = "Bole";
  type.inputs = {{"summary", DataKind::table, "A row per radius and treatment of the edge.", false, {}},
                 {"plots", DataKind::table, "A row per sample plot.", true, {}}};
  type.options = &option_table(static_cast<const SampleReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_sample_report(inputs, options.as<SampleReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
