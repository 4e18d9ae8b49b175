// Where a petiole or a branch leaves its axis, and at which angle.
#pragma once

#include "plant/core/leaves/axis_curve.h"

namespace bole::plant {

struct NodeScales {
  double step = 0;     // of the search along the axis
  double reach = 0;    // how far below the contact the node may be
  double above = 0;    // and above
  double tangent = 0;  // half the length over which the direction of the axis is taken
};

struct LeafNodePlace {
  double along = 0;                                      // the axis
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit, away from the axis
  double angle = 0;                                      // between direction and axis, radians
  bool good = false;                                     // false: too few middles, the contact is taken
};

// The line from a place on the axis through `middles` (of the lower part of an organ, in any order) that fits them
// best. `contact`: where points of the organ and the axis meet.
LeafNodePlace leaf_node(const AxisCurve& axis, const Points3& middles, double contact, const NodeScales& scales);

}  // namespace bole::plant
