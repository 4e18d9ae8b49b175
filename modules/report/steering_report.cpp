#include "report/steering_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "base/atomic_file.h"
#include "cloud/table_columns.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "render/charts/steering_charts.h"
#include "render/draw/axes.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"

namespace bole::report {

const OptionTable& option_table(const SteeringReportOptions*) {
  using S = SteeringReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the error curves and write them as PNG, SVG and PDF."},
      figure_width_row<S>(),
      dpi_row<S>(),
      OnlyIf{"figures", {"true"}, {"figure_width", "dpi"}},
  });
  return table;
}

namespace {

struct File {
  const char *port, *name, *help;
};
constexpr std::array<File, 8> files{{
    {"summary", "steering_summary.csv", "Errors by speed, the published ones beside."},
    {"passes", "steering_passes.csv", "Errors by pass."},
    {"errors", "steering_errors.csv", "Errors by fix."},
    {"log", "steering_log.csv", "The log of the drive."},
    {"parameters", "steering_gains.csv", "Gains from tuning."},
    {"steps", "steering_tuning.csv", "Every try of the tuning."},
    {"lines", "steering_lines.csv", "Guidance lines."},
    {"headlands", "steering_headlands.csv", "Corners of the headlands."},
}};

// Hundredths of a millimetre are more than any receiver knows.
io::Decimals decimals_of_log(const Table& table) {
  io::Decimals d;
  for (const auto& column : table.columns())
    if (column.name.ends_with("_m") || column.name == "time_s") d[column.name] = 5;
  return d;
}

// Metres as centimetres, for reading.
Table in_centimetres(const Table& table) {
  Table out;
  for (const auto& column : table.columns()) {
    if (!column.name.ends_with("_m") || column.name == "length_m" || column.name == "preview_m") {
      out.set(column.name, column.values);
      continue;
    }
    auto values = table.numbers(column.name);
    for (double& v : values) v *= 100;
    out.set(column.name.substr(0, column.name.size() - 2) + "_cm", std::move(values));
  }
  return out;
}

bool has_numbers(const Table& table, const std::string& column) {
  if (!table.has(column)) return false;
  const auto values = table.numbers(column);
  return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
}

using Columns = std::vector<std::pair<std::string, std::string>>;

const Columns& spread_columns() {
  static const Columns columns{{"line_mean_cm", "line mean"},
                               {"line_sd_cm", "SD"},
                               {"line_max_cm", "max"},
                               {"adjacent_mean_cm", "adjacent mean"},
                               {"adjacent_sd_cm", "SD"},
                               {"adjacent_max_cm", "max"},
                               {"controller_sd_cm", "controller SD"},
                               {"receiver_sd_cm", "receiver SD"}};
  return columns;
}

// In centimetres as words, the published figure of each in brackets.
Table with_published(const Table& summary) {
  const Table cm = in_centimetres(summary);
  Table out;
  out.set("speed_km_h", *cm.find("speed_km_h"));
  for (const auto& [column, heading] : spread_columns()) {
    if (!has_numbers(cm, column)) continue;
    const auto values = cm.numbers(column), published = numbers_or_nan(cm, "published_" + column);
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < values.size(); ++i) {
      cells.push_back(render::fixed(values[i], 2));
      if (std::isfinite(published[i])) cells.back() += " (" + render::fixed(published[i], 2) + ")";
    }
    out.set(column, std::move(cells));
  }
  return out;
}

class SteeringReport {
 public:
  SteeringReport(const DataSet& inputs, const SteeringReportOptions& options, const Run& run)
      : inputs_(inputs), o_(options), run_(run), writer_(run) {}

  pipeline::StageResult write() {
    for (const auto& file : files)
      if (inputs_.has(file.port))
        writer_.write(file.name, [&](const auto& path) {
          const auto& table = inputs_.table(file.port);
          io::write_table(path, table, decimals_of_log(table));
        });
    if (inputs_.has("lines")) write_lines();
    if (o_.figures && inputs_.has("errors")) writer_.attempt("error curves", [&] { draw(); });
    if (writer_.files().empty() && writer_.report().warnings.empty())
      throw bad_input("report.steering has no input",
                      "at least one of summary, passes, errors, log, parameters, steps, lines");
    write_page();
    return writer_.finish();
  }

 private:
  // For machines and maps, where the place of the plane on the earth is known.
  void write_lines() {
    const auto& lines = inputs_.table("lines");
    const auto crs = lines.facts.find("crs");
    io::VectorLayer layer{
        "ab_lines", io::GeometryKind::line, {}, lines, crs == lines.facts.end() ? std::string() : crs->second};
    const auto ax = lines.numbers("a_x_m"), ay = lines.numbers("a_y_m"), bx = lines.numbers("b_x_m"),
               by = lines.numbers("b_y_m");
    for (std::size_t i = 0; i < lines.rows(); ++i) layer.shapes.push_back({{ax[i], ay[i], 0}, {bx[i], by[i], 0}});
    placed_ = writer_.write_geojson("ab_lines.geojson", layer);
  }

  void draw() {
    const auto& errors = inputs_.table("errors");
    writer_.save(render::tracking_error_curves(errors, o_.figure_width), {.dpi = o_.dpi});
    if (has_numbers(errors, "adjacent_m"))
      writer_.save(render::adjacent_error_curves(errors, o_.figure_width), {.dpi = o_.dpi});
  }

