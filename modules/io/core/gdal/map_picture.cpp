#include "io/core/gdal/map_picture.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include "base/error.h"
#include "io/core/gdal/gdal_support.h"
#include "io/core/gdal/map_colors.h"
#include "io/core/gdal/map_place.h"

namespace bole::io {
namespace {

constexpr int bands = 4;
constexpr double spare_px = 2;  // around a part that is warped: its border is made of neighbours too

// Drivers that fetch what a file names from elsewhere, or open any other file. Only what calls itself a VRT is one.
bool may_read(const std::string& driver, const std::filesystem::path& path) {
  static const char* const elsewhere[] = {"WMS",  "WCS",   "WMTS",   "HTTP",   "PLMOSAIC", "NGW",          "DAAS",
                                          "EEDA", "EEDAI", "OGCAPI", "STACTA", "STACIT",   "PostGISRaster"};
  if (driver == "VRT" || driver == "DERIVED") return driver == "VRT" && path.extension() == ".vrt";
  return std::ranges::find(elsewhere, driver) == std::end(elsewhere);
}

gdal::Dataset open_picture(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) throw bad_input(fmt::format("'{}' is not there", path.string()), "a picture");
  gdal::driver("GTiff");
  std::vector<std::string> names;
  auto& manager = *GetGDALDriverManager();
  for (int i = 0; i < manager.GetDriverCount(); ++i) {
    auto* driver = manager.GetDriver(i);
    if (driver->GetMetadataItem(GDAL_DCAP_RASTER) != nullptr && may_read(driver->GetDescription(), path))
      names.emplace_back(driver->GetDescription());
  }
  std::vector<const char*> drivers;
  for (const auto& name : names) drivers.push_back(name.c_str());
  drivers.push_back(nullptr);
  const gdal::Errors errors;
  gdal::Dataset set(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data(), nullptr, nullptr)));
  if (set == nullptr || set->GetRasterCount() < 1)
    throw bad_input(fmt::format("'{}' cannot be read: {}", path.string(), errors.last()),
                    "a picture that GDAL reads: GeoTIFF, PNG, JPEG, ...");
  return set;
}

std::string distance_text(double metres) {
  return metres < 1000 ? fmt::format("{:.0f} m", metres) : fmt::format("{:.1f} km", metres / 1000);
}

// `asked`: the pixels that the survey would lie on.
Error elsewhere(const MapPlace& place, const Eigen::AlignedBox2d& all, const Eigen::AlignedBox2d& asked,
                const MapWanted& wanted, const std::string& name) {
  std::optional<Eigen::Vector2d> nearest;
  if (!asked.isEmpty())
    nearest = place.to_wanted(asked.center().cwiseMax(all.min()).cwiseMin(all.max()));
  else
    nearest = place.to_wanted(all.center());
  const std::string needed = "a picture of the place of the survey",
                    to_do = "Check the coordinate systems of the picture and of the survey";
  if (!nearest) return bad_input(fmt::format("'{}' shows another part of the earth", name), needed, to_do);
  return bad_input(fmt::format("'{}' does not show the survey: it is {} away", name,
                               distance_text(wanted.survey.exteriorDistance(*nearest))),
                   needed, to_do);
}

struct Cut {
  MapPart part;
  GeoTransform transform{};     // of the pixels that are read
  Eigen::AlignedBox2d covered;  // of what was asked for, in the wanted system
};

Cut cut_of(GDALDataset& set, const MapPlace& place, const MapWanted& wanted, const std::string& name) {
  const Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0), Eigen::Vector2d(set.GetRasterXSize(), set.GetRasterYSize()));
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(wanted.margin_m);
  const Eigen::AlignedBox2d window(wanted.survey.min() - margin, wanted.survey.max() + margin);
  const auto asked = place.pixels_of(window);
  auto pixels = asked.isEmpty() ? asked : asked.intersection(all);
  if (pixels.isEmpty() || !(pixels.volume() > 0)) throw elsewhere(place, all, asked, wanted, name);
  Cut cut;
  cut.covered = place.wanted_of(pixels).intersection(window);
  if (cut.covered.isEmpty()) throw elsewhere(place, all, asked, wanted, name);
  const double spare = place.north_up() ? 0 : spare_px;
  const auto floor_of = [](double v) { return static_cast<int>(std::floor(v)); };
  auto& part = cut.part;
  part.column = std::max(0, floor_of(pixels.min().x() - spare));
  part.row = std::max(0, floor_of(pixels.min().y() - spare));
  part.columns = std::min(set.GetRasterXSize(), floor_of(pixels.max().x() + spare) + 1) - part.column;
  part.rows = std::min(set.GetRasterYSize(), floor_of(pixels.max().y() + spare) + 1) - part.row;
  const double thinned = std::max(1.0, static_cast<double>(std::max(part.columns, part.rows)) / wanted.max_side_px);
  part.width = std::max(1, static_cast<int>(std::ceil(part.columns / thinned - 1e-9)));
  part.height = std::max(1, static_cast<int>(std::ceil(part.rows / thinned - 1e-9)));
  cut.transform = part_of(
      place.transform(), Eigen::Vector2d(part.column, part.row),
      Eigen::Vector2d(static_cast<double>(part.columns) / part.width, static_cast<double>(part.rows) / part.height));
  return cut;
}

