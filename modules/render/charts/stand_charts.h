// The stand: heights over diameters, and how stems taper.
#pragma once

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// Height over diameter of the stems, in the colours of quality; rings are lower bounds (the top was not seen). `curve`:
// the height curve with breast_height_m, a, b, min_dbh_cm and max_dbh_cm, drawn over the diameters that it was fitted
// to; null or without rows where there is none.
Figure height_diameter(const Table& stems, const Table* curve, double width_mm);
bool has_heights(const Table& stems);

// Diameter over height above ground: the sections of the stem curve of each tree of `stems` as a line.
Figure taper_curves(const Table& stems, const Table& sections, double width_mm);
bool has_stem_curves(const Table& stems, const Table& sections);

}  // namespace bole::render
