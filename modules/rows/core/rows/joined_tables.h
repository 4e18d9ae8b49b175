// Two tables one below the other.
#pragma once

#include "cloud/table.h"

namespace bole::rows {

// The rows of `a`, then those of `b`, with the columns of both; a cell that its table lacks is NaN, 0 or "". Columns of
// different types become numbers where both are numbers, else texts. Facts are those of `a`, then of `b`.
Table joined(const Table& a, const Table& b);

// The table with `count` more rows of NaN, 0 and "".
Table with_blank_rows(const Table& table, std::size_t count);

}  // namespace bole::rows
