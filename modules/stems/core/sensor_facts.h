// What the cloud says of the sensor that it was measured with, in place of options that are left open.
#pragma once

#include "base/report.h"
#include "cloud/known_facts.h"
#include "stems/core/stem_options.h"

namespace bole::stems {

// Assumed where neither the options nor the cloud say it: those of the VLP-32C.
inline constexpr double assumed_beam_divergence_mrad = 3.0;
inline constexpr double assumed_beam_divergence_sd_mrad = 1.5;
inline constexpr double assumed_beam_aperture = 0.0095;
inline constexpr double assumed_range_noise = 0.012;

// Of the scale of residuals, in the noise of the ranges: they scatter by that and a little by poses and bark.
inline constexpr double cap_by_noise = 1.25;

// Standard deviation of what the lasers of a sensor measure too far together: their constants, some millimetres each,
// average out over many. Those of more than `enough_lasers` do not all meet the stems.
inline constexpr double range_offset_of_many_lasers = 0.0004, enough_lasers = 32;
double usual_range_offset_sd(double lasers);

// The options with the beam and the range noise filled in: from the options, else from the facts of the cloud, else
// assumed. The cap of the residuals' scale is raised for sensors that are noisier than it. The report names every value
// and its source (facts beam_divergence, beam_divergence_sd, beam_aperture, range_noise, range_offset_sd), and warns of
// an assumed beam where `along_rays`: the surface model does not use it.
MeasureOptions with_sensor(MeasureOptions options, const Facts& facts, bool along_rays, Report& report);

}  // namespace bole::stems