// Of the file, in the middle of the part: the shorter side of a pixel in the wanted system.
double pixel_m(const MapPlace& place, const MapPart& part) {
  const Eigen::Vector2d middle(part.column + part.columns / 2.0, part.row + part.rows / 2.0);
  double shortest = 0;
  const auto at = place.to_wanted(middle);
  for (const Eigen::Vector2d& step : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)})
    if (const auto beside = place.to_wanted(middle + step); at && beside) {
      const double length = (*beside - *at).norm();
      if (shortest == 0 || length < shortest) shortest = length;
    }
  return shortest;
}

gdal::Dataset in_memory(int width, int height, const GeoTransform& transform, const OGRSpatialReference* crs) {
  gdal::Dataset set(gdal::driver("MEM").Create("", width, height, bands, GDT_Byte, nullptr));
  if (set == nullptr) throw failure("there is no memory for the map", "a smaller picture");
  auto t = transform;
  set->SetGeoTransform(t.data());
  if (crs != nullptr) set->SetSpatialRef(crs);
  for (int band = 1; band < bands; ++band)
    set->GetRasterBand(band)->SetColorInterpretation(static_cast<GDALColorInterp>(GCI_RedBand + band - 1));
  set->GetRasterBand(bands)->SetColorInterpretation(GCI_AlphaBand);
  return set;
}

bool move_pixels(GDALDataset& set, GDALRWFlag way, int width, int height, std::vector<std::uint8_t>& rgba) {
  return set.RasterIO(way, 0, 0, width, height, rgba.data(), width, height, GDT_Byte, bands, nullptr, bands,
                      static_cast<GSpacing>(bands) * width, 1, nullptr) == CE_None;
}

void warp(MapPicture& map, const Cut& cut, const MapPlace& place, std::vector<std::uint8_t> rgba, int max_side_px) {
  const auto from = in_memory(cut.part.width, cut.part.height, cut.transform, place.own_crs());
  const Eigen::Vector2d size = cut.covered.sizes();
  const double thinned = static_cast<double>(cut.part.columns) / cut.part.width;
  const double step = std::max(map.file_pixel_m * thinned, size.maxCoeff() / max_side_px);
  const auto pixels = [&](double metres) {
    return std::clamp(static_cast<int>(std::ceil(metres / step - 1e-6)), 1, max_side_px);
  };
  map.width = pixels(size.x());
  map.height = pixels(size.y());
  map.pixel_m = {step, step};
  map.north_west = {cut.covered.min().x(), cut.covered.max().y()};
  const auto to =
      in_memory(map.width, map.height, {map.north_west.x(), step, 0, map.north_west.y(), 0, -step}, place.wanted_crs());
  const gdal::Errors errors;
  char resampling[] = "-r", bilinear[] = "bilinear";
  char* words[] = {resampling, bilinear, nullptr};
  std::unique_ptr<GDALWarpAppOptions, void (*)(GDALWarpAppOptions*)> options(GDALWarpAppOptionsNew(words, nullptr),
                                                                             GDALWarpAppOptionsFree);
  auto* source = GDALDataset::ToHandle(from.get());
  int misused = FALSE;
  const bool ok = move_pixels(*from, GF_Write, cut.part.width, cut.part.height, rgba) &&
                  GDALWarp(nullptr, GDALDataset::ToHandle(to.get()), 1, &source, options.get(), &misused) != nullptr &&
                  misused == FALSE;
  map.rgba.resize(static_cast<std::size_t>(bands) * static_cast<std::size_t>(map.width) *
                  static_cast<std::size_t>(map.height));
  if (!ok || !move_pixels(*to, GF_Read, map.width, map.height, map.rgba))
    throw failure("the map could not be warped: " + errors.last());
}

}  // namespace

MapPicture read_map_picture(const std::filesystem::path& path, const MapWanted& wanted, const Run& run) {
  const auto set = open_picture(path);
  const MapPlace place(*set, wanted.crs, path.string());
  const auto cut = cut_of(*set, place, wanted, path.string());
  MapPicture map;
  map.crs_known = place.crs_known();
  map.file_pixel_m = pixel_m(place, cut.part);
  auto rgba = map_colors(*set, cut.part, path.string(), run);
  run.check_cancel();
  if (!place.north_up()) {
    warp(map, cut, place, std::move(rgba), wanted.max_side_px);
    return map;
  }
  map.width = cut.part.width;
  map.height = cut.part.height;
  map.north_west = {cut.transform[0], cut.transform[3]};
  map.pixel_m = {cut.transform[1], -cut.transform[5]};
  map.rgba = std::move(rgba);
  return map;
}

}  // namespace bole::io
