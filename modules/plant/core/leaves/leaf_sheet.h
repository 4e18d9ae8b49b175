// The surface of one leaf: its midrib, length, breadth and area.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct SheetScales {
  double cell = 0;   // of the raster on the leaf
  double step = 0;   // between levels along the leaf
  double noise = 0;  // of the points across the surface
  double blade = 0;  // smallest breadth of a blade
};

struct LeafSheet {
  bool blade = false;                                    // broad and flat; false: a stalk, a twig or a lump
  double length = 0;                                     // of the blade along its midrib
  double width = 0;                                      // of the blade along its surface, where it is broadest
  double area = 0;                                       // of one side of the blade
  double area_sd = 0;                                    // of where its edge is
  double edge = 0;                                       // length of the margin of the blade
  double filled = 0;                                     // share of the area without points
  Eigen::Vector3d blade_foot = Eigen::Vector3d::Zero();  // where the blade begins
  Points3 stalk_middles;                                 // middles from the beginning into the blade, for the direction
  Points3 midrib;                                        // from the beginning to the tip
};

// `distance`: of each point along the plant. The points are spread out along a smooth midrib; across it their mean
// height is the sheet, so that both sides and noise count once. A leaf ends where the density of its points has fallen
// to one half, which is where a straight edge is, whatever the noise.
LeafSheet leaf_sheet(const Points3& points, const std::vector<double>& distance, const SheetScales& scales);

}  // namespace bole::plant
