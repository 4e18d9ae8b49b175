// Field lists come with columns and units of their own.
#pragma once

#include <string>

#include "cloud/table.h"

namespace bole::evaluation {

// The rows of `table` where a column has a value, with columns renamed and brought to the units that their names end
// in.
//
// `rows`: "COLUMN=VALUE", several with commas: all must hold; empty: every row. `columns`: "NAME=SOURCE" or
// "NAME=SOURCE:UNIT", several with commas, for example "x_m=E, y_m=N, dbh_cm=DIAM:mm, height_m=H:ft"; units mm, cm, dm,
// m, in, ft, deg, gon. A column that is not named stays as it is. Where x_m is absent and azimuth_deg (clockwise from
// north) and distance_m are there, both give x_m and y_m. Texts such as NA become NaN in columns that are named.
// Throws Error{bad_input} for words it cannot read and columns that are absent, with a list of those there are.
Table field_table(const Table& table, const std::string& columns, const std::string& rows);

}  // namespace bole::evaluation
