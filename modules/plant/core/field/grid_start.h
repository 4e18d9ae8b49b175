// The first guess of a grid: signed distances and colours of the views' depth.
#pragma once

#include "plant/core/field/field_model.h"
#include "plant/core/field/grid_encoder.h"

namespace bole::plant {

// Sets density and colour of the lattice points that views with depth see near a surface. Uses up to `max_views`.
void start_grid(GridEncoder& grid, const FieldSpace& space, const std::vector<FieldView>& views,
                const DepthNoise& noise, int max_views, const Run& run);

}  // namespace bole::plant
