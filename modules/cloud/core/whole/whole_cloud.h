// What a part of a cloud keeps of the whole: stages that lay grids over the points lay them as over the whole, so that
// a part gives the results of the whole.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/run.h"
#include "cloud/known_facts.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo whole_origin{"whole_origin", "", 0, 0,
                                       "Of a part of a cloud: origin of the whole, x y z in its coordinates."};
inline constexpr FactInfo whole_low{"whole_low", "", 0, 0,
                                    "Of a part of a cloud: least coordinates of the whole, x y z from its origin."};
inline constexpr FactInfo whole_spacing{"whole_spacing_m", "m", 1e-3, 1e3,
                                        "Of a part of a cloud: the spacing of points that the whole follows."};

}  // namespace facts

struct WholeCloud {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d low = Eigen::Vector3d::Zero();  // offsets from `origin`, as the cloud of the whole has them
};

// Nothing of a cloud that is a whole itself, or where the facts are damaged.
std::optional<WholeCloud> whole_of(const Facts& facts);
std::optional<double> spacing_of_whole(const Facts& facts);
void set_whole(Facts& facts, const WholeCloud& whole, double spacing_m);

// For points that have left the coordinates of their file.
void forget_whole(Facts& facts);

// Where grids begin: the least coordinates of the finite points of the whole, offsets from cloud.origin. It moves with
// the cloud, so that a cloud gets the same grids wherever it lies. Infinite where no point is finite.
Eigen::Vector3d grid_anchor(const PointCloud& cloud, const Run& run = {});

// The corner of the cells of `cell_m` that begin at `anchor`, at or below `low`.
Eigen::Vector2d aligned_corner(const Eigen::Vector2d& low, const Eigen::Vector2d& anchor, double cell_m);

}  // namespace cloud
}  // namespace bole
