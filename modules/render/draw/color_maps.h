// The colour maps that a person can choose for numbers.
#pragma once

#include <string_view>
#include <vector>

#include "render/draw/color.h"

namespace bole::render {

std::vector<std::string_view> color_map_names();
const ColorMap* color_map_named(std::string_view name);  // null: there is none of that name

}  // namespace bole::render
