#include <cpl_error.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "base/error.h"
#include "io/core/gdal/gdal_support.h"
#include "io/core/gdal/gdal_writer.h"

namespace bole::io {

namespace {

void require_raster(bool ok, const gdal::Errors& errors, const std::filesystem::path& path, const char* what) {
  if (!ok) throw failure(fmt::format("'{}': {} failed: {}", path.string(), what, errors.last()));
}

void fill(GDALDataset& set, const Raster& raster, const gdal::Errors& errors, const std::filesystem::path& path) {
  double transform[6] = {raster.origin.x(), raster.cell_m, 0, raster.origin.y() + raster.ny * raster.cell_m, 0,
                         -raster.cell_m};
  require_raster(set.SetGeoTransform(transform) == CE_None, errors, path, "placing the raster");
  if (!raster.crs_wkt.empty()) {
    OGRSpatialReference crs;
    if (crs.importFromWkt(raster.crs_wkt.c_str()) != OGRERR_NONE)
      throw bad_input("the raster's coordinate reference system is not WKT that PROJ knows", "WKT 1 or 2");
    require_raster(set.SetSpatialRef(&crs) == CE_None, errors, path, "setting the coordinate reference system");
  }
  GDALRasterBand& band = *set.GetRasterBand(1);
  band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  band.SetDescription(raster.quantity.c_str());
  // Rows run north in memory and south in the file.
  std::vector<float> row(static_cast<std::size_t>(raster.nx));
  for (int iy = 0; iy < raster.ny; ++iy) {
    std::copy_n(raster.values.begin() + static_cast<std::ptrdiff_t>(raster.ny - 1 - iy) * raster.nx, raster.nx,
                row.begin());
    require_raster(band.RasterIO(GF_Write, 0, iy, raster.nx, 1, row.data(), raster.nx, 1, GDT_Float32, 0, 0) == CE_None,
                   errors, path, "writing a row");
  }
}

// Of the file: rows run south.
struct CellWindow {
  int column = 0, row = 0, nx = 0, ny = 0;
};

CellWindow window_of(GDALDataset& set, const double (&t)[6], const std::optional<Eigen::AlignedBox2d>& window) {
  const int nx = set.GetRasterXSize(), ny = set.GetRasterYSize();
  if (!window) return {0, 0, nx, ny};
  const auto cell = [](double at, double begin, double step, int n) {
    return static_cast<int>(std::clamp(std::floor((at - begin) / step), -1.0, static_cast<double>(n)));
  };
  const int first_column = std::max(0, cell(window->min().x(), t[0], t[1], nx)),
            last_column = std::min(nx - 1, cell(window->max().x(), t[0], t[1], nx)),
            first_row = std::max(0, cell(window->max().y(), t[3], t[5], ny)),
            last_row = std::min(ny - 1, cell(window->min().y(), t[3], t[5], ny));
  return {first_column, first_row, last_column - first_column + 1, last_row - first_row + 1};
}

}  // namespace

void write_geotiff(const std::filesystem::path& path, const Raster& raster) {
  if (raster.nx <= 0 || raster.ny <= 0 ||
      raster.values.size() != static_cast<std::size_t>(raster.nx) * static_cast<std::size_t>(raster.ny))
    throw bad_input(fmt::format("a raster of {} x {} cells with {} values", raster.nx, raster.ny, raster.values.size()),
                    "one value per cell and at least one cell");
  GDALDriver& driver = gdal::driver("GTiff");
  const gdal::Errors errors;
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER", nullptr};
    gdal::Dataset set(
        driver.Create(temporary.c_str(), raster.nx, raster.ny, 1, GDT_Float32, const_cast<char**>(options)));
    require_raster(set != nullptr, errors, path, "creating the file");
    fill(*set, raster, errors, path);
    // Only closing the file writes its last part and shows that the disk is full.
    CPLErrorReset();
    set.reset();
    require_raster(CPLGetLastErrorType() < CE_Failure, errors, path, "writing the file");
  });
}

Raster read_geotiff(const std::filesystem::path& path, const std::optional<Eigen::AlignedBox2d>& window) {
  gdal::driver("GTiff");
  const gdal::Errors errors;
  // Only what calls itself so may name other files.
  const char* const drivers[] = {path.extension() == ".vrt" ? "VRT" : "GTiff", nullptr};
  const gdal::Dataset set(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr)));
  if (set == nullptr || set->GetRasterCount() < 1)
    throw bad_input(fmt::format("'{}' cannot be read: {}", path.string(), errors.last()), "a GeoTIFF with a band");
  double t[6];
  if (set->GetGeoTransform(t) != CE_None)
    throw bad_input(fmt::format("'{}' has no georeference", path.string()), "a georeferenced GeoTIFF");
  if (t[2] != 0 || t[4] != 0 || !(t[1] > 0) || t[5] >= 0 || std::abs(t[1] + t[5]) > 1e-6 * t[1])
    throw bad_input(fmt::format("'{}' has cells of {} x {} m or is rotated", path.string(), t[1], -t[5]),
                    "square cells, north up");
  const CellWindow cells_read = window_of(*set, t, window);
  if (cells_read.nx <= 0 || cells_read.ny <= 0)
    throw bad_input(fmt::format("no cell of '{}' lies within the bounds", path.string()), "bounds that meet it");
  // A sparse file of a few bytes can declare any number of cells.
  constexpr std::int64_t max_cells = 400'000'000;
  if (const std::int64_t cells = std::int64_t{cells_read.nx} * cells_read.ny; cells > max_cells)
    throw bad_input(fmt::format("'{}' has {} x {} cells", path.string(), cells_read.nx, cells_read.ny),
                    fmt::format("at most {} million cells", max_cells / 1'000'000), "Cut it to the plot, or thin it");
  Raster raster;
  raster.nx = cells_read.nx;
  raster.ny = cells_read.ny;
  raster.cell_m = t[1];
  raster.origin = {t[0] + cells_read.column * t[1], t[3] + (cells_read.row + raster.ny) * t[5]};
  if (const auto* crs = set->GetSpatialRef(); crs != nullptr) {
    char* wkt = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2018", nullptr};
    if (crs->exportToWkt(&wkt, options) == OGRERR_NONE) raster.crs_wkt = wkt;
    CPLFree(wkt);
    raster.axes = Axes::global;
  }
  GDALRasterBand& band = *set->GetRasterBand(1);
  if (const std::string description = band.GetDescription(); !description.empty()) raster.quantity = description;
  // Row by row, so that a file that is cut off fails at its first missing row.
  std::vector<float> row(static_cast<std::size_t>(raster.nx));
  int has_no_data = FALSE;
  const auto no_data = static_cast<float>(band.GetNoDataValue(&has_no_data));
  for (int iy = raster.ny - 1; iy >= 0; --iy) {
    if (band.RasterIO(GF_Read, cells_read.column, cells_read.row + iy, raster.nx, 1, row.data(), raster.nx, 1,
                      GDT_Float32, 0, 0) != CE_None)
      throw bad_input(fmt::format("'{}': row {} cannot be read: {}", path.string(), iy, errors.last()), "a whole file");
    if (has_no_data != FALSE) std::ranges::replace(row, no_data, std::numeric_limits<float>::quiet_NaN());
    raster.values.insert(raster.values.end(), row.begin(), row.end());
  }
  return raster;
}

}  // namespace bole::io
