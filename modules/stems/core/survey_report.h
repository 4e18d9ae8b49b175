// The order of the stems of a survey, and what it reports.
#pragma once

#include <cstddef>

#include "stems/core/measure_stems.h"

namespace bole::stems {

// Ids of the stems from 1, from north to south, west to east where level. Rejected candidates in the same order.
void number(StemSurvey& survey);

struct SurveyFacts {
  std::size_t layer_points = 0, circles = 0, candidates = 0;
  bool rays_known = false, along_rays = false;
  double moved_m = 0;  // by which passes were brought together
  double noise_m = 0;  // scatter of ranges on the bark, middle of the stems; 0: not known
};

// Counts, facts, message and findings. Where there are no stems: what was looked at, and what to change.
void report_survey(StemSurvey& survey, const SurveyFacts& facts, const MeasureOptions& options);

}  // namespace bole::stems
