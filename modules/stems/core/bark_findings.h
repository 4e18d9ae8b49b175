// What the picture of the bark says against the diameters of all stems together.
#pragma once

#include <vector>

#include "base/run.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// Findings: stems_sparse, noise_high, bark_blurred, beam_unknown, bark_convention. `noise_m` is the scatter of ranges
// on the bark, middle of the stems, 0 where it is not known.
void judge_bark(const std::vector<Stem>& stems, const MeasureOptions& options, bool along_rays, double noise_m,
                Report& report);

}  // namespace bole::stems