  void add_table(std::string title, std::string note, const Table& table, Columns first, const Columns& more,
                 int decimals) {
    tables_.push_back(std::make_unique<Table>(in_centimetres(table)));
    for (const auto& column : more)  // what is not known has no column
      if (has_numbers(*tables_.back(), column.first)) first.push_back(column);
    page_.tables.push_back({std::move(title), std::move(note), tables_.back().get(), std::move(first), decimals});
  }

  void add_errors() {
    const auto& summary = inputs_.table("summary");
    // The shares of controller and receiver are known where the true way is.
    const bool true_way_known = has_numbers(summary, "controller_sd_m");
    const std::string words =
        true_way_known
            ? "In centimetres. Line: true distance of the control point from its line, positive to the left. Adjacent: "
              "distance of neighbouring passes minus the row width. SD: about the mean. Controller: what the steering "
              "left of the distance that it received; receiver: received minus true, which steering cannot correct."
            : "In centimetres. Line: distance of the control point from its line as the receiver saw it, positive to "
              "the "
              "left; the true way is not known, and what the receiver erred is not in these figures. Adjacent: "
              "distance "
              "of neighbouring passes minus the row width, as the receiver saw it. SD: about the mean.";
    if (!has_numbers(summary, "published_line_sd_m"))
      return add_table("Errors by speed", words, summary, {{"speed_km_h", "km/h"}}, spread_columns(), 2);
    tables_.push_back(std::make_unique<Table>(with_published(summary)));
    Columns columns{{"speed_km_h", "km/h"}};
    for (const auto& column : spread_columns())
      if (tables_.back()->has(column.first)) columns.push_back(column);
    page_.tables.push_back({"Errors by speed",
                            words +
                                " In brackets: table 2 of the paper, by a tractor in the field, which a simulated one "
                                "is held beside and not fitted to." +
                                (true_way_known ? "" : " It was measured against a reference, ours was not."),
                            tables_.back().get(), std::move(columns), 2});
  }

  void write_page() {
    page_.title = inputs_.has("parameters")                        ? "Tuning of the steering"
                  : inputs_.has("lines") && !inputs_.has("passes") ? "Guidance lines"
                                                                   : "Steering test";
    if (inputs_.has("passes"))
      page_.paragraphs.push_back(fmt::format("{} passes along their lines.", inputs_.table("passes").rows()));
    if (inputs_.has("summary")) add_errors();
    if (inputs_.has("passes"))
      add_table("Passes", "In centimetres; lengths in metres. Direction 1: from A to B.", inputs_.table("passes"),
                {{"run", "run"},
                 {"pass", "pass"},
                 {"row", "row"},
                 {"direction", "direction"},
                 {"speed_km_h", "km/h"},
                 {"length_m", "length (m)"}},
                spread_columns(), 2);
    if (inputs_.has("lines"))
      page_.tables.push_back({"Guidance lines",
                              std::string("In metres, from A to B; line 0 leads through A and B, line 1 is the next "
                                          "to its left. ") +
                                  (placed_ ? "ab_lines.geojson holds them for machines and maps."
                                           : "steering_lines.csv holds them; their place on the earth is not known, so "
                                             "there is no GeoJSON."),
                              &inputs_.table("lines"),
                              {{"line", "line"},
                               {"part", "part"},
                               {"a_x_m", "A x"},
                               {"a_y_m", "A y"},
                               {"b_x_m", "B x"},
                               {"b_y_m", "B y"},
                               {"length_m", "length"}},
                              2});
    for (const auto& [port, title] : {std::pair{"parameters", "Gains"}, {"steps", "Tries"}})
      if (inputs_.has(port)) {
        Columns columns;
        const Table shown = in_centimetres(inputs_.table(port));
        for (const auto& c : shown.columns()) columns.emplace_back(c.name, c.name);
        add_table(title, "", inputs_.table(port), std::move(columns), {}, 3);
      }
    page_.pictures = writer_.pictures();
    page_.warnings = page_warnings(run_.record.get(), writer_.report());
    writer_.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page_)); });
  }

  const DataSet& inputs_;
  const SteeringReportOptions& o_;
  const Run& run_;
  ReportWriter writer_;
  SimplePage page_;
  bool placed_ = false;                         // the guidance lines are in ab_lines.geojson
  std::vector<std::unique_ptr<Table>> tables_;  // those of the page
};

}  // namespace

pipeline::StageResult write_steering_report(const DataSet& inputs, const SteeringReportOptions& options,
                                            const Run& run) {
  return SteeringReport(inputs, options, run).write();
}

pipeline::StageType steering_report_stage() {
  pipeline::StageType type;
  type.name = "report.steering";
  type.vtk_class = "vtkBoleSteeringReport";
  type.title = "Write the steering test";
  type.help =
      "Writes the errors of a steering test by speed, pass and fix, the log, the tuning, guidance lines (also as "
      "GeoJSON), and the error curves as PNG, SVG and PDF into the output folder, and report.html, one page with the "
      "tables and curves. Errors stand beside those that the paper published. Inputs that are not connected are left "
      "out.";
  type.source = "Bole";
  for (const auto& file : files) type.inputs.push_back({file.port, DataKind::table, file.help, true, {}});
  type.options = &option_table(static_cast<const SteeringReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_steering_report(inputs, options.as<SteeringReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
