// ground_errors [data=FOLDER] [run=FOLDER truth=FOLDER ...]: the error table of the ground filter. Errors as Sithole
// and Vosselman (2004) count them: type I ground taken for object, type II object taken for ground, total all wrong
// points. Always: synthetic forest floors with rocks, fallen stems, shrubs and points below the ground, by slope.
// `data` holds als_ground and isprs_filter, tiles that others have classified. `run` is an output folder of `bole run`
// (dem.tif) and `truth` that of `bole simulate`: DEM against DEM within 16 m of the centre along both axes.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

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

void synthetic_rows() {
  for (const double slope : {0.0, 20.0, 35.0}) {
    for (const unsigned seed : {1U, 2U, 3U}) {
      synthetic::TerrainRecipe r;
      r.slope_deg = slope, r.rocks = 8, r.fallen_stems = 3, r.shrubs = 15, r.stems = 30, r.low_outlier_share = 0.002,
      r.seed = seed;
      synthetic::Terrain terrain(r);
      std::vector<int> labels;
      const auto cloud = terrain.cloud(&labels);
      const auto m = ground::model_ground(cloud, {}, Run{});
      print_row(fmt::format("synthetic, {:g} deg, seed {}", slope, seed), m.classification, labels,
                dem_error(m.dem, 9.5, [&](double x, double y) { return terrain.height(x, y); }).text());
    }
  }
}

void tile_row(const fs::path& file, double seed_m) {
  if (!fs::exists(file)) {
    fmt::print("| {} | absent | | | | |\n", file.string());
    return;
  }
  ground::GroundOptions o;
  o.cell = 1, o.seed = seed_m, o.max_distance = 1.4, o.max_angle_deg = 10, o.roughness = 0.2, o.band = 0.5,
  o.tolerance = 0.4, o.fill_distance = 40, o.keep_classes = false;
  const auto cloud = io::read_las(file);
  const auto m = ground::model_ground(cloud, o, Run{});
  std::vector<int> reference;
  for (const auto c : cloud.values<std::uint8_t>(arrays::classification)) reference.push_back(c == 9 ? 0 : c);  // water
  print_row(file.stem().string(), m.classification, reference, "");
}

int run(int argc, char** argv) {
  fmt::print(
      "| cloud | points | type I, % | type II, % | total, % | DEM bias / RMSE, cm |\n|---|---|---|---|---|---|\n");
  synthetic_rows();
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i], name = argument.substr(0, argument.find('=')),
                      value = argument.substr(std::min(argument.size(), name.size() + 1));
    if (name == "data") {
      tile_row(fs::path(value) / "isprs_filter/samp31_ref.las", 24);
      tile_row(fs::path(value) / "isprs_filter/samp51_ref.las", 24);
      tile_row(fs::path(value) / "als_ground/Topography.laz", 10);
      tile_row(fs::path(value) / "als_ground/MixedConifer.laz", 10);
    } else if (name == "run") {
      folder = value;
    } else if (name == "truth") {
      const auto truth = io::read_geotiff(fs::path(value) / "dem.tif");
      const auto e = dem_error(io::read_geotiff(fs::path(folder) / "dem.tif"), 16,
                               [&](double x, double y) { return truth.sample(x, y); });
      fmt::print("| {} | | | | | {} |\n", fs::path(value).lexically_normal().filename().string(), e.text());
    } else {
      throw bad_input("argument '" + argument + "'", "data=FOLDER, or run=FOLDER truth=FOLDER");
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return bole::run_tool(run, argc, argv); }
