// What sample plots say about a stand, by their size.
#pragma once

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// Two panels over the radius of the plots: bias of the basal area with its 95 % interval, and scatter of single plots;
// a line per treatment of the edge, and the scatter of trees at random dashed. `summary`: radius_m, edge,
// basal_area_m2_per_ha_bias_pct, _bias_se_pct, _sd_pct, _poisson_sd_pct.
Figure sample_curves(const Table& summary, double width_mm);

}  // namespace bole::render
