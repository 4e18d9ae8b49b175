// Terrain and canopy from above.
#pragma once

#include "cloud/plot_area.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

enum class RasterKind { terrain, canopy };

struct RasterMapData {
  const Raster* raster = nullptr;
  const Table* stems = nullptr;  // x_m, y_m: drawn as dots
  PlotArea area;                 // drawn, and with a margin what is shown; without one the whole raster
  bool north_known = true;
};

// The terrain with hill shading and contour lines at a round interval, or heights of the canopy. Copies what it draws.
// Throws Error{bad_input} for a raster without a value.
Figure raster_map(const RasterMapData& data, RasterKind kind, double width_mm);

}  // namespace bole::render
