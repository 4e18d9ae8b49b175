// Tree ids that begin with the trees of the plot.
#pragma once

#include <cstdint>
#include <map>

#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::stems {

// By old id the new one: 1 to n for the trees that count by the rule, then those inside that are too thin, then those
// outside; within each group from north to south, west to east where level. Empty where nothing changes, and where the
// ids of the table are no whole numbers or not one of a kind.
using NewIds = std::map<std::int64_t, std::int64_t>;
NewIds plot_first_ids(const Table& stems, const CountingRule& rule);

// The table with its column tree_id renumbered, as it is where there is none.
Table renumbered(const Table& table, const NewIds& ids);

// The points with their column tree_id renumbered; 0 (no tree) and ids of no stem stay.
PointCloud renumbered(const PointCloud& points, const NewIds& ids, const Run& run);

}  // namespace bole::stems
