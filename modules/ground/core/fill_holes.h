// Heights for cells without ground points.
#pragma once

#include <vector>

#include "ground/core/point_grid.h"

namespace bole::ground {

// Fills NaN cells that lie within `max_distance_m` of a cell with a height: inside the hull of the known cells by
// linear interpolation over a triangulation of the cells around each hole, outside it with the rough surface `prior`
// shifted to meet the nearest known cell (or that cell's height where the prior is NaN too). Returns 1 for each cell
// that was filled.
std::vector<char> fill_holes(const GridShape& shape, const std::vector<float>& prior, double max_distance_m,
                             std::vector<float>& height);

}  // namespace bole::ground
