#include "render/draw/screen_look.h"

#include <cairo.h>

#include <utility>

namespace bole::render {
namespace {

const cairo_user_data_key_t look_key{};

}  // namespace

void set_look(cairo_t* cairo, const ScreenLook& look) {
  cairo_set_user_data(cairo, &look_key, const_cast<ScreenLook*>(&look), nullptr);
}

const ScreenLook* look_of(cairo_t* cairo) {
  return static_cast<const ScreenLook*>(cairo_get_user_data(cairo, &look_key));
}

Color on_dark(const Color& color) {
  const std::pair<Color, Color> inks[] = {{ink::text, hex(0xe4e6e8)},    {ink::muted, hex(0xa8b0b6)},
                                          {ink::axis, hex(0xc3cace)},    {ink::grid, hex(0x3a4046)},
                                          {ink::paper, hex(0x1e1e20)},   {ink::path, hex(0x6db3e0)},
                                          {ink::primary, hex(0x6db3e0)}, {ink::good, hex(0x57b37c)},
                                          {ink::poor, hex(0xe0625a)},    {ink::accent, hex(0xff7183)}};
  for (const auto& [white, black] : inks)
    if (white.r == color.r && white.g == color.g && white.b == color.b) return black.with_alpha(color.a);
  return color;
}

}  // namespace bole::render
