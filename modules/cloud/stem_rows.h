// Which rows of a stem table take part: those that a person did not reject, and of these the ones that a plot counts.
#pragma once

#include <cstddef>
#include <vector>

#include "cloud/plot_area.h"
#include "cloud/table.h"

namespace bole {
inline namespace cloud {

// Rows whose state is not "rejected"; all rows where the table has no states.
std::vector<std::size_t> kept_rows(const Table& stems);

// Kept rows with a finite dbh_cm that count by the rule. Needs x_m, y_m and dbh_cm.
std::vector<std::size_t> counted_rows(const Table& stems, const CountingRule& rule);

// The table with the column `counted`: 1 where the values of the plot rest on the stem, else 0. As it is where x_m, y_m
// or dbh_cm is missing or no number.
Table with_counted(Table stems, const CountingRule& rule);

// How high each tree is known to reach: height_m where its top was seen, else height_lower_bound_m; NaN where neither
// is there.
std::vector<double> known_heights(const Table& stems);

}  // namespace cloud
}  // namespace bole
