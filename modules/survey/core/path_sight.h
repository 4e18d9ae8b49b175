// Whether the sensor could see the points from where a path has it.
#pragma once

#include <optional>

#include "cloud/point_cloud.h"
#include "survey/core/path_curve.h"

namespace bole::survey {

struct PathSight {
  std::size_t rays = 0;
  double crossing = 0;  // share of them that pass through other points
  // The shift of the path in plan, of those tried (1, 2 and 4 m, eight ways), with which fewest do.
  Eigen::Vector2d better_shift_m = Eigen::Vector2d::Zero();
  double crossing_there = 0;

  // The shift lets rays see that the path as it is does not, by more than chance.
  bool doubts_path() const;
};

// Rays from the sensor at the time of a point to the point, in windows of 50 m about three places of the path, of those
// points that lie about as high as the sensor. A voxel of 0.1 m with points in it stands in the way of a ray unless it
// is near one of its ends. Nothing where too few rays can be judged. Not every moved path is found: of the simulated
// stands `demo` and `mixed_stand` (seeds 5 and 6, 8 s of walking) moved by 1, 1.5, 2.2 and 3 m all four and two were,
// and a path that is moved by less than a metre looks through stems hardly more often than the right one.
std::optional<PathSight> path_sight(const PointCloud& points, const PathCurve& curve, double offset_s);

}  // namespace bole::survey
