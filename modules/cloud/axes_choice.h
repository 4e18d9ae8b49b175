// The words of Axes, for options that name them.
#pragma once

#include <array>
#include <string_view>

#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

constexpr std::array<std::string_view, 5> choice_names(Axes) { return {"unknown", "sensor", "map", "plot", "global"}; }

}  // namespace cloud
}  // namespace bole
