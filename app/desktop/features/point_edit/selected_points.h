// What the points of a selection are, and how a cloud looks once they were given to something.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cloud/core/regions/point_edits.h"

namespace bole::desktop {

// Points in any of the regions, ascending; with `only_tree` those of that tree alone (0: of none).
std::vector<std::uint32_t> points_within(const PointCloud& cloud, const std::vector<PointRegion>& regions,
                                         const std::optional<std::int32_t>& only_tree);

// Where a stem stands among the points: the middle of the circle that they hold at breast height. Throws
// Error{bad_input} where they hold none.
Eigen::Vector2d stem_among(const PointCloud& cloud, const std::vector<std::uint32_t>& points);

std::int32_t free_tree_id(const PointCloud& cloud);  // above all that there are

// The cloud as it is after an edit: tree ids and classes of `points`.
std::shared_ptr<const PointCloud> relabelled(const PointCloud& cloud, const std::vector<std::uint32_t>& points,
                                             const std::optional<std::int32_t>& tree, const PointEdit& edit);

// Lines that show a region in world coordinates.
std::vector<std::vector<Eigen::Vector3d>> lines_of(const PointRegion& region);

}  // namespace bole::desktop
