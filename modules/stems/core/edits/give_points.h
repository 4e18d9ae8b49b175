// Points that a person gave to a tree, or to none.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/run.h"
#include "cloud/core/regions/point_edits.h"
#include "stems/core/tree/assign_points.h"

namespace bole::stems {

constexpr double tree_reach_m = 0.5;  // between the place in an edit and the stem that it means

struct TreePlace {
  std::int32_t id = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // at breast height, metres
};

// The tree that a place means: the nearest within the reach, unless a second one is less than twice as far.
std::optional<std::int32_t> tree_at(const std::vector<TreePlace>& trees, const Eigen::Vector2d& at,
                                    double reach_m = tree_reach_m);

// What became of an edit, by its place in the list.
struct GivenPoints {
  std::optional<std::int32_t> tree;  // that the points were given to; 0: none. Empty: the edit was not applied
  std::int64_t points = 0;           // that were given, in all; later edits may have given them on
  bool lacks_condition = false;      // not applied because the tree of its condition is not there
};

// Changes labels of points, one edit after another; edits that give a class are passed over, and so are points that
// they gave one. Points that change their tree are no longer bark. An edit whose tree, or the tree of whose condition,
// is not among `trees` is not applied. `given` (where not null) becomes 1 where a point was given. Throws
// Error{cancelled}.
std::vector<GivenPoints> give_points(const PointCloud& cloud, const std::vector<PointEdit>& edits,
                                     const std::vector<TreePlace>& trees, PointLabels& labels, const Run& run,
                                     std::vector<std::uint8_t>* given = nullptr);

// The points with coordinates that are not numbers where a person gave the ground or noise: no part of a stem.
PointCloud without_given_classes(const PointCloud& cloud, const std::vector<PointEdit>& edits, const Run& run);

}  // namespace bole::stems
