// Which cells of a grid hold points, and the spacing of points that follows.
#pragma once

#include <cstddef>
#include <vector>

namespace bole {
inline namespace cloud {

inline constexpr double finest_spacing_m = 0.25, coarsest_spacing_m = 4.0;

class OccupiedCells {
 public:
  OccupiedCells(int nx, int ny);
  void occupy(int ix, int iy) { holds_[index(ix, iy)] = true; }
  int nx() const { return nx_; }
  int ny() const { return ny_; }
  std::size_t count() const;
  // Cells twice as large over the same area.
  OccupiedCells coarser() const;

 private:
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix);
  }
  int nx_, ny_;
  std::vector<bool> holds_;
};

// The smallest of cell_m, 2 cell_m, ... up to coarsest_spacing_m at which at least two fifths of the cells of that size
// hold points, in the area that the points cover.
double spacing_of(OccupiedCells cells, double cell_m);

}  // namespace cloud
}  // namespace bole
