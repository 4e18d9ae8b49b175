#include "report/compare/compare_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "io/core/tables/table_decimals.h"
#include "io/core/tables/table_file.h"
#include "report/compare/compare_figures.h"
#include "report/compare/compare_tables.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"

namespace bole::report {

const OptionTable& option_table(const CompareReportOptions*) {
  using S = CompareReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"title", &S::title, TextKind::plain, {}, Tier::basic, "Title of the report."},
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the figures and write them as PNG, SVG and PDF."},
      Option<S, bool>{"cloud_figures", &S::cloud_figures, Tier::basic,
                      "Read the clouds of the runs and draw paths and slices on them. This takes the most time."},
      figure_width_row<S>(),
      Option<S, double>{"dpi", &S::dpi, Unit::dot_per_inch, {50, 1200}, Tier::basic, "Resolution of the PNG files."},
      Option<S, int>{"slices", &S::slices, Unit::none, {1, 24}, Tier::advanced, "Trees whose slices are drawn."},
      Option<S, std::optional<double>>{
          "enlarge",
          &S::enlarge,
          Unit::none,
          {1, 1000},
          "auto",
          Tier::advanced,
          "Factor by which the map of positions enlarges the errors. auto: so that they can be seen."},
      OnlyIf{"figures", {"true"}, {"cloud_figures", "figure_width", "dpi", "slices", "enlarge"}},
      OnlyIf{"cloud_figures", {"true"}, {"slices"}},
  });
  return table;
}

namespace {

using Json = nlohmann::ordered_json;

// A list of objects, one for each row; what is not known is null.
Json rows_of(const Table& table) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    Json row = Json::object();
    for (const auto& column : table.columns()) {
      if (const auto* numbers = std::get_if<std::vector<double>>(&column.values))
        row[column.name] = std::isfinite((*numbers)[i]) ? Json((*numbers)[i]) : Json(nullptr);
      else if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&column.values))
        row[column.name] = (*whole)[i];
      else
        row[column.name] = std::get<std::vector<std::string>>(column.values)[i];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

class CompareReport {
 public:
  CompareReport(const DataSet& inputs, const CompareReportOptions& options, const Run& run)
      : in_(inputs), o_(options), run_(run), writer_(run) {
    const auto table = [&](const char* port) { return inputs.has(port) ? &inputs.table(port) : nullptr; };
    data_ = {table("runs"),       table("compared"),        table("trees"), table("stems"), table("poses"),
             table("boundaries"), table("reference_poses"), table("loops"), table("groups")};
  }

  pipeline::StageResult write() {
    const auto &groups = in_.table("groups"), &pairs = in_.table("pairs");
    add_table("runs.csv", runs_with_plots());
    for (const auto& part : compare_parts())
      if (const Table rows = part_table(part, groups); rows.rows() > 0) add_table(part.file, rows);
    if (pairs.rows() > 0) add_table("pairs.csv", pairs);
    add_table("compared_trees.csv", in_.table("trees"));
    writer_.write("comparison.json", [&](const auto& path) { write_text_file(path, json().dump(1) + "\n"); });
    if (o_.figures) draw(run_.part(0.1, 0.95));
    write_page();
    auto result = writer_.finish();
    result.report.counts["figures"] = static_cast<std::int64_t>(writer_.pictures().size());
    result.report.message += ", read report.html first";
    return result;
  }

 private:
  void add_table(const std::string& file, const Table& table) {
    writer_.write(file, [&](const auto& path) { io::write_table(path, table, io::table_decimals()); });
  }

  // The runs as they were read, with the plot that the comparison found them to be of.
  Table runs_with_plots() const {
    Table runs = *data_.runs;
    runs.set("plot", data_.compared->texts("plot"));
    runs.set("agrees", data_.compared->integers("agrees"));
    return runs;
  }

  Json json() const {
    return {{"runs", rows_of(runs_with_plots())},
            {"groups", rows_of(in_.table("groups"))},
            {"pairs", rows_of(in_.table("pairs"))}};
  }

  void draw(const Run& run) {
    const auto plans = compare_figures(data_, o_, run);
    for (std::size_t i = 0; i < plans.size(); ++i) {
      if (writer_.ends_early()) return writer_.report().warn("asked to finish early: figures are left out");
      run.report(static_cast<double>(i) / static_cast<double>(plans.size()), "draw " + plans[i].what);
      writer_.attempt(plans[i].what, [&] {
        for (const auto& figure : plans[i].make())
          writer_.save(figure, {.dpi = o_.dpi, .wide = figure.width_mm > 0.8 * o_.figure_width});
      });
    }
  }

