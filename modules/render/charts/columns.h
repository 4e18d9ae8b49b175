// Columns of tables that a figure can do without, under the names that charts use.
#pragma once

#include "cloud/table_columns.h"

namespace bole::render {

using bole::numbers_or_nan;
using bole::texts_or_empty;

}  // namespace bole::render
