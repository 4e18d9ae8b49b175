// Drawings as SVG elements inside a page: unlike pictures they can be clicked, and styled by the page.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "render/draw/color.h"

namespace bole::report {

// "#2b7a4b"
std::string css_color(const render::Color& color);

// "12.5": at most two decimals.
std::string svg_number(double value);

// The attribute d of a path through these points.
std::string svg_path(const std::vector<Eigen::Vector2d>& points, bool closed = false);

}  // namespace bole::report
