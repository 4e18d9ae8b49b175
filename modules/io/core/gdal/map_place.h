// Where the pixels of a raster lie in another coordinate system, and which of them a survey needs.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <string>

class GDALDataset;
class OGRCoordinateTransformation;
class OGRSpatialReference;

namespace bole::io {

using GeoTransform =
    std::array<double, 6>;  // of GDAL: easting = t0 + t1 column + t2 row, northing = t3 + t4 ... + t5 ...

class MapPlace {
 public:
  // `crs` as MapWanted has it. Throws Error{bad_input} where the raster has no georeference, or PROJ does not know the
  // way from one system to the other. `name` of the file, for messages.
  MapPlace(GDALDataset& set, const std::string& crs, const std::string& name);

  bool crs_known() const { return crs_known_; }
  const GeoTransform& transform() const { return transform_; }
  const OGRSpatialReference* own_crs() const { return own_.get(); }  // null: none is known
  const OGRSpatialReference* wanted_crs() const { return wanted_.get(); }
  // Its pixels are those of the wanted system as they are.
  bool north_up() const;

  // Column and row (outer corner of the first pixel: 0, 0) to easting and northing, and back. Nothing outside the
  // domain of a projection.
  std::optional<Eigen::Vector2d> to_wanted(const Eigen::Vector2d& pixel) const;
  std::optional<Eigen::Vector2d> to_pixel(const Eigen::Vector2d& wanted) const;

  // Around what a box becomes; empty where nothing of it can be told.
  Eigen::AlignedBox2d pixels_of(const Eigen::AlignedBox2d& wanted) const;
  Eigen::AlignedBox2d wanted_of(const Eigen::AlignedBox2d& pixels) const;

 private:
  GeoTransform transform_{}, inverse_{};
  std::shared_ptr<OGRSpatialReference> own_, wanted_;
  std::shared_ptr<OGRCoordinateTransformation> to_wanted_, to_own_;  // null: the systems are the same
  bool crs_known_ = false;
};

// The transform of a part of a raster that was read into fewer pixels.
GeoTransform part_of(const GeoTransform& whole, const Eigen::Vector2d& first_pixel, const Eigen::Vector2d& step);

}  // namespace bole::io
