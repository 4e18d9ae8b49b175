#include "base/arrays.h"

#include <algorithm>
#include <array>

namespace bole {
inline namespace base {

std::span<const ArrayInfo> array_vocabulary() {
  using namespace arrays;
  static constexpr std::array all{intensity,  time,         range,           ring,          pass,
                                  keyframe,   sensor_x,     sensor_y,        sensor_z,      height_above_ground,
                                  tree_id,    stem,         classification,  return_number, number_of_returns,
                                  scan_angle, user_data,    point_source_id, red,           green,
                                  blue,       near_infrared};
  return all;
}

const ArrayInfo* find_array(std::string_view name) {
  const auto all = array_vocabulary();
  const auto it = std::ranges::find(all, name, &ArrayInfo::name);
  return it == all.end() ? nullptr : &*it;
}

std::string_view array_type_name(ArrayType type) {
  switch (type) {
    case ArrayType::uint8:
      return "uint8";
    case ArrayType::uint16:
      return "uint16";
    case ArrayType::int32:
      return "int32";
    case ArrayType::float32:
      return "float32";
    case ArrayType::float64:
      return "float64";
  }
  return "";
}

}  // namespace base
}  // namespace bole
