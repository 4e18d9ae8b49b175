#include "io/tile_stages.h"

#include <fmt/format.h>

#include "io/core/clouds/cloud_bounds.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/tables/table_file.h"
#include "io/core/tiles/cut_cloud.h"
#include "pipeline/result_names.h"

namespace bole::io {
namespace {

struct ReadRasterOptions {
  std::string file, bounds;
};

pipeline::StageType cut_stage() {
  pipeline::StageType type;
  type.name = "io.cut_cloud";
  type.vtk_class = "vtkBoleCutCloud";
  type.title = "Cut a cloud into tiles";
  type.help =
      "Cuts a cloud of any size into overlapping files, one for each tile, and writes them with a list, tiles.csv, "
      "into "
      "the output folder. Points keep all their fields and their order. Each file says where the whole cloud begins "
      "and "
      "how dense it is, so that terrain and stems of a tile are searched in the same cells as in the whole.";
  type.source = "Bole";
  type.outputs = {{"tiles", DataKind::table, "A row per tile: name, file, core, number of points.", false, {}}};
  type.options = &option_table(static_cast<const CutOptions*>(nullptr));
  type.writes_files = true;
  type.run = [](const DataSet&, const OptionSet& options, const Run& run) {
    if (run.output_dir.empty())
      throw bad_input("there is no folder to write the tiles into", "an output folder", "Give --out DIR");
    auto cut = cut_cloud(options.as<CutOptions>(), run.output_dir / "tiles", run);
    write_table(run.output_dir / "tiles.csv", cut.tiles);
    pipeline::StageResult result;
    result.outputs.set("tiles", std::move(cut.tiles));
    result.report = std::move(cut.report);
    return result;
  };
  return type;
}

// The plan of the bounds, those in height left aside.
std::optional<Eigen::AlignedBox2d> window_in(const std::string& text) {
  const auto bounds = parse_bounds(text);
  if (!bounds) return std::nullopt;
  return Eigen::AlignedBox2d(Eigen::Vector2d(bounds->min.head<2>()), Eigen::Vector2d(bounds->max.head<2>()));
}

pipeline::StageType read_raster_stage() {
  using S = ReadRasterOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"file",
                             &S::file,
                             TextKind::input_path,
                             {},
                             Tier::basic,
                             "Raster to read: GeoTIFF with square cells, or a GDAL VRT of several (.vrt)."},
      Option<S, std::string>{"bounds",
                             &S::bounds,
                             TextKind::plain,
                             {},
                             Tier::advanced,
                             "Part to read: xmin,ymin,xmax,ymax in the coordinates of the file. Empty: all."},
  });
  pipeline::StageType type;
  type.name = "io.read_raster";
  type.vtk_class = "vtkBoleReadRaster";
  type.title = "Read a raster";
  type.help =
      "Reads a raster, for instance a terrain model that was made before. Cells without a value are missing values.";
  type.source = "GDAL";
  type.outputs = {{"raster", DataKind::raster, "The cells of the file.", false, {}}};
  type.options = &table;
  type.run = [](const DataSet&, const OptionSet& options, const Run&) {
    const auto& o = options.as<S>();
    pipeline::StageResult result;
    auto raster = read_geotiff(o.file, window_in(o.bounds));
    result.report.counts["columns"] = raster.nx;
    result.report.counts["rows"] = raster.ny;
    result.report.message = fmt::format("{} x {} cells of {:g} m", raster.nx, raster.ny, raster.cell_m);
    result.outputs.set("raster", std::move(raster));
    return result;
  };
  return type;
}

}  // namespace

void register_tiles(pipeline::StageRegistry& registry) {
  pipeline::add_result_names({"tiles", "tiles.csv"});
  registry.add(cut_stage());
  registry.add(read_raster_stage());
}

}  // namespace bole::io
