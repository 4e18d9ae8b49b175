// An outline that a person draws over the 3-D view.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "render/scene/pick.h"

namespace bole::desktop {

// Corners of a closed outline in world coordinates, in a plane across the line of sight, and where the eye was; none in
// a parallel view.
struct SceneOutline {
  std::vector<Eigen::Vector3d> corners;
  std::optional<Eigen::Vector3d> eye;
};

// A path without the places that change it by less than `tolerance_px` (Douglas and Peucker, 1973).
std::vector<Eigen::Vector2d> simplified(const std::vector<Eigen::Vector2d>& path_px, double tolerance_px);

// The path at the depth of `target`. `eye` as in SceneOutline.
SceneOutline outline_of(const std::vector<Eigen::Vector2d>& path_px, const render::PickView& view,
                        const Eigen::Vector3d& target, const std::optional<Eigen::Vector3d>& eye);

}  // namespace bole::desktop
