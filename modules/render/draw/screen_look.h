// How a figure looks on a screen: on dark paper, in another language. Files are made without: their paper is white,
// their words are English.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "render/draw/figure.h"

namespace bole::render {

struct ScreenLook {
  bool dark = false;                                   // the inks change places, other colours stay: see on_dark()
  std::function<std::string(std::string_view)> words;  // what is written in place of a text; null: the text
  std::string wide_font;                               // of texts with characters that Latin fonts lack
};

// figure_image() and figure_overlay() with a look.
Image screen_image(const Figure& figure, double dpi, const ScreenLook& look);
Image screen_overlay(const Figure& figure, double dpi, const ScreenLook& look);

// A look rides along with the context that a canvas draws through, which must not outlive it.
void set_look(cairo_t* cairo, const ScreenLook& look);
const ScreenLook* look_of(cairo_t* cairo);  // null: that of files

// The ink of dark paper in place of one of white paper; any other colour is left alone.
Color on_dark(const Color& color);

}  // namespace bole::render
