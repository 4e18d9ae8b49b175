#include "report/rows/rows_report.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "base/atomic_file.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"
#include "report/rows/rows_figures.h"

namespace bole::report {

const OptionTable& option_table(const RowsReportOptions*) {
  using S = RowsReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the figures and write them as PNG, SVG and PDF."},
      figure_width_row<S>(),
      dpi_row<S>(),
      OnlyIf{"figures", {"true"}, {"figure_width", "dpi"}},
  });
  return table;
}

namespace {

// Tenths of a millimetre and thousandths of a degree.
const io::Decimals& row_decimals() {
  static const io::Decimals d{{"x_m", 4},
                              {"y_m", 4},
                              {"x0_m", 4},
                              {"y0_m", 4},
                              {"x1_m", 4},
                              {"y1_m", 4},
                              {"angle_deg", 4},
                              {"angle_se_deg", 4},
                              {"angle_lo_deg", 4},
                              {"angle_hi_deg", 4},
                              {"spacing_m", 4},
                              {"spacing_sd_m", 4},
                              {"to_next_m", 4},
                              {"length_m", 3},
                              {"rms_m", 4},
                              {"sagitta_m", 3},
                              {"across_m", 4},
                              {"ref_angle_deg", 4},
                              {"angle_error_deg", 4},
                              {"shared", 3}};
  return d;
}

std::string fact(const Table& table, const std::string& name) {
  const auto it = table.facts.find(name);
  return it == table.facts.end() ? std::string() : it->second;
}

// Guidance lines with the attributes of their rows, in the order of `lines`.
io::VectorLayer guidance_layer(const Table& rows, const Table& lines, const std::string& crs) {
  io::VectorLayer layer{"rows", io::GeometryKind::line, {}, {}, crs};
  const auto x = lines.numbers("x_m"), y = lines.numbers("y_m");
  std::map<std::string, std::size_t> row_of;
  for (std::size_t i = 0; i < rows.rows(); ++i) row_of[rows.text("row_id", i)] = i;
  std::vector<std::size_t> picked;
  std::string last;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto id = lines.text("row_id", i);
    if (layer.shapes.empty() || id != last) {
      layer.shapes.emplace_back();
      picked.push_back(row_of.at(id));
      last = id;
    }
    layer.shapes.back().emplace_back(x[i], y[i], 0);
  }
  layer.attributes = rows.subset(picked);
  return layer;
}

// A-B lines: from the first end of the row to the last.
io::VectorLayer ab_layer(const Table& rows, const std::string& crs) {
  io::VectorLayer layer{"ab_lines", io::GeometryKind::line, {}, {}, crs};
  const auto x0 = rows.numbers("x0_m"), y0 = rows.numbers("y0_m"), x1 = rows.numbers("x1_m"), y1 = rows.numbers("y1_m");
  std::vector<std::size_t> picked;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    if (!(std::hypot(x1[i] - x0[i], y1[i] - y0[i]) > 0)) continue;  // a plant alone leads nowhere
    layer.shapes.push_back({{x0[i], y0[i], 0}, {x1[i], y1[i], 0}});
    picked.push_back(i);
  }
  Table attributes;
  const Table kept = rows.subset(picked);
  attributes.set("row_id", *kept.find("row_id"));
  attributes.set("angle_deg", *kept.find("angle_deg"));
  layer.attributes = std::move(attributes);
  return layer;
}

class RowsReport {
 public:
  RowsReport(const DataSet& inputs, const RowsReportOptions& options, const Run& run)
      : in_(inputs),
        rows_(inputs.table("rows")),
        plants_(inputs.table("plants")),
        lines_(inputs.table("lines")),
        strays_(inputs.has("strays") ? &inputs.table("strays") : nullptr),
        edits_(inputs.has("edits") ? &inputs.table("edits") : nullptr),
        pose_(inputs.has("pose") ? &inputs.table("pose") : nullptr),
        marks_(inputs.has("marks") ? &inputs.table("marks") : nullptr),
        matches_(inputs.has("matches") ? &inputs.table("matches") : nullptr),
        o_(options),
        run_(run),
        writer_(run) {}

