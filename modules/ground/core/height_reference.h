// Whether z of a cloud is the height above ground already.
#pragma once

#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "ground/core/columns.h"
#include "ground/core/low_points.h"

namespace bole::ground {

struct HeightReference {
  bool above_ground = false;  // z is height, for certain
  std::string evidence;       // in words; empty where it is not
  bool level_cut = false;     // all structures begin at one level above 0, and no ground was seen below them
  double cut_z = 0;           // that level, as z of the cloud
};

// A cloud is normalised when it says so (fact height_reference), when its ground points lie at z = 0 exactly, when
// its ground is level over 30 m or more and ends at z = 0, or when it shows no ground and the feet of its upright
// structures lie at z = 0 all over, with nothing below. Clouds with estimated or given poses come from a survey of our
// own and are never taken for normalised without the fact.
HeightReference height_reference(const PointCloud& cloud, const std::vector<LowPoint>& candidates,
                                 const std::vector<UprightColumn>& columns);

}  // namespace bole::ground
