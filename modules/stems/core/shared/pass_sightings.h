// What the fitted stems say about the displacements of passes, and how far the passes of a stem were apart before them.
#pragma once

#include <vector>

#include "stems/core/fit/fit_stem.h"
#include "stems/core/shared/pass_alignment.h"

namespace bole::stems {

// Of stems without objection: where each pass sees them, less where all passes put them.
std::vector<PassSighting> pass_sightings(const std::vector<Stem>& fitted, const DriftPrior& drift,
                                         const MeasureOptions& options);

// Raises pass_spread_m to what a person sees of the passes in the cloud as it is: the displacements taken out and those
// that were left.
void restore_spread(Stem& stem, const std::vector<PassAlignment>& alignments);

}  // namespace bole::stems