  void add_parts(const Table& measures, const std::string& prefix) {
    for (const auto& part : compare_parts()) {
      tables_.push_back(std::make_unique<Table>(printed_part(part, measures)));
      if (tables_.back()->rows() == 0) continue;
      page_.tables.push_back(
          {prefix + part.title, part.note, tables_.back().get(), page_columns(part, *tables_.back()), -1});
    }
  }

  void write_page() {
    page_.title = o_.title;
    const auto &groups = in_.table("groups"), &pairs = in_.table("pairs");
    page_.paragraphs.push_back(
        fmt::format("{} runs, {} rows of errors against a reference, {} pairs of runs of one plot.", data_.runs->rows(),
                    groups.rows(), pairs.rows()));
    bool published = false;
    for (const auto& column : groups.columns())
      if (column.name.starts_with("published_"))
        for (const double v : groups.numbers(column.name)) published = published || std::isfinite(v);
    if (published)
      page_.paragraphs.emplace_back(
          "In brackets: figures that the paper on improved LOAM published for the same system on the plot of this "
          "name, from field data that ours are held beside and not fitted to.");
    tables_.push_back(std::make_unique<Table>(runs_with_plots()));
    page_.tables.push_back({"Runs",
                            "",
                            tables_.back().get(),
                            {{"run", "run"},
                             {"name", "name"},
                             {"system", "system"},
                             {"plot", "plot"},
                             {"stems", "stems"},
                             {"poses", "poses"},
                             {"axes", "axes"},
                             {"verdict", "verdict"},
                             {"reference", "reference"},
                             {"folder", "folder"}},
                            0});
    add_parts(groups, "");
    add_parts(pairs, "Differences of two runs: ");
    page_.pictures = writer_.pictures();
    page_.warnings = page_warnings(run_.record.get(), writer_.report());
    writer_.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page_)); });
  }

  const DataSet& in_;
  const CompareReportOptions& o_;
  const Run& run_;
  ReportWriter writer_;
  CompareData data_;
  SimplePage page_;
  std::vector<std::unique_ptr<Table>> tables_;  // those of the page
};

}  // namespace

pipeline::StageResult write_compare_report(const DataSet& inputs, const CompareReportOptions& options, const Run& run) {
  return CompareReport(inputs, options, run).write();
}

pipeline::StageType compare_report_stage() {
  pipeline::StageType type;
  type.name = "report.compare";
  type.vtk_class = "vtkBoleCompareReport";
  type.title = "Write the comparison";
  type.help =
      "Writes a comparison of runs into the output folder: runs.csv, positions.csv and diameters.csv (tables 2 and 3 "
      "of "
      "the paper on improved LOAM, with its published figures beside), detection.csv, trajectories.csv, pairs.csv, "
      "compared_trees.csv, comparison.json, report.html, and the figures: paths on the cloud, slices side by side, "
      "path and "
      "map with their loop closures, map of positions, position errors, diameters and their errors by class, pooled "
      "and "
      "for each plot.";
  type.source =
      "The paper on forest plots by improved LOAM, figures 8 to 13 (SPEC A11); on orchard mapping, figure 4 (SPEC D)";
  type.inputs = {{"runs", DataKind::table, "A row per run, from io.read_runs.", false, {}},
                 {"compared", DataKind::table, "The runs with their plots, from evaluation.compare.", false, {}},
                 {"groups", DataKind::table, "Measures of each run and pooled.", false, {}},
                 {"pairs", DataKind::table, "Differences of each two runs of a plot.", false, {}},
                 {"trees", DataKind::table, "Matched, missed and extra trees.", false, {}},
                 {"stems", DataKind::table, "The stems of all runs.", false, {}},
                 {"poses", DataKind::table, "The trajectories of all runs.", true, {}},
                 {"boundaries", DataKind::table, "Vertices of the plot boundaries.", true, {}},
                 {"loops", DataKind::table, "The loop closures of all runs.", true, {}},
                 {"reference_poses", DataKind::table, "The reference trajectories that the runs carry.", true, {}}};
  type.version = 2;
  type.options = &option_table(static_cast<const CompareReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_compare_report(inputs, options.as<CompareReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
