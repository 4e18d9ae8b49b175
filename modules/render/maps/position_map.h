// Where the stems of several runs of one plot are.
#pragma once

#include <vector>

#include "cloud/plot_area.h"
#include "render/charts/match_group.h"
#include "render/draw/figure.h"

namespace bole::render {

// Reference positions as rings, those of each run as crosses (upright for the first, diagonal for the second). Errors
// are drawn `enlarge` times, 0: so that they can be seen; the caption says so. Missed trees are rings alone, extra ones
// crosses alone.
Figure position_map(const std::vector<MatchGroup>& runs, const PlotArea& area, double width_mm, double enlarge = 0);

}  // namespace bole::render
