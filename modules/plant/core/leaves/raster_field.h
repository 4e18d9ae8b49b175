// Numbers on a small raster, for densities and heights on a leaf.
#pragma once

#include <vector>

namespace bole::plant {

struct RasterField {
  int nx = 0, ny = 0;
  std::vector<double> values;  // row by row

  RasterField(int width, int height, double value = 0)
      : nx(width), ny(height), values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}
  double& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)];
  }
  double at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x)];
  }
  bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < nx && y < ny; }
};

// Gaussian blur; outside there is nothing. `sigma` in cells.
RasterField blurred(const RasterField& field, double sigma);

// The largest value within `reach` cells along both directions.
RasterField largest_within(const RasterField& field, int reach);

// Sets cells that are zero and cannot be reached from the border to one. Returns how many.
int fill_holes(RasterField& mask);

// Sets to zero every connected part (by edges) of the non-zero cells with fewer than `share` of the cells of the
// largest.
void keep_large_parts(RasterField& mask, double share);

}  // namespace bole::plant
