#include "cloud/core/whole/occupied_cells.h"

#include <algorithm>
#include <utility>

namespace bole {
inline namespace cloud {

OccupiedCells::OccupiedCells(int nx, int ny)
    : nx_(nx), ny_(ny), holds_(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), false) {}

std::size_t OccupiedCells::count() const {
  return static_cast<std::size_t>(std::count(holds_.begin(), holds_.end(), true));
}

OccupiedCells OccupiedCells::coarser() const {
  OccupiedCells out((nx_ + 1) / 2, (ny_ + 1) / 2);
  for (int iy = 0; iy < ny_; ++iy)
    for (int ix = 0; ix < nx_; ++ix)
      if (holds_[index(ix, iy)]) out.occupy(ix / 2, iy / 2);
  return out;
}

double spacing_of(OccupiedCells cells, double cell_m) {
  constexpr double min_share = 0.4;
  std::vector<std::size_t> counts{cells.count()};  // of occupied cells, at cell_m, 2 cell_m, 4 cell_m, ...
  for (std::size_t k = 0;; ++k, cell_m *= 2) {
    while (counts.size() <= k + 2) {
      cells = cells.coarser();
      counts.push_back(cells.count());
    }
    const double share = static_cast<double>(counts[k]) / (16.0 * static_cast<double>(counts[k + 2]));
    if (share >= min_share || cell_m >= coarsest_spacing_m) return cell_m;
  }
}

}  // namespace cloud
}  // namespace bole
