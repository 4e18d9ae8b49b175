// Thousands of dots on a picture of pixels at once.
#pragma once

#include <Eigen/Core>
#include <span>

#include "render/draw/color.h"

typedef struct _cairo cairo_t;  // NOLINT(clang-diagnostic-reserved-identifier): the library's name

namespace bole::render {

// Draws round dots of one colour, in user space, where the target is a picture of pixels that is neither turned nor
// stretched; false, and nothing drawn, where it is not. Where cairo takes 35 ms for a stroke of up to 20 000 dots this
// takes 1 to 2 ms; pixels differ by the eighth of a pixel that places are rounded to, and where dots overlap on an
// edge.
bool draw_dot_mask(cairo_t* cairo, std::span<const Eigen::Vector2d> centres, double diameter, const Color& color);

}  // namespace bole::render
