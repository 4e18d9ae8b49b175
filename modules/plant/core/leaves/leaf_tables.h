// Leaves, internodes and branches as tables.
#pragma once

#include "cloud/table.h"
#include "plant/core/leaves/plant_organs.h"

namespace bole::plant {

// leaf (from 1), axis (0: the main stem), height_mm (of the node), x_m, y_m, z_m (node, plant axes), azimuth_deg (of
// the petiole, from x towards y in world axes), angle_deg (between petiole and axis, upwards), length_mm and width_mm
// (of the blade), petiole_mm, area_cm2 (of one side of the blade) with its interval, quality (good, check), remark.
Table leaf_table(const PlantOrgans& organs, const Eigen::Matrix3d& R_world_plant, double scale_sd, double noise);

// axis, from_leaf, to_leaf, length_mm (along the axis), turn_deg (of the azimuth, -180 to 180), quality.
Table internode_table(const PlantOrgans& organs, const Eigen::Matrix3d& R_world_plant);

// branch (from 1; the axis of its leaves), parent, height_mm, angle_deg, length_mm, leaves.
Table branch_table(const PlantOrgans& organs);

// 95 % interval of the area of a leaf. Noisy clouds lose the edges of leaves, which are thinner than they can show: the
// upper end allows for it.
struct AreaBounds {
  double low = 0, high = 0;
};
AreaBounds area_bounds(const Leaf& leaf, double scale_sd, double noise);

}  // namespace bole::plant
