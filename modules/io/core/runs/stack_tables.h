// Tables of several surveys in one.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/table.h"

namespace bole::io {

// The rows of all tables below each other, with a first column `run` that holds 1, 2, ... for the first, second, ...
// table. Columns that a table lacks are missing values (whole numbers become numbers there). A column that is words in
// one table is words in all. Null tables have no rows.
Table stack_tables(const std::vector<const Table*>& tables);

}  // namespace bole::io
