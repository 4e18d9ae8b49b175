// Two surveys of one plot beside each other: who grew, and what came and went.
#pragma once

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// The trees of survey.revisit (x_m, y_m, kind, growth_cm, change) at their places: the matched coloured by growth, the
// others by what became of them. Copies what it draws. Throws Error{bad_input} for a table without a tree.
Figure revisit_map(const Table& growth, bool north_known, double width_mm);

// Growth over the first diameter with 95 % intervals (dbh1_cm, growth_cm, growth_lo_cm, growth_hi_cm, change). Throws
// Error{bad_input} where no tree was found again.
Figure growth_chart(const Table& growth, double width_mm);

}  // namespace bole::render
