#include <gdal_priv.h>

#include <memory>

#include "base/error.h"
#include "sim/core/plot/truth.h"

namespace bole::sim {

void write_dem(const Raster& dem, const std::filesystem::path& file) {
  GDALAllRegister();
  auto* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (!driver) throw failure("GDAL has no GeoTIFF driver", {}, "Check the installation of GDAL");
  const auto close = [](GDALDataset* d) { GDALClose(d); };
  const std::unique_ptr<GDALDataset, decltype(close)> out(
      driver->Create(file.c_str(), dem.nx, dem.ny, 1, GDT_Float32, nullptr), close);
  if (!out) throw failure("cannot write " + file.string(), "a writable folder");
  double geo[6] = {dem.origin.x(), dem.cell_m, 0, dem.origin.y() + dem.ny * dem.cell_m, 0, -dem.cell_m};
  out->SetGeoTransform(geo);
  auto* band = out->GetRasterBand(1);
  for (int iy = 0; iy < dem.ny; ++iy) {
    auto* row = const_cast<float*>(dem.values.data()) + static_cast<std::ptrdiff_t>(iy) * dem.nx;
    // Rows of a raster file run from north to south.
    if (band->RasterIO(GF_Write, 0, dem.ny - 1 - iy, dem.nx, 1, row, dem.nx, 1, GDT_Float32, 0, 0) != CE_None)
      throw failure("cannot write " + file.string(), "free space on the disk");
  }
}

}  // namespace bole::sim
