// Flat surfaces of the scene: the table or mat, and which way is up.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/run.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct FoundPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit
  double offset = 0;                                  // normal . p
  double share = 0;                                   // of the points
  double sigma = 0;                                   // scatter of its points about it
};

// The plane with the most points within `tolerance`, by random sampling and then least squares. With `near` its normal
// is within `max_angle_rad` of that direction. Nothing where no plane holds `min_share` of the points.
std::optional<FoundPlane> largest_plane(const Points3& points, double tolerance, double min_share,
                                        const std::optional<Eigen::Vector3d>& near, double max_angle_rad,
                                        const Run& run);

// A level layer in points whose z is up: its height, and the area that it covers in plan.
struct Layer {
  double height = 0, area = 0;
};

// Layers that cover much more plan area than the heights around them, from the lowest up. `bin` is the thickness.
std::vector<Layer> level_layers(const Points3& level, double bin, double plan_cell);

// Robust extent of the points: the diagonal of the box from the 2 % to the 98 % quantile of each axis.
double scene_size(const Points3& points);

}  // namespace bole::plant
