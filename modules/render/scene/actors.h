// What a 3-D view of a survey is made of. Coordinates are metres relative to `origin`, which keeps projected coordinates
// exact enough for the graphics card.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "render/scene/point_color.h"

namespace bole {

// Heights above ground run through viridis, but the ground itself is a quiet grey: a third of all points lie on it.
vtkSmartPointer<vtkActor> points_actor(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, const PointColoring& coloring, const Eigen::Vector3d& origin, double size_px);

// A tapered stem, from foot to top.
struct StemShape {
  std::int64_t tree_id = 0;
  std::vector<Eigen::Vector3d> axis;  // at least two points
  std::vector<double> radius_m;
  Eigen::Vector3d breast_height = Eigen::Vector3d::Zero();
  double breast_radius_m = 0;
  std::string quality;
};

// From the fitted sections where a tree has two or more that were used, else from DBH, lean and taper of the stem table.
std::vector<StemShape> stem_shapes(const Table& stems, const Table* sections);

// Takes away the indices of points on or in a fitted stem, so that the stem itself is seen in their place.
void drop_points_on_stems(const PointCloud& cloud, const std::vector<StemShape>& stems, double margin_m, std::vector<std::uint32_t>& indices);

// All stems as one actor, in the colours of their quality (or one colour); rings mark breast height.
vtkSmartPointer<vtkActor> stems_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin, bool color_by_quality);
vtkSmartPointer<vtkActor> breast_height_actor(const std::vector<StemShape>& stems, const Eigen::Vector3d& origin);

vtkSmartPointer<vtkActor> path_actor(const Trajectory& trajectory, const Eigen::Vector3d& origin, double radius_m, const Color& color);

// Lines at whole multiples of `step_m` in the plane z.
vtkSmartPointer<vtkActor> grid_actor(const Interval& x, const Interval& y, double z, double step_m, const Eigen::Vector3d& origin, const Color& color);

}  // namespace bole
