// Facts about what heights are counted from.
#pragma once

#include <array>
#include <string_view>

#include "cloud/known_facts.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo height_reference{"height_reference", "", 0, 0,
                                           "What z is counted from; ground: z is the height above ground."};
inline constexpr FactInfo terrain{"terrain", "", 0, 0,
                                  "Source of the terrain below the heights: ground, feet, lowest or normalised."};

}  // namespace facts

// What the terrain was made of: ground that was seen, feet of stems where none was, the lowest points of the cloud, or
// the heights of a normalised cloud.
enum class TerrainSource { ground, feet, lowest, normalised };
constexpr std::array<std::string_view, 4> choice_names(TerrainSource) {
  return {"ground", "feet", "lowest", "normalised"};
}
}  // namespace cloud
}  // namespace bole
