// Limbs of a fork, and fits that are part of a better stem.
#pragma once

#include <vector>

#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// Notes on `trunk` where it forks: circles above breast height that stand beside the stem they join below are its
// limbs.
void note_fork(Stem& trunk, const StemCandidate& limb, double breast_height_m);

// The one among `better` that `stem` is part of, or null. Two stems of a fork touch at most; what overlaps a better
// stem by more is part of it.
Stem* twin_of(const Stem& stem, std::vector<Stem>& better);

}  // namespace bole::stems