  pipeline::StageResult write() {
    add_table("rows.csv", rows_);
    add_table("plants.csv", plants_);
    if (strays_ != nullptr) add_table("strays.csv", *strays_);
    if (edits_ != nullptr && edits_->rows() > 0) add_table("edits.csv", *edits_);
    if (pose_ != nullptr) add_table("sensor_pose.csv", *pose_);
    if (marks_ != nullptr) add_table("sensor_marks.csv", *marks_);
    if (matches_ != nullptr) add_table("row_matches.csv", *matches_);
    const std::string crs = fact(rows_, "crs");
    const auto guidance = guidance_layer(rows_, lines_, crs), ab = ab_layer(rows_, crs);
    writer_.write("rows.gpkg", [&](const auto& path) {
      std::vector<io::VectorLayer> layers{guidance, ab, io::point_layer("plants", plants_, crs)};
      if (strays_ != nullptr && strays_->rows() > 0) layers.push_back(io::point_layer("strays", *strays_, crs));
      io::write_geopackage(path, layers);
    });
    writer_.write_geojson("rows.geojson", guidance);
    writer_.write_geojson("ab_lines.geojson", ab);
    if (o_.figures)
      for (const auto& figure : rows_figures(in_, o_.figure_width))
        writer_.attempt(figure.what, [&] { writer_.save(figure.make(), {.dpi = o_.dpi}); });
    write_page();
    return writer_.finish();
  }

 private:
  void add_table(const std::string& file, const Table& table) {
    writer_.write(file, [&](const auto& path) { io::write_table(path, table, row_decimals()); });
  }

  void write_page() {
    page_.title = "Plant rows";
    Table missing = missing_plants();
    page_.paragraphs.push_back(fmt::format("Plants in rows: {} in {}; missing within rows: {}; in no row: {}.",
                                           plants_.rows() - missing.rows(), rows_.rows(), missing.rows(),
                                           strays_ != nullptr ? strays_->rows() : 0));
    page_.paragraphs.emplace_back(
        fact(rows_, "crs").empty()
            ? "Guidance lines for machines: the layers of rows.gpkg (A-B lines from the first end of each row to the "
              "last, and the course of curved rows, a vertex per metre). They are in metres of the plot: its place on "
              "the earth is not known, so there is no GeoJSON."
            : "Guidance lines for machines: ab_lines.geojson (from the first end of each row to the last), "
              "rows.geojson (the course of curved rows, a vertex per metre), and both as layers of rows.gpkg.");
    page_.tables.push_back({"Rows",
                            "Angles to due east with standard errors and 95 % intervals; lengths in metres.",
                            &rows_,
                            {{"row_id", "row"},
                             {"block", "block"},
                             {"angle_deg", "angle (deg)"},
                             {"angle_se_deg", "standard error"},
                             {"angle_lo_deg", "from"},
                             {"angle_hi_deg", "to"},
                             {"plants", "plants"},
                             {"missing", "missing"},
                             {"spacing_m", "spacing (m)"},
                             {"to_next_m", "to next row (m)"},
                             {"length_m", "length (m)"},
                             {"shape", "shape"}},
                            2});
    add_matches();
    add_pose();
    if (missing.rows() > 0)
      page_.tables.push_back({"Missing plants",
                              "",
                              &missing,
                              {{"row_id", "row"}, {"number", "place"}, {"x_m", "x (m)"}, {"y_m", "y (m)"}},
                              2});
    if (edits_ != nullptr && edits_->rows() > 0)
      page_.tables.push_back({"Edits",
                              "What a person changed after the rows were found.",
                              edits_,
                              {{"edit", "edit"},
                               {"action", "action"},
                               {"row_id", "row"},
                               {"outcome", "outcome"},
                               {"message", "message"},
                               {"author", "author"},
                               {"time", "time"},
                               {"reason", "reason"}},
                              2});
    page_.pictures = writer_.pictures();
    page_.warnings = page_warnings(run_.record.get(), writer_.report());
    writer_.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page_)); });
  }

  void add_matches() {
    if (matches_ != nullptr)
      page_.tables.push_back({"Comparison with the reference",
                              "Angles to due east in degrees: of the row, of the least-squares line through its "
                              "reference plants, and the first minus the second.",
                              matches_,
                              {{"kind", "result"},
                               {"row_id", "row"},
                               {"ref_id", "reference row"},
                               {"angle_deg", "angle"},
                               {"ref_angle_deg", "reference angle"},
                               {"angle_error_deg", "error"}},
                              2});
  }

  void add_pose() {
    if (pose_ != nullptr)
      page_.tables.push_back({"Sensor",
                              "Position and heading from marks, with standard errors. That of the heading is part of "
                              "the angle of every row.",
                              pose_,
                              {{"x_m", "x (m)"},
                               {"x_se_m", "standard error"},
                               {"y_m", "y (m)"},
                               {"y_se_m", "standard error"},
                               {"z_m", "z (m)"},
                               {"z_se_m", "standard error"},
                               {"yaw_deg", "yaw (deg)"},
                               {"yaw_se_deg", "standard error"},
                               {"sigma0", "residuals over expected"}},
                              3});
    if (marks_ != nullptr)
      page_.tables.push_back({"Marks",
                              "Known minus adjusted position of each mark in metres.",
                              marks_,
                              {{"name", "mark"}, {"dx_m", "x"}, {"dy_m", "y"}, {"dz_m", "z"}, {"range_m", "range"}},
                              3});
  }

  Table missing_plants() const {
    std::vector<std::size_t> picked;
    const auto& state = plants_.texts("state");
    for (std::size_t i = 0; i < state.size(); ++i)
      if (state[i] == "missing") picked.push_back(i);
    return plants_.subset(picked);
  }

  const DataSet& in_;
  const Table &rows_, &plants_, &lines_;
  const Table *strays_, *edits_, *pose_, *marks_, *matches_;
  const RowsReportOptions& o_;
  const Run& run_;
  ReportWriter writer_;
  SimplePage page_;
};

}  // namespace

