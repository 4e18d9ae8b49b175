// The axis of a trunk from the side of it that the sensor sees.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace bole::rows {

struct TrunkFace {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // of the axis at the mean height of the points
  double radius_m = 0;
  double lateral_se_m = 0;  // standard error across the view
  int points = 0;
};

// `points` (m, about a levelled frame whose origin is the sensor) lie near the trunk at `start`. A laser sees the near
// face alone: the mean of its points is about pi/4 radii too near, while directions are far finer than ranges. So the
// axis is found across the view from the strip that the trunk covers, whose half width is the radius, and along the
// view from the ranges, each moved back by the depth of the face at its place in the strip. Leaning is allowed for;
// points off the strip or the face (leaves) lose their weight (Tukey). `max_diameter`: largest diameter. `range_sigma`:
// scatter of a single range. Empty when too few points form a strip.
std::optional<TrunkFace> fit_trunk_face(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector2d& start,
                                        double max_diameter, double range_sigma);

// What stands upright in a cluster: a place in plan that points of many layers share.
struct UprightStrip {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double low_m = 0, high_m = 0;  // of its layers
  int layers = 0;                // of `layer_height`, with points there
  double filled = 0;             // share of the layers between the lowest and the highest that have points there
};

// Leaves and branches fill few layers, a trunk all of them, however few points it has: of the places of all layers that
// is taken which most layers have points at.
UprightStrip find_upright(const std::vector<Eigen::Vector3d>& points, double max_diameter, double range_sigma,
                          double layer_height);

}  // namespace bole::rows
