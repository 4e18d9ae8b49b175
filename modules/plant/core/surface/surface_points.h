// Points and meshes of the surface of a TSDF.
#pragma once

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "plant/core/surface/tsdf.h"

namespace bole::plant {

// A point at every place where the distance changes its sign between neighbouring voxels, with normal_x, normal_y,
// normal_z (towards the cameras), red, green, blue and weight. Both voxels must have `min_weight`.
PointCloud surface_points(const Tsdf& grid, double min_weight);

// Naive surface nets (Gibson 1998): one vertex per cell with a change of sign, one quad per edge with one.
struct SurfaceMesh {
  PointCloud vertices;  // with colours and normals
  Table triangles;      // a, b, c: rows of the vertices, counter-clockwise seen from outside
};
SurfaceMesh surface_mesh(const Tsdf& grid, double min_weight);

}  // namespace bole::plant
