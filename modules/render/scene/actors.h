// What a 3-D view of a survey is made of. Coordinates are metres relative to `origin`, which keeps projected
// coordinates exact enough for the graphics card.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/trajectory.h"
#include "render/scene/point_color.h"
#include "render/scene/stem_shapes.h"

namespace bole::render {

// Heights above ground run through viridis, but the ground itself is a quiet grey: a third of all points lie on it.
vtkSmartPointer<vtkActor> points_actor(const PointCloud& cloud, const std::vector<std::uint32_t>& indices,
                                       const PointColoring& coloring, const Eigen::Vector3d& origin, double size_px);

// All stems as one actor, in the colours of their quality (or one colour); rings mark breast height, `half_height_m` up
// and down.
vtkSmartPointer<vtkActor> stems_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin,
                                      bool color_by_quality);
vtkSmartPointer<vtkActor> breast_height_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin,
                                              double half_height_m);

vtkSmartPointer<vtkActor> path_actor(const Trajectory& trajectory, const Eigen::Vector3d& origin, double radius_m,
                                     const Color& color);

// Lines at whole multiples of `step_m` in the plane z.
vtkSmartPointer<vtkActor> grid_actor(const Interval& x, const Interval& y, double z, double step_m,
                                     const Eigen::Vector3d& origin, const Color& color);

}  // namespace bole::render
