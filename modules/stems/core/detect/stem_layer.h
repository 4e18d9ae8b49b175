// The points between ground and crowns in a compact grid: what detection and fits search in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::stems {

// Positions are offsets from PointCloud::origin, metres. Points are sorted by cell; within a cell they keep their
// order.
struct StemLayer {
  std::vector<Eigen::Vector3f> position;
  std::vector<float> height;         // above ground, metres
  std::vector<std::uint32_t> index;  // into the cloud
  std::vector<std::uint32_t> start;  // of cell iy * nx + ix; one more than there are cells
  double cell_m = 0.125;
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // where cells and voxels begin, the same in a part of a cloud
  int nx = 0, ny = 0;

  std::size_t size() const { return position.size(); }
  int cell_x(double x) const;
  int cell_y(double y) const;

  // Calls f(k) for every point k whose cell meets the square of half-width `radius_m` around (x, y).
  template <class F>
  void for_each_near(double x, double y, double radius_m, F&& f) const {
    if (nx == 0) return;
    const int x0 = cell_x(x - radius_m), x1 = cell_x(x + radius_m), y0 = cell_y(y - radius_m),
              y1 = cell_y(y + radius_m);
    for (int iy = y0; iy <= y1; ++iy) {
      const auto row = static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx);
      for (auto k = start[row + static_cast<std::size_t>(x0)]; k < start[row + static_cast<std::size_t>(x1) + 1]; ++k)
        f(k);
    }
  }
};

// The points with bottom <= height_above_ground <= top; points that are not finite are left out.
StemLayer make_stem_layer(const PointCloud& points, double bottom_m, double top_m, const Run& run);

}  // namespace bole::stems
