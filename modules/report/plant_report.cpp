#include "report/plant_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/atomic_file.h"
#include "cloud/table_columns.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/tables/table_file.h"
#include "io/core/tables/trajectory_file.h"
#include "render/charts/match_figure.h"
#include "render/charts/plant_charts.h"
#include "render/charts/stem_in_depth.h"
#include "report/core/page_warnings.h"
#include "report/core/simple_page.h"
#include "report/figure_rows.h"
#include "report/report_writer.h"
#include "report/workbook.h"

namespace bole::report {

const OptionTable& option_table(const PlantReportOptions*) {
  using S = PlantReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the figures and write them as PNG, SVG and PDF."},
      Option<S, bool>{
          "scene", &S::scene, Tier::basic,
          "Write scene.ply: all points, with the part that each belongs to, beside cloud.ply, which has the "
          "plant alone."},
      figure_width_row<S>(),
      dpi_row<S>(),
      OnlyIf{"figures", {"true"}, {"figure_width", "dpi"}},
  });
  return table;
}

namespace {

constexpr std::int32_t plant_part = 1;

struct TableFile {
  const char* port;
  const char* file;
  const char* sheet;
};
constexpr TableFile table_files[] = {{"traits", "traits.csv", "Traits"},
                                     {"stem", "stem.csv", "Stem"},
                                     {"leaves", "leaves.csv", "Leaves"},
                                     {"internodes", "internodes.csv", "Internodes"},
                                     {"branches", "branches.csv", "Branches"},
                                     {"contours", "contours.csv", "Contours"},
                                     {"tracking", "tracking.csv", "Views"},
                                     {"matches", "matches.csv", "Matches"},
                                     {"held_out", "held_out.csv", "Held-out views"},
                                     {"edits", "edits.csv", "Edits"}};

// The points of the plant; all where nothing tells them apart.
PointCloud plant_of(const PointCloud& cloud) {
  if (!cloud.has("part")) return cloud;
  const auto& part = cloud.column("part");
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (column_value(part, i) == plant_part) kept.push_back(static_cast<std::uint32_t>(i));
  return cloud.subset(kept);
}

// Three digits behind the point for millimetres, one for decibels.
io::Decimals decimals_for(const Table& table) {
  io::Decimals out;
  for (const auto& column : table.columns()) {
    if (column.name.ends_with("_mm")) out[column.name] = 3;
    if (column.name.ends_with("_cm2") || column.name.ends_with("_cm3")) out[column.name] = 3;
    if (column.name.ends_with("_m")) out[column.name] = 6;
    if (column.name.ends_with("_db") || column.name.ends_with("_deg")) out[column.name] = 2;
  }
  return out;
}

nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

double mean_of(const std::vector<double>& values) {
  double sum = 0, count = 0;
  for (const double v : values)
    if (std::isfinite(v)) sum += v, ++count;
  return sum / count;
}

class PlantReport {
 public:
  PlantReport(const DataSet& inputs, const PlantReportOptions& options, const Run& run)
      : inputs_(inputs), o_(options), run_(run), writer_(run) {}

  pipeline::StageResult write() {
    if (inputs_.all().empty()) throw bad_input("report.plant has no input", "at least the traits or the points");
    write_tables();
    if (inputs_.has("poses"))
      writer_.write("trajectory.tum", [&](const auto& path) { io::write_tum(path, inputs_.trajectory("poses")); });
    if (inputs_.has("points")) write_points();
    if (inputs_.has("held_out"))
      writer_.write("field.json", [&](const auto& path) { write_text_file(path, field_json()); });
    if (o_.figures && !writer_.ends_early()) draw();
    write_page();
    return writer_.finish();
  }

 private:
  const Table* table(const char* port) const { return inputs_.has(port) ? &inputs_.table(port) : nullptr; }

  void write_tables() {
    std::vector<NamedTable> sheets;
    for (const auto& [port, file, sheet] : table_files) {
      const auto* t = table(port);
      if (t == nullptr || t->columns().empty()) continue;
      if (port == std::string_view("edits") && t->rows() == 0) continue;  // nobody changed anything
      writer_.write(file, [&](const auto& path) { io::write_table(path, *t, decimals_for(*t)); });
      sheets.push_back({sheet, t});
    }
    if (!sheets.empty()) writer_.write("plant.xlsx", [&](const auto& path) { write_workbook(path, sheets, run_); });
  }

