// Points as an actor, in the colours of a paint, with an opacity.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <span>

#include "render/scene/point_paint.h"

namespace bole::render {

// Coordinates are metres relative to `origin`. `opacity`: see let_shine_through().
vtkSmartPointer<vtkActor> painted_points_actor(const PointCloud& cloud, std::span<const std::uint32_t> indices,
                                               const PointPaint& paint, const Eigen::Vector3d& origin, double size_px,
                                               double opacity);

// What they are drawn at, three numbers for each of the indices. Of an actor of painted_points_actor() only.
std::span<const float> drawn_at(vtkActor& actor);

// So large a share of the pixels is drawn, in steps of a sixteenth; 1: all. Points that are blended would be opaque
// again wherever several lie behind one another, which in a cloud is everywhere.
void let_shine_through(vtkActor& actor, double opacity);

}  // namespace bole::render
