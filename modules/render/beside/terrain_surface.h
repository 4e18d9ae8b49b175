// The terrain of a survey as a surface in a scene, with contour lines.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include "cloud/raster.h"

namespace bole::render {

struct TerrainSurface {
  vtkSmartPointer<vtkActor> ground;    // null where the raster has no square of four values
  vtkSmartPointer<vtkActor> contours;  // null where it is as good as level
  double contour_step_m = 0;           // 0: none
};

// Through the heights at the centres of cells, in the tints and with the shading of the terrain map of a report; holes
// stay open. Of a raster of more than 400 cells along a side every second, third, ... one. `origin` of the scene.
TerrainSurface terrain_surface(const Raster& terrain, const Eigen::Vector3d& origin);

}  // namespace bole::render
