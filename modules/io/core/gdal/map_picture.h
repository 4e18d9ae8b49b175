// A picture with a place on the earth (orthophoto, scanned map), read to be drawn behind a survey.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/run.h"

namespace bole::io {

// North up in the coordinate system that was asked for. Rows run south: the first one is the northernmost.
struct MapPicture {
  int width = 0, height = 0;                             // px
  std::vector<std::uint8_t> rgba;                        // 4 x width x height; alpha 0: nothing is known there
  Eigen::Vector2d north_west = Eigen::Vector2d::Zero();  // outer corner of the first pixel: easting, northing
  Eigen::Vector2d pixel_m = Eigen::Vector2d::Ones();     // of a pixel, eastwards and southwards, in that system
  bool crs_known = true;                                 // false: its system was taken to be the one asked for
  double file_pixel_m = 1;                               // of the file, in that system; less where it was thinned

  Eigen::Vector2d south_east() const {
    return north_west + Eigen::Vector2d(width * pixel_m.x(), -height * pixel_m.y());
  }
};

struct MapWanted {
  std::string crs;             // WKT or EPSG code, projected; empty: that of the picture, whichever it is
  Eigen::AlignedBox2d survey;  // eastings and northings in it
  double margin_m = 0;         // that is read around it
  int max_side_px = 4096;
};

// The part around the survey of any raster that GDAL reads: 1 band (grey, palette) or 3, with or without alpha, of 8
// bits; others are scaled by the middle 98 % of the values there. "No data" is transparent. Pictures in another system,
// and those that are not north up, are warped. Larger ones are thinned while they are read. Throws Error{bad_input}
// where the file has no georeference, cannot be read, or does not meet the survey with its margin; Error{cancelled}.
MapPicture read_map_picture(const std::filesystem::path& path, const MapWanted& wanted, const Run& run = {});

// Endings of the pictures that people have most, "*.tif *.png ...": for a dialog; others can be read too.
inline constexpr const char* map_picture_endings = "*.tif *.tiff *.png *.jpg *.jpeg *.jp2 *.vrt *.gpkg *.img *.ecw";

}  // namespace bole::io