  void write_points() {
    const auto& points = inputs_.cloud("points");
    const auto plant = plant_of(points);
    if (plant.empty() && !points.empty())
      writer_.report().find(Severity::look, "no_plant",
                            "no point was found to be of the plant: cloud.ply has all points");
    writer_.write("cloud.ply", [&](const auto& path) { io::write_ply(path, plant.empty() ? points : plant, run_); });
    if (o_.scene && points.has("part"))
      writer_.write("scene.ply", [&](const auto& path) { io::write_ply(path, points, run_); });
  }

  // How well the field shows views that it was not made from.
  std::string field_json() const {
    const auto& held_out = inputs_.table("held_out");
    nlohmann::ordered_json json;
    const auto psnr = numbers_or_nan(held_out, "psnr_db"), view = numbers_or_nan(held_out, "view");
    const auto name = texts_or_empty(held_out, "name");
    json["psnr_db"] = number_or_null(mean_of(psnr));
    for (const auto& column : held_out.columns())
      if (column.name.starts_with("psnr_") && column.name != "psnr_db")
        json[column.name] = number_or_null(mean_of(held_out.numbers(column.name)));
    json["held_out_views"] = held_out.rows();
    json["views"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < held_out.rows(); ++i)
      json["views"].push_back(
          {{"view", number_or_null(view[i])}, {"name", name[i]}, {"psnr_db", number_or_null(psnr[i])}});
    if (inputs_.has("field"))
      for (const auto& [key, value] : inputs_.table("field").facts) {
        const auto parsed = nlohmann::ordered_json::parse(value, nullptr, false);
        json[key] = parsed.is_discarded() ? nlohmann::ordered_json(value) : parsed;
      }
    return json.dump(2) + "\n";
  }

  void draw() {
    if (inputs_.has("points"))
      writer_.attempt("plant", [&] {
        writer_.save(render::plant_drawing({&inputs_.cloud("points"), table("traits")}, o_.figure_width),
                     {.dpi = o_.dpi, .as_pixels = true});
      });
    if (const auto* stem = table("stem"); stem != nullptr && stem->rows() > 1)
      writer_.attempt("stem", [&] {
        writer_.save(render::stem_chart(*stem, o_.figure_width / 2), {.dpi = o_.dpi, .wide = false});
      });
    if (table("contours") != nullptr && inputs_.has("views"))
      writer_.attempt("stem in depth", [&] { draw_stem_in_depth(); });
    if (table("matches") != nullptr && inputs_.has("views")) writer_.attempt("matches", [&] { draw_matches(); });
    if (const auto* held_out = table("held_out"); held_out != nullptr && held_out->rows() > 0)
      writer_.attempt("held-out views", [&] {
        writer_.save(render::held_out_chart(*held_out, o_.figure_width / 2), {.dpi = o_.dpi, .wide = false});
      });
    if (const auto* progress = table("progress"); progress != nullptr && progress->rows() > 1)
      writer_.attempt("making of the field", [&] {
        writer_.save(render::training_chart(*progress, o_.figure_width / 2), {.dpi = o_.dpi, .wide = false});
      });
  }

  void draw_matches() {
    const auto pair = render::typical_pair(*table("matches"));
    if (!pair) return;
    const auto& views = inputs_.views("views");
    std::optional<std::size_t> a, b;
    for (std::size_t i = 0; i < views.size(); ++i) {
      if (views.name(i) == pair->name_a) a = i;
      if (views.name(i) == pair->name_b) b = i;
    }
    if (!a || !b) return;
    const ViewParts color_only{.color = true, .depth = false, .mask = false};
    View view_a, view_b;
    views.read(*a, view_a, color_only);
    views.read(*b, view_b, color_only);
    if (view_a.color.empty() || view_b.color.empty()) return;
    writer_.save(render::match_figure(*pair, view_a.color, view_b.color, o_.figure_width),
                 {.dpi = std::min(o_.dpi, page_dpi), .vectors = false});
  }

