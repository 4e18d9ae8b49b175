// Points a camera at a survey, and tells where on the sheet a place of the world comes to lie.
#pragma once

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

// World to sheet: a 4 x 4 matrix to the unit cube, then millimetres.
struct Projection {
  Eigen::Matrix4d world_to_view = Eigen::Matrix4d::Identity();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Box box;
  Eigen::Vector2d map(const Eigen::Vector3d& world) const {
    const Eigen::Vector4d v = world_to_view * (world - origin).homogeneous();
    return {box.x0 + (v.x() / v.w() + 1) / 2 * box.width(), box.y1 - (v.y() / v.w() + 1) / 2 * box.height()};
  }
};

// Width over height of the view is `aspect`.
Eigen::Matrix4d view_matrix(vtkCamera* camera, double aspect);

// The view's rectangle around points, in -1 to 1, rows upwards.
Box rectangle_on_view(const Eigen::Matrix4d& matrix, const std::vector<Eigen::Vector3d>& points);

// Straight down, y up on the sheet, parallel, so that `size` (metres) fills the view.
void aim_from_above(vtkCamera* camera, const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double aspect);

// In perspective from a direction (clockwise from y, above the horizon), as near as all points of `outline` fit.
void aim_obliquely(vtkCamera* camera, const Eigen::Vector3d& centre, const Eigen::Vector3d& size, double aspect,
                   const std::vector<Eigen::Vector3d>& outline, double azimuth_deg, double elevation_deg);

}  // namespace bole::render
