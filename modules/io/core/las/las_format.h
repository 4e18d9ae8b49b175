// The fields of the LAS point formats 0 to 10 (ASPRS LAS Specification 1.4 R15, tables 7 to 17).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace bole::io::las {

// Byte offsets within a point record; -1 where the format has no such field. Formats 6 and up ("extended") hold
// four-bit return numbers, eight-bit classes and scan angles of 0.006 degrees.
struct PointLayout {
  int size = 0;
  bool extended = false;
  int time = -1;
  int colour = -1;  // red, green, blue
  int near_infrared = -1;
};

inline constexpr int max_point_format = 10;

// Of a format from 0 to max_point_format.
const PointLayout& point_layout(int format);

namespace field {
inline constexpr std::size_t x = 0, y = 4, z = 8, intensity = 12, returns = 14;
// Formats 0 to 5: the class and its flags share a byte.
namespace legacy {
inline constexpr std::size_t classification = 15, scan_angle = 16, user_data = 17, point_source_id = 18;
}
// Formats 6 to 10.
namespace extended {
inline constexpr std::size_t flags = 15, classification = 16, user_data = 17, scan_angle = 18, point_source_id = 20;
}
}  // namespace field

// Degrees per unit of the scan angle of formats 6 and up.
inline constexpr double scan_angle_step_deg = 0.006;

// Point flags as columns of 0 and 1 (scanner_channel: 0 to 3). A cloud has only those that are set for some point.
struct FlagColumn {
  const char* name;
  unsigned shift, mask;
};
// Places in the flag byte of formats 6 to 10.
inline constexpr std::array<FlagColumn, 7> flag_columns{{{"synthetic", 0, 1},
                                                         {"key_point", 1, 1},
                                                         {"withheld", 2, 1},
                                                         {"overlap", 3, 1},
                                                         {"scanner_channel", 4, 3},
                                                         {"scan_direction", 6, 1},
                                                         {"edge_of_flight_line", 7, 1}}};

inline bool is_flag_column(std::string_view name) {
  return std::ranges::any_of(flag_columns, [&](const FlagColumn& flag) { return flag.name == name; });
}

}  // namespace bole::io::las
