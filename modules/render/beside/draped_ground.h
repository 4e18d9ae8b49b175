// A picture of the ground that follows the terrain.
#pragma once

#include "cloud/raster.h"
#include "render/beside/ground_places.h"

namespace bole::render {

// `terrain`: heights in the axes of the corners. Beyond it and in its holes the heights next to them go on; without
// any the ground is flat, at the height `z`. It lies a little below the terrain, so that the points of the ground are
// seen.
GroundPlaces draped_ground(const GroundCorners& corners, const Raster& terrain, double z);

}  // namespace bole::render
