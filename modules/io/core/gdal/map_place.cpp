#include "io/core/gdal/map_place.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>

#include "base/error.h"
#include "io/core/gdal/gdal_support.h"

namespace bole::io {
namespace {

constexpr int steps_per_side = 20;  // of a box that is taken to another system: its sides become curves

std::optional<Eigen::Vector2d> changed(OGRCoordinateTransformation* change, Eigen::Vector2d p) {
  if (change == nullptr) return p;
  int ok = 0;
  if (change->Transform(1, &p.x(), &p.y(), nullptr, &ok) == FALSE || ok == FALSE || !p.allFinite()) return {};
  return p;
}

Eigen::Vector2d applied(const GeoTransform& t, const Eigen::Vector2d& p) {
  return {t[0] + t[1] * p.x() + t[2] * p.y(), t[3] + t[4] * p.x() + t[5] * p.y()};
}

// All of its inside too: a pole or the border of a projection may lie there.
template <class Take>
Eigen::AlignedBox2d box_of(const Eigen::AlignedBox2d& box, Take take) {
  Eigen::AlignedBox2d out;
  for (int i = 0; i <= steps_per_side; ++i)
    for (int k = 0; k <= steps_per_side; ++k) {
      const Eigen::Vector2d share(static_cast<double>(i) / steps_per_side, static_cast<double>(k) / steps_per_side);
      if (const auto p = take(Eigen::Vector2d(box.min() + share.cwiseProduct(box.sizes())))) out.extend(*p);
    }
  return out;
}

std::shared_ptr<OGRSpatialReference> system_of(const std::string& crs) {
  const gdal::Errors quiet;
  auto made = std::make_shared<OGRSpatialReference>();
  auto& system = *made;
  constexpr std::size_t longest = 80;
  const char* const closed[] = {"ALLOW_NETWORK_ACCESS=NO", "ALLOW_FILE_ACCESS=NO", nullptr};
  if (system.SetFromUserInput(crs.c_str(), closed) != OGRERR_NONE)
    throw bad_input(fmt::format("PROJ does not know the coordinate system of the survey, '{}'", crs.substr(0, longest)),
                    "an EPSG code or WKT");
  system.StripVertical();
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (system.IsProjected() == 0)
    throw bad_input(fmt::format("the survey is in '{}', which is no plane", system.GetName()),
                    "a projected coordinate system");
  return made;
}

bool same_system(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  const char* const how[] = {"CRITERION=EQUIVALENT", "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
  return a.IsSame(&b, how) != 0;
}

}  // namespace

MapPlace::MapPlace(GDALDataset& set, const std::string& crs, const std::string& name) {
  if (set.GetGeoTransform(transform_.data()) != CE_None ||
      GDALInvGeoTransform(transform_.data(), inverse_.data()) == FALSE)
    throw bad_input(fmt::format("'{}' does not tell where on the earth it lies", name),
                    "a GeoTIFF with a georeference, or a PNG or JPEG with a world file (.pgw, .jgw) beside it",
                    "Georeference the picture in a GIS");
  if (!crs.empty()) wanted_ = system_of(crs);
  const auto* own = set.GetSpatialRef();
  crs_known_ = own != nullptr && !own->IsLocal();
  if (crs_known_) {
    own_ = std::make_shared<OGRSpatialReference>(*own);
    own_->StripVertical();
  }
  if (!own_ || !wanted_ || same_system(*own_, *wanted_)) {
    if (!own_) own_ = wanted_;
    if (!wanted_) wanted_ = own_;
    return;
  }
  const gdal::Errors errors;
  to_wanted_.reset(OGRCreateCoordinateTransformation(own_.get(), wanted_.get()),
                   OGRCoordinateTransformation::DestroyCT);
  to_own_.reset(OGRCreateCoordinateTransformation(wanted_.get(), own_.get()), OGRCoordinateTransformation::DestroyCT);
  if (!to_wanted_ || !to_own_)
    throw bad_input(fmt::format("'{}' is in '{}', and PROJ knows no way from there to '{}': {}", name, own_->GetName(),
                                wanted_->GetName(), errors.last()),
                    "a coordinate system of the same place on the earth");
}

bool MapPlace::north_up() const {
  return !to_wanted_ && transform_[2] == 0 && transform_[4] == 0 && transform_[1] > 0 && transform_[5] < 0;
}

std::optional<Eigen::Vector2d> MapPlace::to_wanted(const Eigen::Vector2d& pixel) const {
  return changed(to_wanted_.get(), applied(transform_, pixel));
}

std::optional<Eigen::Vector2d> MapPlace::to_pixel(const Eigen::Vector2d& wanted) const {
  const auto own = changed(to_own_.get(), wanted);
  if (!own) return {};
  return applied(inverse_, *own);
}

Eigen::AlignedBox2d MapPlace::pixels_of(const Eigen::AlignedBox2d& wanted) const {
  return box_of(wanted, [this](const Eigen::Vector2d& p) { return to_pixel(p); });
}

Eigen::AlignedBox2d MapPlace::wanted_of(const Eigen::AlignedBox2d& pixels) const {
  return box_of(pixels, [this](const Eigen::Vector2d& p) { return to_wanted(p); });
}

GeoTransform part_of(const GeoTransform& whole, const Eigen::Vector2d& first_pixel, const Eigen::Vector2d& step) {
  const Eigen::Vector2d corner = applied(whole, first_pixel);
  return {corner.x(), whole[1] * step.x(), whole[2] * step.y(), corner.y(), whole[4] * step.x(), whole[5] * step.y()};
}

}  // namespace bole::io