pipeline::StageResult write_rows_report(const DataSet& inputs, const RowsReportOptions& options, const Run& run) {
  return RowsReport(inputs, options, run).write();
}

pipeline::StageType rows_report_stage() {
  pipeline::StageType type;
  type.name = "report.rows";
  type.vtk_class = "vtkBoleRowsReport";
  type.title = "Write the rows";
  type.help =
      "Writes plant rows into the output folder: rows.csv, plants.csv with the missing plants, strays.csv, rows.gpkg "
      "with guidance lines, A-B lines, plants and strays, rows.geojson and ab_lines.geojson, the row map as PNG, SVG "
      "and PDF, edits.csv where a person changed something, sensor_pose.csv and sensor_marks.csv where the sensor was "
      "resected, row_matches.csv where the rows were evaluated, and report.html with the tables and figures. With the "
      "steps of a frame it draws them on one sheet, with reference plants the rows beside and over theirs.";
  type.source = "Bole";
  type.inputs = {{"rows", DataKind::table, "Rows with their ends and directions.", false, {}},
                 {"plants", DataKind::table, "Plants in their rows.", false, {}},
                 {"lines", DataKind::table, "Vertices of the guidance lines.", false, {}},
                 {"strays", DataKind::table, "Plants in no row.", true, {}},
                 {"edits", DataKind::table, "What a person changed, from rows.edit.", true, {}},
                 {"pose", DataKind::table, "Pose of the sensor, from rows.resect.", true, {}},
                 {"marks", DataKind::table, "Residuals of its marks.", true, {}}};
  for (auto& port : rows_figure_ports()) type.inputs.push_back(std::move(port));
  type.version = 2;
  type.options = &option_table(static_cast<const RowsReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_rows_report(inputs, options.as<RowsReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
