// Two surveys of one plot: growth of every tree, and what came and went between them.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "survey/core/revisit/revisit_options.h"

namespace bole::survey {

struct Revisit {
  // A row per tree, in the axes of the first survey: tree_id, tree_id_second, kind, why, x_m, y_m, dbh1_cm, dbh2_cm,
  // growth_cm, growth_lo_cm, growth_hi_cm, growth_cm_per_year (and _lo_, _hi_), change (grew, shrank, none), ingrowth,
  // distance_m. Kinds: matched; ingrowth, missed_in_first, outside_first, duplicate_second (in the second survey only);
  // gone, missed_in_second, below_in_second, outside_second, duplicate_first (in the first one only).
  Table growth;
  Table values;  // measure, value, unit, lo, hi: of the stand
  Report report;
};

// `first_rejected` and `second_rejected` (x_m, y_m; may be null): candidates that the surveys rejected. A tree that one
// survey lists and the other rejected was missed, not gone. Intervals are 95 %: those of the two diameters,
// independent. Throws Error{bad_input} where the maps cannot be brought together for certain, and for tables without
// x_m, y_m, dbh_cm.
Revisit revisit(const Table& first, const Table& second, const Table* first_rejected, const Table* second_rejected,
                const RevisitOptions& options, const Run& run);

}  // namespace bole::survey
