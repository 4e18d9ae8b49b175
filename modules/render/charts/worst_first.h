// In which order stems deserve a look.
#pragma once

#include <vector>

#include "cloud/table.h"

namespace bole::render {

// Rows of a stem table, the least trustworthy diameter first: poor, fair, good; within these the widest 95 % interval
// relative to the diameter, one without an interval before all others.
std::vector<std::size_t> worst_first(const Table& stems);

}  // namespace bole::render
