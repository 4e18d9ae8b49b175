// How lines were followed: errors along the way.
#pragma once

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// A panel per speed: the distance from the line along it, each pass of the first run in its colour, the receiver's
// share in grey. `errors`: run, pass, speed_km_h, along_m, error_m, receiver_m.
Figure tracking_error_curves(const Table& errors, double width_mm);

// The same for the distance to the neighbouring pass minus the row width (adjacent_m), where it is known.
Figure adjacent_error_curves(const Table& errors, double width_mm);

}  // namespace bole::render
