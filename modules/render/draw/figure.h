// A figure: a sheet of fixed size in millimetres and a function that draws on it; comes out as PNG, SVG and PDF.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/draw/canvas.h"

namespace bole::render {

inline constexpr double mm_per_inch = 25.4;

struct Figure {
  std::string name;     // file name without ending: "stem_map"
  std::string title;    // of the report's heading
  std::string caption;  // one or two sentences below it; says what is shown and in which units
  double width_mm = 0, height_mm = 0;
  bool vector = true;  // false: mostly a picture, worth no SVG and PDF
  std::function<void(Canvas&)> draw;
};

// The figure as pixels; width = round(width_mm / 25.4 dpi). Throws Error{bad_input} beyond 30 000 pixels a side.
Image figure_image(const Figure& figure, double dpi);

// The same without paper: transparent where nothing was drawn, to lie over a picture.
Image figure_overlay(const Figure& figure, double dpi);

// File contents. The PNG carries its resolution, so that it prints at its size.
std::string figure_png(const Figure& figure, double dpi);
std::string figure_svg(const Figure& figure);
std::string figure_pdf(const Figure& figure);

// A PNG of an image at a resolution.
std::string image_png(const Image& image, double dpi);

}  // namespace bole::render