  // Only where the scale is known: the diameter says how far the stem is.
  void draw_stem_in_depth() {
    const auto* traits = table("traits");
    const auto edges = render::largest_stem(*table("contours"));
    const auto& views = inputs_.views("views");
    if (!edges || traits == nullptr || traits->rows() == 0 || !traits->has("stem_diameter_mm") || !views.has_depth() ||
        edges->view >= static_cast<std::int64_t>(views.size()) || texts_or_empty(*traits, "scale").front() != "known")
      return;
    const double diameter_m = traits->numbers("stem_diameter_mm").front() / 1000;
    const auto i = static_cast<std::size_t>(edges->view);
    View view;
    views.read(i, view, {.color = true, .depth = true, .mask = false});
    const auto& camera = views.camera(i).color;
    if (view.depth.empty() || !(diameter_m > 0)) return;
    if (view.color.width != camera.width || view.color.height != camera.height) return;
    writer_.save(
        render::stem_in_depth_figure(*edges, view.color, view.depth, views.camera(i), diameter_m, o_.figure_width),
        {.dpi = std::min(o_.dpi, page_dpi), .vectors = false});
  }

  // The traits with their intervals, one below the other.
  Table trait_rows(const Table& traits) const {
    std::vector<std::string> names, units;
    std::vector<double> value, lo, hi;
    for (const auto& column : traits.columns()) {
      const auto unit_at = column.name.rfind('_');
      if (unit_at == std::string::npos || std::holds_alternative<std::vector<std::string>>(column.values)) continue;
      const std::string stem = column.name.substr(0, unit_at), unit = column.name.substr(unit_at + 1);
      if (!traits.has(stem + "_lo_" + unit) || !std::isfinite(traits.numbers(column.name).front())) continue;
      std::string words = stem;
      std::ranges::replace(words, '_', ' ');
      names.push_back(words), units.push_back(unit);
      value.push_back(traits.numbers(column.name).front());
      lo.push_back(traits.numbers(stem + "_lo_" + unit).front());
      hi.push_back(traits.numbers(stem + "_hi_" + unit).front());
    }
    Table out;
    out.set("trait", std::move(names)), out.set("value", std::move(value));
    out.set("lo", std::move(lo)), out.set("hi", std::move(hi)), out.set("unit", std::move(units));
    return out;
  }

  // Columns that a table does not have are left out.
  void add_organs() {
    using Columns = std::vector<std::pair<std::string, std::string>>;
    const auto add = [&](const char* port, const char* title, const char* note, Columns columns) {
      if (const auto* t = table(port); t != nullptr && t->rows() > 0)
        page_.tables.push_back({title, note, t, std::move(columns), 1});
    };
    add("leaves", "Leaves",
        "From the lowest node upwards, the main stem (axis 0) first. Height of the node; azimuth from x towards y; "
        "angle "
        "between petiole and stem; length, width and area of the blade, one side, with its 95 % interval.",
        {{"leaf", "leaf"},
         {"axis", "axis"},
         {"height_mm", "height (mm)"},
         {"azimuth_deg", "azimuth (deg)"},
         {"angle_deg", "angle (deg)"},
         {"petiole_mm", "petiole (mm)"},
         {"length_mm", "length (mm)"},
         {"width_mm", "width (mm)"},
         {"area_cm2", "area (cm2)"},
         {"area_lo_cm2", "from"},
         {"area_hi_cm2", "to"},
         {"quality", "quality"},
         {"remark", "remark"}});
    add("internodes", "Internodes", "Along the stem, from the soil upwards.",
        {{"axis", "axis"},
         {"from_leaf", "from leaf"},
         {"to_leaf", "to leaf"},
         {"length_mm", "length (mm)"},
         {"turn_deg", "turn (deg)"},
         {"quality", "quality"}});
    add("branches", "Branches", "",
        {{"branch", "branch"},
         {"parent", "grows from"},
         {"height_mm", "height (mm)"},
         {"angle_deg", "angle (deg)"},
         {"length_mm", "length (mm)"},
         {"leaves", "leaves"}});
  }

  // "15 leaves, 2 branches."
  std::string organ_sentence(const Table& traits) const {
    const double leaves = numbers_or_nan(traits, "leaf_count")[0], branches = numbers_or_nan(traits, "branch_count")[0];
    if (!std::isfinite(leaves)) return {};
    std::string text = fmt::format("{:.0f} {}", leaves, leaves == 1 ? "leaf" : "leaves");
    if (branches > 0) text += fmt::format(", {:.0f} {}", branches, branches == 1 ? "branch" : "branches");
    return text + ".";
  }

