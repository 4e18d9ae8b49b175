// What the stems of a project say together about errors that they share: the second round of fits takes it as known.
#pragma once

#include <array>
#include <vector>

#include "base/run.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

inline constexpr double known_range_offset_sd_m = 0.0005;  // prior where the range offset is not estimated

// Log likelihoods of what one stem says, by pairs of spreads of passes and views, less that of its best pair. Those of
// all stems add up, also over stems that were measured apart.
inline constexpr std::size_t drift_pass_steps = 11, drift_view_steps = 8;
using DriftLikelihoods = std::array<double, drift_pass_steps * drift_view_steps>;
DriftLikelihoods drift_likelihoods(const DriftEvidence& stem);
DriftPrior mean_drift(const DriftLikelihoods& sum);

// The spreads of passes and views by the evidence of all stems.
DriftPrior mean_drift(const std::vector<const DriftEvidence*>& stems, const Run& run);

// Mean over stems, which differ by more than their own uncertainty (sections are not round): a random-effects mean of
// bounded influence, drawn to zero by what is expected of a sensor: Student's distribution of three degrees of freedom
// and scale `expected_sd_m`. Offsets of a few millimetres, which a common error of shape can feign, count little, those
// of centimetres nearly in full. `view_sd_m`: DriftPrior of the same stems. What no number of stems averages out grows
// with it, for poses lean towards what they see, and with the doubt of the beam.
RangeOffsetPrior mean_range_offset(const std::vector<RangeOffsetEvidence>& stems, double expected_sd_m,
                                   double view_sd_m);

// The middle of the stems and how far they differ. Zero below 6 mm: a beam is not known better, and so little blur
// moves no diameter by half a millimetre.
BlurPrior mean_blur(std::vector<double> blurs_m);

}  // namespace bole::stems
