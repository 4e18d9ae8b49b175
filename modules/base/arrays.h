// The one vocabulary of per-point arrays. Stages declare what they require and produce in these names; files are read
// into them and written from them.
#pragma once

#include <span>
#include <string_view>

#include "base/units.h"

namespace bole {
inline namespace base {

enum class ArrayType { uint8, uint16, int32, float32, float64 };

struct ArrayInfo {
  std::string_view name;
  ArrayType type;
  Unit unit;
  std::string_view meaning;
};

namespace arrays {
inline constexpr ArrayInfo intensity{
    "intensity", ArrayType::float32, Unit::none,
    "Return strength as the sensor or file gives it (Velodyne: 0 to 255, above 100 retro-reflective)."};
inline constexpr ArrayInfo time{"time", ArrayType::float64, Unit::second,
                                "Time of the return: seconds since the Unix epoch, GPS time, or since the start of the "
                                "scan, as the source gives it."};
inline constexpr ArrayInfo range{"range", ArrayType::float32, Unit::metre,
                                 "Distance from the sensor when the return was measured."};
inline constexpr ArrayInfo ring{"ring", ArrayType::uint16, Unit::none,
                                "Scan line of a multi-line sensor, counted from the lowest elevation upwards, from 0."};
inline constexpr ArrayInfo pass{"pass", ArrayType::int32, Unit::none,
                                "Stretch of the walk between two visits of the same place, from 0."};
inline constexpr ArrayInfo keyframe{"keyframe", ArrayType::int32, Unit::none,
                                    "Key frame that the point was mapped with, from 0."};
inline constexpr ArrayInfo sensor_x{
    "sensor_x", ArrayType::float32, Unit::metre,
    "Sensor position when the return was measured, x in the frame and offset of the cloud."};
inline constexpr ArrayInfo sensor_y{
    "sensor_y", ArrayType::float32, Unit::metre,
    "Sensor position when the return was measured, y in the frame and offset of the cloud."};
inline constexpr ArrayInfo sensor_z{
    "sensor_z", ArrayType::float32, Unit::metre,
    "Sensor position when the return was measured, z in the frame and offset of the cloud."};
inline constexpr ArrayInfo height_above_ground{"height_above_ground", ArrayType::float32, Unit::metre,
                                               "Height above the terrain model below the point."};
inline constexpr ArrayInfo tree_id{"tree_id", ArrayType::int32, Unit::none,
                                   "Tree the point belongs to, from 1; 0: none."};
inline constexpr ArrayInfo stem{"stem", ArrayType::uint8, Unit::none,
                                "1 where the point was used as bark in a stem fit."};
inline constexpr ArrayInfo classification{
    "classification", ArrayType::uint8, Unit::none,
    "ASPRS class: 1 unassigned, 2 ground, 3 to 5 low to high vegetation, 7 low noise, 18 high noise."};
inline constexpr ArrayInfo return_number{"return_number", ArrayType::uint8, Unit::none,
                                         "Number of the return within its pulse, from 1."};
inline constexpr ArrayInfo number_of_returns{"number_of_returns", ArrayType::uint8, Unit::none,
                                             "Returns of the pulse."};
inline constexpr ArrayInfo scan_angle{"scan_angle", ArrayType::float32, Unit::degree,
                                      "Scan angle as the file gives it."};
inline constexpr ArrayInfo user_data{"user_data", ArrayType::uint8, Unit::none, "User data byte of a LAS point."};
inline constexpr ArrayInfo point_source_id{"point_source_id", ArrayType::uint16, Unit::none,
                                           "Point source (flight line) of a LAS point."};
inline constexpr ArrayInfo red{"red", ArrayType::uint16, Unit::none, "Red, 0 to 65535."};
inline constexpr ArrayInfo green{"green", ArrayType::uint16, Unit::none, "Green, 0 to 65535."};
inline constexpr ArrayInfo blue{"blue", ArrayType::uint16, Unit::none, "Blue, 0 to 65535."};
inline constexpr ArrayInfo near_infrared{"near_infrared", ArrayType::uint16, Unit::none, "Near infrared, 0 to 65535."};
}  // namespace arrays

// All of them, in the order above.
std::span<const ArrayInfo> array_vocabulary();

// The entry of that name, or nullptr.
const ArrayInfo* find_array(std::string_view name);

std::string_view array_type_name(ArrayType type);

}  // namespace base
}  // namespace bole
