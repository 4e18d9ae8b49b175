#include "ground/core/fill_holes.h"

#include <cmath>
#include <limits>

#include "ground/core/triangulation.h"

namespace bole::ground {
namespace {

// The nearest known cell of each cell (to within a fraction of a cell): distances are handed on in two sweeps over the
// grid, as in Danielsson's sequential distance transform.
class NearestKnown {
 public:
  NearestKnown(const GridShape& shape, const std::vector<float>& height)
      : shape_(shape), nearest_(shape.cells(), no_cell) {
    for (std::size_t c = 0; c < shape.cells(); ++c)
      if (!std::isnan(height[c])) nearest_[c] = static_cast<std::uint32_t>(c);
    for (int iy = 0; iy < shape.ny; ++iy) sweep_row(iy, -1);
    for (int iy = shape.ny - 1; iy >= 0; --iy) sweep_row(iy, 1);
  }

  std::uint32_t of(std::size_t cell) const { return nearest_[cell]; }

  double distance_m(std::size_t cell) const {
    return nearest_[cell] == no_cell ? std::numeric_limits<double>::infinity()
                                     : shape_.cell_m * std::sqrt(squared(cell, nearest_[cell]));
  }

 private:
  double squared(std::size_t a, std::size_t b) const {
    const auto nx = static_cast<std::size_t>(shape_.nx);
    const std::size_t row_a = a / nx, row_b = b / nx;
    const double dx = static_cast<double>(a % nx) - static_cast<double>(b % nx),
                 dy = static_cast<double>(row_a) - static_cast<double>(row_b);
    return dx * dx + dy * dy;
  }

  void look(int ix, int iy, int jx, int jy) {
    if (!shape_.contains(jx, jy)) return;
    const auto cell = shape_.index(ix, iy);
    const auto candidate = nearest_[shape_.index(jx, jy)];
    if (candidate != no_cell && (nearest_[cell] == no_cell || squared(cell, candidate) < squared(cell, nearest_[cell])))
      nearest_[cell] = candidate;
  }

  // Takes from the row at iy + step, then from both sides along the row.
  void sweep_row(int iy, int step) {
    for (int ix = 0; ix < shape_.nx; ++ix)
      for (int dx = -1; dx <= 1; ++dx) look(ix, iy, ix + dx, iy + step);
    for (int ix = 0; ix < shape_.nx; ++ix) look(ix, iy, ix - 1, iy);
    for (int ix = shape_.nx - 1; ix >= 0; --ix) look(ix, iy, ix + 1, iy);
  }

  const GridShape& shape_;
  std::vector<std::uint32_t> nearest_;
};

bool beside_hole(const GridShape& shape, const std::vector<float>& height, int ix, int iy) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (shape.contains(ix + dx, iy + dy) && std::isnan(height[shape.index(ix + dx, iy + dy)])) return true;
  return false;
}

std::vector<float> interpolated(const GridShape& shape, const std::vector<float>& height) {
  std::vector<Eigen::Vector3d> rim;
  for (int iy = 0; iy < shape.ny; ++iy)
    for (int ix = 0; ix < shape.nx; ++ix) {
      const float z = height[shape.index(ix, iy)];
      if (!std::isnan(z) && beside_hole(shape, height, ix, iy))
        rim.emplace_back(shape.centre(ix, iy).x(), shape.centre(ix, iy).y(), static_cast<double>(z));
    }
  std::vector<float> out(shape.cells(), std::numeric_limits<float>::quiet_NaN());
  rasterise(rim, delaunay(rim), shape, out);
  return out;
}

}  // namespace

std::vector<char> fill_holes(const GridShape& shape, const std::vector<float>& prior, double max_distance_m,
                             std::vector<float>& height) {
  const NearestKnown nearest(shape, height);
  const auto inside = interpolated(shape, height);
  std::vector<char> filled(shape.cells(), 0);
  for (std::size_t c = 0; c < shape.cells(); ++c) {
    if (nearest.of(c) == c || nearest.distance_m(c) > max_distance_m) continue;
    const auto known = nearest.of(c);
    const float shifted = prior[c] + height[known] - prior[known];
    height[c] = !std::isnan(inside[c]) ? inside[c] : std::isnan(shifted) ? height[known] : shifted;
    filled[c] = 1;
  }
  return filled;
}

}  // namespace bole::ground
