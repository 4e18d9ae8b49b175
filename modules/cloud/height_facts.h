// Facts about what heights are counted from.
#pragma once

#include "cloud/known_facts.h"

namespace bole {
inline namespace cloud {
namespace facts {

inline constexpr FactInfo height_reference{"height_reference", "", 0, 0,
                                           "What z is counted from; ground: z is the height above ground."};
inline constexpr FactInfo terrain{"terrain", "", 0, 0,
                                  "Source of the terrain below the heights: ground, feet, lowest or normalised."};

}  // namespace facts
}  // namespace cloud
}  // namespace bole
