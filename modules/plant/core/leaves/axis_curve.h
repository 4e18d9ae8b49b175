// The curve along the middle of a stem or branch.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct AxisCurve {
  Points3 places;             // even steps
  std::vector<double> arc;    // length from the first place
  std::vector<double> radii;  // of the points about the curve; NaN where there are too few

  bool empty() const { return places.size() < 2; }
  double length() const { return arc.empty() ? 0 : arc.back(); }
  Eigen::Vector3d at(double along) const;
  Eigen::Vector3d tangent(double along, double reach) const;  // unit, over `reach` to both sides
  double radius_at(double along) const;                       // of the nearest place that has one; NaN without any

  struct Nearest {
    double along = 0, distance = 0;
  };
  Nearest nearest(const Eigen::Vector3d& place) const;
};

struct AxisScales {
  double step = 0;        // between places
  double smooth = 0;      // standard deviation of the smoothing along the axis
  double max_radius = 0;  // points further from the axis are something else
};

// The curve with a straight piece of `length` at its end, in the direction of its last `look`.
AxisCurve extended(const AxisCurve& curve, double length, double look);

// A curve through rough middles in order, moved to the middle of the points around it.
AxisCurve axis_curve(const Points3& middles, const Points3& points, const AxisScales& scales);

}  // namespace bole::plant
