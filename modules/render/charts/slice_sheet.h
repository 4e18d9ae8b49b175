// The sheet that a forester signs: for every tree the points at breast height and the circle that was fitted to them.
#pragma once

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct SliceSheetOptions {
  int columns = 5;
  int rows_per_page = 6;
  int max_points = 1200;  // drawn per tree
};

// One figure per page ("slices_01", ...), the trees with the least trustworthy diameter first. `slice`: points around
// breast height, coloured by `pass` where there is more than one. Trees without points are shown too, with a note.
std::vector<Figure> slice_sheets(const Table& stems, const PointCloud& slice, double width_mm,
                                 const SliceSheetOptions& options = {});

}  // namespace bole::render
