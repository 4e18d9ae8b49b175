// The axis of a stem near one height.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "plant/core/separate/point_grid.h"

namespace bole::plant {

// Plant axes: z up, the origin where the stem leaves the soil, metres. The axis is a parabola in plan over the height.
struct StemCurve {
  double height = 0;  // z where t = 0
  double unit = 1;    // z of t = 1
  Eigen::Vector2d place = Eigen::Vector2d::Zero(), lean = Eigen::Vector2d::Zero(), bow = Eigen::Vector2d::Zero();

  Eigen::Vector3d at(double z) const {
    const double t = (z - height) / unit;
    const Eigen::Vector2d p = place + t * (lean + t * bow);
    return {p.x(), p.y(), z};
  }
  Eigen::Vector3d tangent(double z) const {  // unit, upwards
    const Eigen::Vector2d slope = (lean + 2 * (z - height) / unit * bow) / unit;
    return Eigen::Vector3d(slope.x(), slope.y(), 1).normalized();
  }
};

struct CloudStem {
  StemCurve curve;
  double radius = 0;     // of the cloud's surface about the axis: too large where depth is fattened
  double radius_sd = 0;  // scatter over the layers
  double residual = 0;   // of the layers' middles about the curve
  double min_z = 0, max_z = 0;
  std::size_t layers = 0;
};

// Follows the stem from the origin upwards through thin layers of the plant's points, and fits the curve to the layers
// within `reach` of `height`. `step`: thickness of a layer; `max_radius`: points further from the axis are leaves.
// Nothing where fewer than five layers hold points.
std::optional<CloudStem> stem_from_cloud(const Points3& plant, double height, double reach, double step,
                                         double max_radius);

}  // namespace bole::plant
