// The measures of a check, judged one by one.
#pragma once

#include "survey/core/check/check_findings.h"
#include "survey/core/check/check_grid.h"
#include "survey/core/check/check_options.h"
#include "survey/core/check/stem_measures.h"

namespace bole::survey {

struct CheckedMap {
  const CheckInputs& in;
  const CheckOptions& options;
  const CheckGrid& grid;
  const PlotArea& area;
  const CountingRule& rule;
  const std::vector<StemMeasure>& stems;
  Report& report;  // counts and metrics
};

// Ground never seen, holes, sparse cells, directions of view, lanes that were not walked.
void judge_cover(const CheckedMap& map, CheckFindings& findings);
// Passes that do not meet, on the ground and at stems; walls too thick; stems that stand there twice.
void judge_sharpness(const CheckedMap& map, CheckFindings& findings);
// Loop closures against the final trajectory.
void judge_loops(const CheckedMap& map, CheckFindings& findings);
// Common lean of the stems, targets and their distance, length of the walk.
void judge_axes(const CheckedMap& map, CheckFindings& findings);
// Pairs too close, stems without ground, heights without tops, structures without a stem.
void judge_stems(const CheckedMap& map, const std::vector<MissedStem>& missed, CheckFindings& findings);
// Trees at the boundary. The table: tree_id, x_m, y_m, dbh_cm, inside_m (distance to the boundary, negative outside),
// in (by the rule that is chosen), in_doubt, and the rule itself.
Table judge_boundary(const CheckedMap& map, CheckFindings& findings);

}  // namespace bole::survey