  void write_page() {
    page_.title = "Seedling";
    if (const auto* traits = table("traits"); traits != nullptr && traits->rows() > 0) {
      trait_rows_ = trait_rows(*traits);
      page_.tables.push_back({"Traits",
                              "With 95 % intervals.",
                              &trait_rows_,
                              {{"trait", "trait"}, {"value", "value"}, {"lo", "from"}, {"hi", "to"}, {"unit", "unit"}},
                              2});
    }
    if (const auto* traits = table("traits"); traits != nullptr && traits->rows() > 0)
      if (auto text = organ_sentence(*traits); !text.empty()) page_.paragraphs.push_back(std::move(text));
    if (const auto* tracking = table("tracking"); tracking != nullptr && tracking->has("state")) {
      const auto& state = tracking->texts("state");
      const auto lost = std::ranges::count(state, "lost");
      page_.paragraphs.push_back(fmt::format("{} views, {} with a pose, {} lost.", state.size(),
                                             static_cast<std::ptrdiff_t>(state.size()) - lost, lost));
    }
    if (const auto* held_out = table("held_out"); held_out != nullptr && held_out->rows() > 0)
      page_.paragraphs.push_back(
          fmt::format("{} views were held out: the field shows them with a mean PSNR of {:.1f} dB.", held_out->rows(),
                      mean_of(numbers_or_nan(*held_out, "psnr_db"))));
    add_organs();
    if (const auto* t = table("edits"); t != nullptr && t->rows() > 0) {
      std::vector<std::pair<std::string, std::string>> columns;
      for (const auto& column : t->columns()) columns.emplace_back(column.name, column.name);
      page_.tables.push_back({"Edits", "What a person changed.", t, std::move(columns), 2});
    }
    page_.pictures = writer_.pictures();
    page_.warnings = page_warnings(run_.record.get(), writer_.report());
    writer_.write("report.html", [&](const auto& path) { write_text_file(path, simple_page_html(page_)); });
  }

  const DataSet& inputs_;
  const PlantReportOptions& o_;
  const Run& run_;
  ReportWriter writer_;
  SimplePage page_;
  Table trait_rows_;
};

}  // namespace

pipeline::StageResult write_plant_report(const DataSet& inputs, const PlantReportOptions& options, const Run& run) {
  return PlantReport(inputs, options, run).write();
}

pipeline::StageType plant_report_stage() {
  pipeline::StageType type;
  type.name = "report.plant";
  type.vtk_class = "vtkBolePlantReport";
  type.title = "Write the seedling";
  type.help =
      "Writes what was measured of a seedling into the output folder: traits.csv and the other tables, plant.xlsx, "
      "trajectory.tum (camera to world), cloud.ply (the plant), scene.ply (all points with their parts), field.json "
      "(how well the field shows views that were held out), figures, and report.html. Inputs that are not connected "
      "are "
      "left out.";
  type.source = "SPEC C: citrus seedlings by RGB-D SLAM and a radiance field";
  type.inputs = {{"traits", DataKind::table, "Traits of the plant with their intervals.", true, {}},
                 {"points", DataKind::cloud, "Points with colours, and the part that each belongs to.", true, {}},
                 {"poses", DataKind::trajectory, "Poses of the views.", true, {}},
                 {"field", DataKind::table, "The field: its parameters, and its configuration as facts.", true, {}},
                 {"held_out", DataKind::table, "Views that were held out, with their PSNR.", true, {}},
                 {"progress", DataKind::table, "Loss and PSNR over the steps.", true, {}},
                 {"tracking", DataKind::table, "One row per view: whether it has a pose.", true, {}},
                 {"matches", DataKind::table, "Matches of features, kept and refused.", true, {}},
                 {"views",
                  DataKind::views,
                  "The views: two are shown with their matches, one with the stem in its depth.",
                  true,
                  {}},
                 {"stem", DataKind::table, "Sections of the stem.", true, {}},
                 {"leaves", DataKind::table, "Leaves.", true, {}},
                 {"internodes", DataKind::table, "Internodes.", true, {}},
                 {"branches", DataKind::table, "Branches with their angles.", true, {}},
                 {"contours", DataKind::table, "Contours of the stem in the pictures.", true, {}},
                 {"edits", DataKind::table, "What a person changed.", true, {}}};
  type.options = &option_table(static_cast<const PlantReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_plant_report(inputs, options.as<PlantReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
