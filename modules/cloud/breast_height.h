// The height above ground at which the diameters of a stem table are measured.
#pragma once

#include "cloud/table.h"

namespace bole {
inline namespace cloud {

constexpr double usual_breast_height_m = 1.3;  // 1.37 in North America, 1.4 in New Zealand

// The fact `breast_height_m` of a stem table; the usual one where it has none, as field lists have. Throws
// Error{bad_input} for a fact that is no such height.
double breast_height_m(const Table& stems);
void set_breast_height_m(Table& stems, double height_m);

}  // namespace cloud
}  // namespace bole
