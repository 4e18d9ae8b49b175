// A regular grid of one value per cell: DEM, slope, canopy height.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

// Cell (ix, iy) has its centre at origin + ((ix + 0.5) cell, (iy + 0.5) cell); ix runs east, iy north. Missing: NaN.
struct Raster {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // outer corner of cell (0, 0), metres
  double cell_m = 1;
  int nx = 0, ny = 0;
  std::vector<float> values;  // index iy * nx + ix
  Axes axes = Axes::unknown;
  std::string crs_wkt;
  std::string quantity = "elevation_m";

  float at(int ix, int iy) const {
    return values[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix)];
  }
  float& at(int ix, int iy) {
    return values[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix)];
  }
  bool contains(int ix, int iy) const { return ix >= 0 && iy >= 0 && ix < nx && iy < ny; }

  // Bilinear between cell centres; within half a cell of the border the border value holds. NaN outside or beside a
  // hole.
  double sample(double x, double y) const;
};

}  // namespace cloud
}  // namespace bole
