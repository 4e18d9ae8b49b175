// The sensor position at the time of each point: three columns. In memory it is relative to the cloud's origin, in
// files it is a coordinate like that of the point.
#pragma once

#include <array>
#include <string_view>

#include "base/arrays.h"

namespace bole::io {

inline constexpr std::array<ArrayInfo, 3> sensor_arrays{arrays::sensor_x, arrays::sensor_y, arrays::sensor_z};

// 0 to 2, or -1 for other columns.
inline int axis_of_sensor(std::string_view column) {
  for (std::size_t axis = 0; axis < sensor_arrays.size(); ++axis)
    if (sensor_arrays[axis].name == column) return static_cast<int>(axis);
  return -1;
}

}  // namespace bole::io
