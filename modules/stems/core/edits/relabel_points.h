// Tree ids of points after stems were added, split, merged or deleted.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::stems {

// Points of tree `from` (of any when empty) get the id of the nearest of `to`; with a reach, only points within it in
// plan between `bottom_m` and `top_m` above the ground, and these become bark.
struct Relabel {
  struct Target {
    std::int32_t id = 0;  // 0: no tree
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
  };
  std::optional<std::int32_t> from;
  std::vector<Target> to;
  double reach_m = 0;  // 0: without end
  double bottom_m = 0, top_m = 0;
};

// `points` with the columns tree_id and stem changed, step by step; as it is when there are no steps.
PointCloud relabel_points(const PointCloud& points, const std::vector<Relabel>& steps, const Run& run);

}  // namespace bole::stems
