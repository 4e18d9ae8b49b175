// Points given to trees once stems were added, moved, merged or deleted.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/edits/give_points.h"
#include "stems/core/edits/table_rows.h"

namespace bole::stems {

// The measurement gave points to the trees that it found; here they go to all that there are now, trees that a person
// added among them. These get the height of their points where nobody gave them one. `measured`: trees before the
// edits of stems; a tree of theirs that is gone is no conflict, what was made of it took its points along. Every edit
// gets a row in `log` (tree_id, x_m, y_m, action, outcome, message, author, time, reason), and what cannot be applied
// is told in `report`.
PointCloud give_edited_points(const PointCloud& points, const Table& point_edits,
                              const std::vector<TreePlace>& measured, TableRows& stems, TableRows& log, Report& report,
                              const Run& run);

// The trees of a table, where they stand.
std::vector<TreePlace> places_of(const TableRows& stems);

}  // namespace bole::stems
