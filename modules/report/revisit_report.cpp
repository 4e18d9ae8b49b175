#include "report/revisit_report.h"

#include <algorithm>

#include "base/atomic_file.h"
#include "cloud/known_facts.h"
#include "io/core/tables/table_file.h"
#include "render/charts/growth_charts.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"

namespace bole::report {

const OptionTable& option_table(const RevisitReportOptions*) {
  using S = RevisitReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic,
                      "Draw the map and the growth and write them as PNG, SVG and PDF."},
      figure_width_row<S>(),
      dpi_row<S>(),
      OnlyIf{"figures", {"true"}, {"figure_width", "dpi"}},
  });
  return table;
}

namespace {

const io::Decimals& growth_decimals() {
  static const io::Decimals d{{"x_m", 4},
                              {"y_m", 4},
                              {"dbh1_cm", 2},
                              {"dbh2_cm", 2},
                              {"growth_cm", 3},
                              {"growth_lo_cm", 3},
                              {"growth_hi_cm", 3},
                              {"growth_cm_per_year", 4},
                              {"growth_lo_cm_per_year", 4},
                              {"growth_hi_cm_per_year", 4},
                              {"distance_m", 4}};
  return d;
}

// The rows that count trees, or those that measure; with the words of people.
Table printed_values(const Table& values, bool counts) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < values.rows(); ++i)
    if (values.texts("unit")[i].empty() == counts) rows.push_back(i);
  Table out = values.subset(rows);
  auto measures = out.texts("measure");
  for (auto& m : measures) std::ranges::replace(m, '_', ' ');
  out.set("measure", std::move(measures));
  return out;
}

bool north_known(const Table& growth) {
  const auto axes = fact_text(growth.facts, facts::axes);
  return axes == "plot" || axes == "global";
}

void write_page(const Table& growth, const Table& values, const Run& run, ReportWriter& writer) {
  const Table measures = printed_values(values, false), counts = printed_values(values, true);
  SimplePage page;
  page.title = "The plot at two surveys";
  page.paragraphs.emplace_back(
      "Growth is the second less the first diameter; its interval is that of both diameters together. Trees that one "
      "survey alone has are told apart by where they stand, how thick they are and what the other survey found there.");
  page.tables.push_back({"The stand",
                         "95 % intervals; those of means include the error that all diameters of one survey share.",
                         &measures,
                         {{"measure", "measure"}, {"value", "value"}, {"lo", "from"}, {"hi", "to"}, {"unit", "unit"}},
                         3});
  page.tables.push_back({"Trees by what became of them", "", &counts, {{"measure", "kind"}, {"value", "trees"}}, 0});
  page.tables.push_back({"Trees",
                         "Places in the axes of the first survey.",
                         &growth,
                         {{"tree_id", "tree"},
                          {"tree_id_second", "at the second"},
                          {"kind", "kind"},
                          {"x_m", "x (m)"},
                          {"y_m", "y (m)"},
                          {"dbh1_cm", "DBH first (cm)"},
                          {"dbh2_cm", "DBH second (cm)"},
                          {"growth_cm", "growth (cm)"},
                          {"growth_lo_cm", "from"},
                          {"growth_hi_cm", "to"},
                          {"change", "change"},
                          {"why", "why"}},
                         2});
  page.pictures = writer.pictures();
  page.warnings = page_warnings(run.record.get(), writer.report());
  writer.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page)); });
}

}  // namespace

pipeline::StageResult write_revisit_report(const DataSet& inputs, const RevisitReportOptions& o, const Run& run) {
  ReportWriter writer(run);
  const Table &growth = inputs.table("growth"), &values = inputs.table("values");
  writer.write("growth.csv", [&](const auto& path) { io::write_table(path, growth, growth_decimals()); });
  writer.write("growth_values.csv", [&](const auto& path) { io::write_table(path, values); });
  if (o.figures) {
    writer.attempt("the map", [&] {
      writer.save(render::revisit_map(growth, north_known(growth), o.figure_width), {.dpi = o.dpi});
    });
    writer.attempt("the growth", [&] { writer.save(render::growth_chart(growth, o.figure_width), {.dpi = o.dpi}); });
  }
  write_page(growth, values, run, writer);
  return writer.finish();
}

pipeline::StageType revisit_report_stage() {
  pipeline::StageType type;
  type.name = "report.revisit";
  type.vtk_class = "vtkBoleRevisitReport";
  type.title = "Write the growth";
  type.help =
      "Writes the comparison of two surveys of one plot into the output folder: growth.csv with every tree, "
      "growth_values.csv with the values of the stand, the map of what grew, came and went and the growth over the "
      "diameter as PNG, SVG and PDF, and report.html with all of it.";
  type.source = "Bole";
  type.inputs = {{"growth", DataKind::table, "Trees of both surveys, from survey.revisit.", false, {}},
                 {"values", DataKind::table, "Values of the stand, from survey.revisit.", false, {}}};
  type.options = &option_table(static_cast<const RevisitReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_revisit_report(inputs, options.as<RevisitReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
