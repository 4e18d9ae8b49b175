// The trees of several runs, matched with their references, in one table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {

// Stems that match nothing and do not count are not false: the column `counted` of `stems` tells where the boundary is
// not known.
void drop_uncounted(StemEvaluation& evaluation, const Table& stems);

// With dbh_lo_cm and dbh_hi_cm of the stems, which a table of matches does not have.
Table with_intervals(const Table& matches, const Table& stems);

struct ComparedTrees {
  std::int64_t run = 0;
  std::string name, plot, system, against;
  Table matches;  // from with_intervals()
};

// run, name, plot, system, against, kind, tree and ref_tree (as words; empty where there is none), x_m, y_m, ref_x_m,
// ref_y_m, dx_m, dy_m, dbh_cm, ref_dbh_cm, dbh_error_cm, dbh_lo_cm, dbh_hi_cm.
Table trees_table(const std::vector<ComparedTrees>& parts);

}  // namespace bole::evaluation
