// ground_errors [set=OPTION=VALUE ...] [data=FOLDER] [las=FILE ...] [run=FOLDER|cloud=FILE truth=FOLDER|zero ...]: the
// error table of the ground filter. Errors as Sithole and Vosselman (2004) count them: type I ground taken for object,
// type II object taken for ground, total all wrong points. Always: synthetic forest floors with rocks, fallen stems,
// shrubs and points below the ground, by slope. `data` holds als_ground and isprs_filter, tiles that others have
// classified; `las` is one such tile. All with the defaults of ground.model unless `set` gives others. `run` is an
// output folder of `bole run` (dem.tif) and `truth` that of `bole simulate`: DEM against DEM within 16 m of the centre
// along both axes. `cloud` stands for `run`: its terrain is modelled here, and what was told about it is printed;
// truth=zero for normalised clouds.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "base/verdict.h"
#include "bench/run_tool.h"
#include "ground/core/model_ground.h"
#include "io/core/gdal/gdal_writer.h"
#include "io/core/las/las_reader.h"
#include "synthetic/terrain.h"

namespace {

using namespace bole;
namespace fs = std::filesystem;

struct DemError {
  double n = 0, sum = 0, squares = 0;
  void add(double e) {
    if (std::isfinite(e)) n += 1, sum += e, squares += e * e;
  }
  std::string text() const {
    return n > 0 ? fmt::format("{:+.1f} / {:.1f}", 100 * sum / n, 100 * std::sqrt(squares / n)) : std::string();
  }
};

template <class Truth>
DemError dem_error(const Raster& dem, double half_m, Truth&& truth) {
  DemError e;
  for (int iy = 0; iy < dem.ny; ++iy)
    for (int ix = 0; ix < dem.nx; ++ix) {
      const double x = dem.origin.x() + (ix + 0.5) * dem.cell_m, y = dem.origin.y() + (iy + 0.5) * dem.cell_m;
      if (std::abs(x) <= half_m && std::abs(y) <= half_m) e.add(static_cast<double>(dem.at(ix, iy)) - truth(x, y));
    }
  return e;
}

// `reference`: 2 ground, 0 left out, else object.
void print_row(const std::string& name, const std::vector<std::uint8_t>& found, const std::vector<int>& reference,
               const std::string& dem) {
  double ground = 0, object = 0, lost = 0, wrong = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (reference[i] == 0) continue;
    if (reference[i] == 2)
      ++ground, lost += found[i] != 2;
    else
      ++object, wrong += found[i] == 2;
  }
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {} |\n", name, found.size(), 100 * lost / ground,
             100 * wrong / object, 100 * (lost + wrong) / (ground + object), dem);
}

void synthetic_rows(const ground::GroundOptions& options) {
  for (const double slope : {0.0, 20.0, 35.0}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      synthetic::TerrainRecipe r;
      r.slope_deg = slope, r.rocks = 8, r.fallen_stems = 3, r.shrubs = 15, r.stems = 30, r.low_outlier_share = 0.002,
      r.seed = seed;
      synthetic::Terrain terrain(r);
      std::vector<int> labels;
      const auto cloud = terrain.cloud(&labels);
      const auto m = ground::model_ground(cloud, options, Run{});
      print_row(fmt::format("synthetic, {:g} deg, seed {}", slope, seed), m.classification, labels,
                dem_error(m.dem, 9.5, [&](double x, double y) { return terrain.height(x, y); }).text());
    }
  }
}

void tile_row(const fs::path& file, ground::GroundOptions options) {
  if (!fs::exists(file)) {
    fmt::print("| {} | absent | | | | |\n", file.string());
    return;
  }
  options.method = ground::GroundMethod::tin;  // MixedConifer is normalised
  options.keep_classes = false;
  const auto cloud = io::read_las(file);
  const auto m = ground::model_ground(cloud, options, Run{});
  std::vector<int> reference;
  for (const auto c : cloud.values<std::uint8_t>(arrays::classification)) reference.push_back(c == 9 ? 0 : c);  // water
  print_row(file.stem().string(), m.classification, reference, "");
}

Raster modelled(const fs::path& file, const ground::GroundOptions& options) {
  auto m = ground::model_ground(io::read_las(file), options, Run{});
  fmt::print("{}: terrain from {}; {} {} low noise points.\n", file.stem().string(), choice_name(m.source),
             m.report.message, m.report.counts["low_noise_points"]);
  for (const auto& f : m.report.findings) fmt::print("  {} {}: {}\n", severity_name(f.severity), f.code, f.text);
  return std::move(m.dem);
}

void set_option(ground::GroundOptions& options, const std::string& assignment) {
  const auto split = assignment.find('=');
  const auto& spec = option_table(&options).at(assignment.substr(0, split));
  spec.assign(&options, spec.parsed(assignment.substr(std::min(assignment.size(), split + 1))));
}

int run(int argc, char** argv) {
  fmt::print(
      "| cloud | points | type I, % | type II, % | total, % | DEM bias / RMSE, cm |\n|---|---|---|---|---|---|\n");
  Raster dem;
  ground::GroundOptions options;
  for (int i = 1; i < argc; ++i)
    if (const std::string argument = argv[i]; argument.starts_with("set=")) set_option(options, argument.substr(4));
  synthetic_rows(options);
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('=')),
                      value = argument.substr(std::min(argument.size(), name.size() + 1));
    if (name == "data") {
      tile_row(fs::path(value) / "isprs_filter/samp31_ref.las", options);
      tile_row(fs::path(value) / "isprs_filter/samp51_ref.las", options);
      tile_row(fs::path(value) / "als_ground/Topography.laz", options);
      tile_row(fs::path(value) / "als_ground/MixedConifer.laz", options);
    } else if (name == "las") {
      tile_row(value, options);
    } else if (name == "run") {
      dem = io::read_geotiff(fs::path(value) / "dem.tif");
    } else if (name == "cloud") {
      dem = modelled(value, options);
    } else if (name == "truth" && value == "zero") {
      fmt::print("| z = 0 | | | | | {} |\n", dem_error(dem, 16, [](double, double) { return 0.0; }).text());
    } else if (name == "truth") {
      const auto truth = io::read_geotiff(fs::path(value) / "dem.tif");
      const auto e = dem_error(dem, 16, [&](double x, double y) { return truth.sample(x, y); });
      fmt::print("| {} | | | | | {} |\n", fs::path(value).lexically_normal().filename().string(), e.text());
    } else if (name != "set") {
      throw bad_input("argument '" + argument + "'", "data=FOLDER, or run=FOLDER truth=FOLDER");
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
