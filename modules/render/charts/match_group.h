// Matched trees of one run or system: a series of a figure that compares several.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "cloud/table.h"
#include "render/draw/color.h"

namespace bole::render {

struct MatchGroup {
  std::string name;  // empty for a figure of one series
  Color color;
  const Table* matches = nullptr;  // as the evaluation gives it
};

// The colours of the series in their order: the same in all figures of a comparison. The first is red and the second
// blue, as in the paper on improved LOAM.
inline Color series_color(std::size_t index) {
  constexpr std::array colors{ink::poor, ink::primary, ink::good, ink::fair, hex(0x7b4ea3), ink::axis};
  return colors[index % colors.size()];
}

}  // namespace bole::render
