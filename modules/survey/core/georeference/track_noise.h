// Unknowns of a GNSS track whose errors last: neighbouring fixes err alike.
#pragma once

#include "survey/core/georeference/track_rows.h"

namespace bole::survey {

// What is known of the unknowns beside the track: observations with their weights (1 / variance).
struct TrackPriorInformation {
  TrackVector weight = TrackVector::Zero();
  TrackVector residual = TrackVector::Zero();  // known - present value
};

struct TrackEstimate {
  TrackVector step = TrackVector::Zero();  // to be added to the unknowns
  TrackMatrix covariance = TrackMatrix::Zero();
  // Of the errors: standard deviation of a fix with sd_m = 1, time after which they are forgotten (1/e), share of their
  // variance that is new at every fix. Means of what the residuals leave possible.
  double sd_m = 0, time_constant_s = 0, white_share = 0;
  double fixes_per_independent = 1;  // fixes that say as much of the shift as one without correlation
};

// The errors of each axis are the sum of a first-order process and white noise. How large they are, how long they last
// and how much is white is not known: each combination on a grid has the probability that the residuals of the plan
// give it (marginal likelihood: the unknowns are integrated out, so that what they take from the residuals is allowed
// for; log-uniform priors), and estimate and covariance are the mean over all of them. So the covariance contains that
// few independent fixes do not tell their own errors. `usual_sd_m`: about the size of the errors, in the middle of the
// grid. Rows in order of time; needs at least two that are used.
TrackEstimate estimate_with_lasting_errors(const std::vector<TrackRow>& rows, const TrackPriorInformation& prior,
                                           double usual_sd_m);

}  // namespace bole::survey
