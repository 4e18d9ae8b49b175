#include "render/draw/color_maps.h"

#include <algorithm>
#include <array>

namespace bole::render {
namespace {

// A. Mikhailov 2019, "Turbo, an improved rainbow colormap for visualization": eleven of its colours. Small steps are
// seen, but not by the colour-blind.
const ColorMap& turbo() {
  static const ColorMap map({hex(0x30123b), hex(0x4454c4), hex(0x4490fe), hex(0x1fc8de), hex(0x29efa2), hex(0x7dff56),
                             hex(0xc1f334), hex(0xf1ca3a), hex(0xfe922a), hex(0xea4f0d), hex(0x7a0403)});
  return map;
}

const ColorMap& grey() {
  static const ColorMap map({hex(0x202020), hex(0xe0e0e0)});
  return map;
}

struct NamedMap {
  std::string_view name;
  const ColorMap& (*map)();
};
constexpr std::array<NamedMap, 5> named_maps{{{"viridis", &ColorMap::viridis},
                                              {"cividis", &ColorMap::cividis},
                                              {"turbo", &turbo},
                                              {"grey", &grey},
                                              {"diverging", &ColorMap::diverging}}};

}  // namespace

std::vector<std::string_view> color_map_names() {
  std::vector<std::string_view> names;
  for (const auto& entry : named_maps) names.push_back(entry.name);
  return names;
}

const ColorMap* color_map_named(std::string_view name) {
  const auto found = std::ranges::find(named_maps, name, &NamedMap::name);
  return found == named_maps.end() ? nullptr : &found->map();
}

}  // namespace bole::render
