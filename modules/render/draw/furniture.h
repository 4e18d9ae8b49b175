// What maps and legends are furnished with.
#pragma once

#include <string>
#include <vector>

#include "render/draw/axes.h"
#include "render/draw/canvas.h"

namespace bole::render {

// A slim arrow with an N above its tip. `angle_rad` turns it counter-clockwise from straight up.
void draw_north_arrow(Canvas& canvas, const Eigen::Vector2d& foot, double height_mm, double angle_rad = 0,
                      double halo_mm = 0);

// A bar of a nice length not longer than `max_mm`, with its length in metres; `at` is the left end of the bar's foot.
// Returns the length in millimetres.
double draw_scale_bar(Canvas& canvas, const Eigen::Vector2d& at, double mm_per_metre, double max_mm,
                      double halo_mm = 0);
double scale_bar_length_m(double mm_per_metre, double max_mm);

enum class Symbol { disc, ring, cross, line, dashed_line, square, triangle, star };

struct LegendEntry {
  Symbol symbol = Symbol::disc;
  Color color;
  std::string text;
};

void draw_symbol(Canvas& canvas, Symbol symbol, const Eigen::Vector2d& centre, double size_mm, const Color& color);

// Entries side by side in rows that fit the width, from the top left corner. Returns the height used in millimetres.
double draw_legend_row(Canvas& canvas, const Eigen::Vector2d& top_left, double width_mm,
                       const std::vector<LegendEntry>& entries, double size_pt = 7);

// Entries below one another in a box whose corner `corner` is at `at` (h, v as in text).
Box draw_legend_box(Canvas& canvas, const Eigen::Vector2d& at, HAlign h, VAlign v,
                    const std::vector<LegendEntry>& entries, double size_pt = 7);

// A vertical bar of the map with ticks on its right and a title above.
void draw_color_bar(Canvas& canvas, const Box& bar, const ColorMap& map, const Interval& range,
                    const std::string& title, double size_pt = 7);

}  // namespace bole::render
