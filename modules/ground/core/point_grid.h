// Points sorted into the cells of a regular grid.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::ground {

inline constexpr std::uint32_t no_cell = ~std::uint32_t{0};

// A grid over the plane, in metres relative to PointCloud::origin.
struct GridShape {
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  // outer corner of cell (0, 0)
  double cell_m = 1;
  int nx = 0, ny = 0;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // where the grid of the whole cloud begins

  std::size_t cells() const { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  int column(double x) const { return static_cast<int>((x - corner.x()) / cell_m); }
  int row(double y) const { return static_cast<int>((y - corner.y()) / cell_m); }
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix);
  }
  bool contains(int ix, int iy) const { return ix >= 0 && iy >= 0 && ix < nx && iy < ny; }
  Eigen::Vector2d centre(int ix, int iy) const { return corner + cell_m * Eigen::Vector2d(ix + 0.5, iy + 0.5); }
};

// The smallest grid of that cell size over all finite points. It begins at the corner of the points (and not at a
// multiple of the cell size), so that a cloud that is moved takes its grid along and gets the same terrain; in a part
// of a cloud (cloud/core/whole/whole_cloud.h) its cells are those of the whole. Throws Error{bad_input} when no point
// is finite or the grid would have more than 100 million cells.
GridShape grid_over(const PointCloud& cloud, double cell_m);
bool fits_grid(const PointCloud& cloud, double cell_m);  // not too many cells

// Coordinates of files are multiples of a millimetre or of a part of it. A border or limit that avoids them is not
// crossed when a moved cloud is rounded anew.
inline constexpr double off_the_multiples_m = 0.00037;

// For each cell the indices of its points, by ascending z (then x, y, index). Points with a coordinate that is not
// finite are in no cell. Memory: 4 bytes per point and per cell, and another 4 bytes per point while it is built.
class PointGrid {
 public:
  PointGrid(const PointCloud& cloud, const GridShape& shape, const Run& run);

  const GridShape& shape() const { return shape_; }
  std::span<const std::uint32_t> points(std::size_t cell) const {
    return {order_.data() + start_[cell], order_.data() + start_[cell + 1]};
  }
  std::size_t size() const { return order_.size(); }

 private:
  void count_and_scatter(const PointCloud& cloud, const Run& run);
  void sort_cells(const PointCloud& cloud, const Run& run);

  GridShape shape_;
  std::vector<std::uint32_t> start_;  // cells + 1
  std::vector<std::uint32_t> order_;
};

}  // namespace bole::ground
