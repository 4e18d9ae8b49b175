// A picture of the ground in a scene: a map below a survey, flat behind everything else or over the terrain.
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>

#include <Eigen/Core>
#include <memory>

#include "render/beside/ground_places.h"

namespace bole::render {

// Shares the pixels, and keeps them alive. `smaller_too`: with all smaller sizes of the picture, for views that show it
// small; of a picture of 4096 x 4096 pixels they take 0.1 s to make.
vtkSmartPointer<vtkTexture> ground_texture(const std::shared_ptr<const GroundPicture>& picture, bool smaller_too);

vtkSmartPointer<vtkActor> ground_actor(vtkTexture* texture, const GroundPlaces& places, const Eigen::Vector3d& origin,
                                       double opacity);

}  // namespace bole::render
