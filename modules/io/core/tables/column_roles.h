// What a column of a trajectory with a header line holds, by its name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace bole::io::named {

// matrix: the first of the twelve numbers pose00 ... pose23.
enum Role { time_role, time_part, x, y, z, qw, qx, qy, qz, matrix, longitude = matrix + 12, latitude, role_count };

struct ColumnRole {
  int role;
  double factor = 1;  // brings a value to seconds, metres or degrees
};

// Nothing where the name, or its unit in brackets, says nothing of time or place.
std::optional<ColumnRole> role_of(std::string_view word);

// Letters and digits alone, in lower case.
std::string letters_of(std::string_view word);

// A column with the part of a time below a second or so, beside one of whole seconds; 0: none.
double part_factor(std::string_view word);
bool counts_seconds(std::string_view word);

}  // namespace bole::io::named
