#include "io/core/las/crs_geokeys.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <atomic>
#include <cmath>
#include <vector>

namespace bole::io::las {

namespace {

enum TiffType : std::uint16_t { tiff_ascii = 2, tiff_short = 3, tiff_long = 4, tiff_double = 12 };

// A TIFF image of one pixel with the keys, because GDAL reads keys only from a GeoTIFF.
class OnePixelTiff {
 public:
  OnePixelTiff() {
    for (const auto& [id, value] :
         {std::pair{256, 1}, {257, 1}, {258, 8}, {259, 1}, {262, 1}, {273, 8}, {277, 1}, {278, 1}, {279, 1}}) {
      Tag tag{static_cast<std::uint16_t>(id), tiff_short, 1, std::vector<std::uint8_t>(4)};
      store(tag.data.data(), static_cast<std::uint16_t>(value));
      tags_.push_back(std::move(tag));
    }
    // Without a pixel size and a tie point GDAL may not look for a CRS.
    const double pixel[3] = {1, 1, 0}, tie[6] = {};
    add(33550, tiff_double, {reinterpret_cast<const std::uint8_t*>(pixel), sizeof pixel}, 8);
    add(33922, tiff_double, {reinterpret_cast<const std::uint8_t*>(tie), sizeof tie}, 8);
  }

  void add(std::uint16_t id, TiffType type, Bytes data, std::size_t element) {
    const std::size_t count = data.size() / element;
    if (count > 0)
      tags_.push_back({id,
                       type,
                       static_cast<std::uint32_t>(count),
                       {data.begin(), data.begin() + static_cast<std::ptrdiff_t>(count * element)}});
  }

  std::vector<std::uint8_t> bytes() const {
    constexpr std::size_t pixel_at = 8, directory_at = 16;
    std::vector<std::uint8_t> out(directory_at + 2 + 12 * tags_.size() + 4);
    std::memcpy(out.data(), "II*\0", 4);
    store(out.data() + 4, static_cast<std::uint32_t>(directory_at));
    out[pixel_at] = 0;
    store(out.data() + directory_at, static_cast<std::uint16_t>(tags_.size()));
    for (std::size_t i = 0; i < tags_.size(); ++i) {
      const Tag& tag = tags_[i];
      const std::size_t at = directory_at + 2 + 12 * i;
      store(out.data() + at, tag.id);
      store(out.data() + at + 2, tag.type);
      store(out.data() + at + 4, tag.count);
      if (tag.data.size() <= 4) {
        std::memcpy(out.data() + at + 8, tag.data.data(), tag.data.size());
      } else {
        if (out.size() % 2 != 0) out.push_back(0);
        store(out.data() + at + 8, static_cast<std::uint32_t>(out.size()));
        out.insert(out.end(), tag.data.begin(), tag.data.end());
      }
    }
    return out;
  }

 private:
  struct Tag {
    std::uint16_t id, type;
    std::uint32_t count;
    std::vector<std::uint8_t> data;
  };
  std::vector<Tag> tags_;  // TIFF requires ascending ids
};

void quiet(CPLErr, CPLErrorNum, const char*) {}

}  // namespace

std::string wkt_from_geokeys(Bytes directory, Bytes doubles, Bytes ascii) {
  constexpr std::size_t max_bytes = 65535;
  if (directory.size() < 8 || directory.size() > max_bytes || doubles.size() > max_bytes || ascii.size() > max_bytes)
    return {};
  GDALRegister_GTiff();
  OnePixelTiff tiff;
  tiff.add(34735, tiff_short, directory, 2);
  tiff.add(34736, tiff_double, doubles, 8);
  tiff.add(34737, tiff_ascii, ascii, 1);
  std::vector<std::uint8_t> bytes = tiff.bytes();
  static std::atomic<unsigned> serial{0};
  const std::string name = "/vsimem/bole_geokeys_" + std::to_string(serial++) + ".tif";
  VSIFCloseL(VSIFileFromMemBuffer(name.c_str(), bytes.data(), bytes.size(), FALSE));
  std::string wkt;
  CPLPushErrorHandler(quiet);
  const char* const drivers[] = {"GTiff", nullptr};
  if (auto* set = static_cast<GDALDataset*>(
          GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr))) {
    if (const char* text = set->GetProjectionRef()) wkt = text;
    GDALClose(set);
  }
  CPLPopErrorHandler();
  VSIUnlink(name.c_str());
  return wkt;
}

std::string unit_warning(const std::string& wkt) {
  OGRSpatialReference crs;
  CPLPushErrorHandler(quiet);
  const bool known = !wkt.empty() && crs.importFromWkt(wkt.c_str()) == OGRERR_NONE;
  const char* name = nullptr;
  const double metres = known ? crs.GetLinearUnits(&name) : 1;
  const bool degrees = known && crs.IsGeographic() != 0;
  CPLPopErrorHandler();
  if (degrees) return "the coordinates are longitude and latitude, not metres: project the cloud first";
  if (std::abs(metres - 1) < 1e-9) return {};
  return fmt::format("the coordinates are in {} ({} m), not in metres",
                     name == nullptr ? "a unit without a name" : name, metres);
}

int epsg_of_wkt(const std::string& wkt) {
  if (wkt.empty()) return 0;
  OGRSpatialReference crs;
  CPLPushErrorHandler(quiet);
  const bool read = crs.importFromWkt(wkt.c_str()) == OGRERR_NONE;
  if (read && crs.GetAuthorityCode(nullptr) == nullptr) crs.AutoIdentifyEPSG();
  CPLPopErrorHandler();
  if (!read) return 0;
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  return authority != nullptr && code != nullptr && std::string_view(authority) == "EPSG" ? std::atoi(code) : 0;
}

}  // namespace bole::io::las
