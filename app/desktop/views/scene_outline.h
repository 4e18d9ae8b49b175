// An outline that a person draws over the 3-D view or in a cross-section.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "render/scene/pick.h"

namespace bole::desktop {

// Corners of a closed outline in world coordinates, in a plane across the line of sight, and where the eye was; none in
// a parallel view and in a cross-section.
struct SceneOutline {
  std::vector<Eigen::Vector3d> corners;
  std::optional<Eigen::Vector3d> eye;
  std::optional<double> half_depth_m{};  // in a cross-section: only so far from the plane, to both sides
};

// A path without the places that change it by less than `tolerance_px` (Douglas and Peucker, 1973).
std::vector<Eigen::Vector2d> simplified(const std::vector<Eigen::Vector2d>& path_px, double tolerance_px);

// The path at the depth of `target`. `eye` as in SceneOutline.
SceneOutline outline_of(const std::vector<Eigen::Vector2d>& path_px, const render::PickView& view,
                        const Eigen::Vector3d& target, const std::optional<Eigen::Vector3d>& eye);

}  // namespace bole::desktop
