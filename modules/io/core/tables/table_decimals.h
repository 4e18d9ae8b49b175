// How many digits the tables of a survey are written with.
#pragma once

#include <string_view>

#include "io/core/tables/table_file.h"

namespace bole::io {

// Digits that mean something: a tenth of a millimetre in position, a tenth of a millimetre in diameter.
const Decimals& table_decimals();

// Of one column; -1 (as the number is) for a column that is not listed.
int decimals_of(std::string_view column);

}  // namespace bole::io
