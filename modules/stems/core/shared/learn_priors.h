// What all stems of a project say together after their first fits.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/fit/fit_stem.h"
#include "stems/core/shared/pooled_priors.h"

namespace bole::stems {

inline constexpr double min_drift_to_align_m = 0.01;  // between passes

// Empirical Bayes: what all stems share is the prior of a second round. `moved_m`: by which passes were brought
// together before. Metrics: drift_between_passes, drift_between_views, range_offset.
void learn_priors(const std::vector<Stem>& fitted, const MeasureOptions& options, double moved_m, ProjectPriors& priors,
                  Report& report, const Run& run);

// The same from what the stems of many clouds said. Finding passes_not_aligned where the passes disagree.
void take_pooled(const PooledPriors& pooled, const MeasureOptions& options, double moved_m, ProjectPriors& priors,
                 Report& report);

// What the stems without objection say, for pool(). `origin`: of the cloud.
std::vector<StemEvidence> evidence_of(const std::vector<Stem>& fitted, const MeasureOptions& options,
                                      const Eigen::Vector3d& origin);

// Scatter of the ranges on the bark, metres: the middle of the stems. Nothing where no fit was along rays.
std::optional<double> seen_noise_m(const std::vector<Stem>& fitted, const MeasureOptions& options);

// Scatter of the rays across themselves. Zero where stems say that the map is sharp, or say nothing.
BlurPrior seen_blur(const std::vector<Stem>& fitted, const MeasureOptions& options);

// Whether it was seen all round: rays that come from one side cannot tell a stretch from the place of the stem.
bool tells_range_stretch(const Stem& stem);

// Of the cloud as it came; `taken_out` of the points that were fitted.
RangeStretchPrior learn_range_stretch(const std::vector<Stem>& fitted, const MeasureOptions& options, double taken_out);

// Where the stems stand that tell it, coordinates of the map. `origin`: of the cloud.
std::vector<Eigen::Vector2d> stretched_stems(const std::vector<Stem>& fitted, const MeasureOptions& options,
                                             const Eigen::Vector3d& origin);

}  // namespace bole::stems
