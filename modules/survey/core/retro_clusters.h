// Groups of strong returns that may be survey targets.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "survey/core/options.h"

namespace bole::survey {

struct RetroCluster {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // in the cloud's axes, metres
  std::size_t points = 0;
  double extent_m = 0;       // along its longest axis, in the map: the thing itself and the blur of the map
  double seen_extent_m = 0;  // median of what single positions saw: the thing itself (extent_m where none saw enough)
  double view_span_m =
      0;          // greatest distance between the sensor positions it was seen from; NaN when they are not known
  int views = 0;  // cells of 1 m of sensor positions it was seen from (1 when they are not known)
  std::vector<std::uint32_t> members;  // indices of its points
  std::vector<double> weights;         // of the members: one per view, shared by its points
  std::string rejected;                // empty for a candidate, else the reason in words
};

struct RetroSearch {
  std::vector<RetroCluster> clusters;  // largest number of views first
  std::size_t strong_points = 0;
  bool too_many =
      false;  // a quarter of all points is strong: min_intensity does not suit the sensor; no cluster is made
};

// Connected groups (gap below 0.2 m) of points whose intensity is above options.min_intensity, with the reasons why
// some are no targets. The centre is robust (Tukey) and weighs each view alike, so that a long stay on one side does
// not draw it there. The size of a target is judged by what single positions saw, so that a map that is bent or doubled
// does not lose it. Groups of fewer than three points are left out. Needs the array intensity.
RetroSearch find_retro_clusters(const PointCloud& cloud, const FrameOptions& options, const Run& run);

}  // namespace bole::survey
