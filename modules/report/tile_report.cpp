#include "report/tile_report.h"

#include <fmt/format.h>

#include <cmath>

#include "cloud/core/regions/point_edits.h"
#include "cloud/known_facts.h"
#include "io/core/clouds/cloud_bounds.h"
#include "io/core/clouds/cloud_writer.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_decimals.h"
#include "io/core/tables/table_file.h"
#include "report/report_writer.h"

namespace bole::report {

const OptionTable& option_table(const TileReportOptions*) {
  using S = TileReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"core",
                             &S::core,
                             TextKind::plain,
                             {},
                             Tier::basic,
                             "Core of the tile: xmin,ymin,xmax,ymax. Terrain and points outside of it are left to the "
                             "tiles beside. Empty: everything."},
      Option<S, bool>{"cloud", &S::cloud, Tier::basic, "Write the points with all their columns: cloud.laz."},
  });
  return table;
}

namespace {

bool holds(const io::CloudBounds& core, const Eigen::Vector3d& p) {
  return p.x() >= core.min.x() && p.y() >= core.min.y() && p.x() < core.max.x() && p.y() < core.max.y();
}

PointCloud points_in(const PointCloud& points, const io::CloudBounds& core, const Run& run) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (holds(core, exact_position(points, i))) kept.push_back(static_cast<std::uint32_t>(i));
  }
  return points.subset(kept);
}

// The cells whose centre lies in the core; none where the raster lies beside it.
Raster cells_in(const Raster& raster, const io::CloudBounds& core) {
  const auto range = [&](double low, double high, double origin, int n) {
    const auto edge = [&](double v) {
      return static_cast<int>(std::clamp(std::ceil((v - origin) / raster.cell_m - 0.5), 0.0, static_cast<double>(n)));
    };
    return std::pair(edge(low), edge(high));
  };
  const auto [x0, x1] = range(core.min.x(), core.max.x(), raster.origin.x(), raster.nx);
  const auto [y0, y1] = range(core.min.y(), core.max.y(), raster.origin.y(), raster.ny);
  Raster out = raster;
  out.origin += raster.cell_m * Eigen::Vector2d(x0, y0);
  out.nx = std::max(0, x1 - x0);
  out.ny = std::max(0, y1 - y0);
  out.values.clear();
  for (int iy = y0; iy < y1; ++iy)
    for (int ix = x0; ix < x1; ++ix) out.values.push_back(raster.at(ix, iy));
  return out;
}

// For those who join tiles: exact, which a file in another format may not be.
void tell_raster(const Raster& raster, Report& report) {
  report.facts["dem"] = fmt::format("{:.17g} {:.17g} {:.17g} {} {}", raster.origin.x(), raster.origin.y(),
                                    raster.cell_m, raster.nx, raster.ny);
}

void write_stem_layer(const std::filesystem::path& path, const Table& stems, const DataSet& inputs) {
  std::string crs;
  if (inputs.has("points")) crs = inputs.cloud("points").crs_wkt;
  io::write_geopackage(path, {io::point_layer("stems", stems, crs)});
}

// What is selected in the core, so that the tiles add up, and what became of it in this one.
void write_edits(const DataSet& inputs, const io::CloudBounds& core, const Run& run, ReportWriter& writer) {
  const auto edits = inputs.has("point_edits") ? point_edits_in(inputs.table("point_edits")) : std::vector<PointEdit>();
  if (edits.empty()) return;
  auto table = point_edit_table(edits, points_in(inputs.cloud("points"), core, run), run);
  const auto& given = inputs.table("given");
  table.set("lacks", given.texts("lacks"));
  for (const char* name : {"tree_id", "given"}) table.set(name, given.integers(name));
  writer.write("point_edits.csv", [&](const auto& path) { io::write_table(path, table, io::table_decimals()); });
}

}  // namespace

pipeline::StageResult write_tile_report(const DataSet& inputs, const TileReportOptions& o, const Run& run) {
  ReportWriter writer(run);
  const auto core = io::parse_bounds(o.core).value_or(io::CloudBounds());
  for (const auto* name : {"stems", "sections", "rejected"})
    if (inputs.has(name))
      writer.write(fmt::format("{}.csv", name),
                   [&](const auto& path) { io::write_table(path, inputs.table(name), io::table_decimals()); });
  // These two are added up: with every digit.
  for (const auto* name : {"evidence", "priors"})
    if (inputs.has(name))
      writer.write(fmt::format("{}.csv", name), [&](const auto& path) { io::write_table(path, inputs.table(name)); });
  if (inputs.has("given")) write_edits(inputs, core, run, writer);
  if (inputs.has("stems") && inputs.table("stems").rows() > 0)
    writer.write("plot.gpkg", [&](const auto& path) { write_stem_layer(path, inputs.table("stems"), inputs); });
  if (inputs.has("dem")) {
    const auto cells = cells_in(inputs.raster("dem"), core);
    if (cells.nx > 0 && cells.ny > 0) {
      writer.write("dem.tif", [&](const auto& path) { io::write_geotiff(path, cells); });
      tell_raster(cells, writer.report());
    }
  }
  if (o.cloud && inputs.has("points")) {
    const auto points = points_in(inputs.cloud("points"), core, run);
    writer.report().counts["points"] = static_cast<std::int64_t>(points.size());
    writer.write("cloud.laz", [&](const auto& path) { io::write_cloud(path, points, run, &writer.report()); });
  }
  return writer.finish();
}

pipeline::StageType tile_report_stage() {
  pipeline::StageType type;
  type.name = "report.tile";
  type.vtk_class = "vtkBoleTileReport";
  type.title = "Write a tile";
  type.help =
      "Writes the results of one tile of a cloud as files that fit those of the tiles beside it: tables of all stems "
      "that were measured, also in the buffer, terrain and points of the core alone.";
  type.source = "Bole";
  type.inputs = {{"stems", DataKind::table, "Stems of the tile and its buffer.", true, {}},
                 {"sections", DataKind::table, "Circles along the stems.", true, {}},
                 {"rejected", DataKind::table, "Candidates that are no stems.", true, {}},
                 {"evidence", DataKind::table, "Evidence of the stems, to be pooled.", true, {}},
                 {"priors", DataKind::table, "Pooled priors.", true, {}},
                 {"point_edits", DataKind::table, "Points that a person gave, from survey.edit_points.", true, {}},
                 {"given", DataKind::table, "What became of them, from stems.measure.", true, {}},
                 {"dem", DataKind::raster, "Terrain model.", true, {}},
                 {"points", DataKind::cloud, "Points of the tile.", true, {}}};
  type.options = &option_table(static_cast<const TileReportOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet& inputs, const OptionSet& options, const Run& run) {
    return write_tile_report(inputs, options.as<TileReportOptions>(), run);
  };
  return type;
}

}  // namespace bole::report
