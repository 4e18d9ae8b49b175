// Axes of charts: nice tick values, a frame that maps data to the sheet, labels with units.
#pragma once

#include <string>
#include <vector>

#include "render/draw/canvas.h"

namespace bole::render {

struct Interval {
  double lo = 0, hi = 1;
  double length() const { return hi - lo; }
  Interval grown(double share) const { return {lo - share * length(), hi + share * length()}; }
};

struct Ticks {
  double step = 1;
  std::vector<double> at;
  std::vector<std::string> text;
};

// 1, 2 or 5 times a power of ten, so that `range` holds about `about` steps.
double nice_step(double length, int about);

// Ticks within the range, about `about` of them, each with the decimals its step needs and a real minus sign.
Ticks nice_ticks(const Interval& range, int about);

// The range widened to whole steps. An empty or NaN range becomes one around its middle.
Interval nice_interval(const Interval& range, int about);

// "12.3"; with a minus sign of its width. NaN is an en dash.
std::string fixed(double value, int decimals);

// A rectangle of the sheet that shows a rectangle of data, y upwards.
struct Frame {
  Box box;
  Interval x, y;
  Eigen::Vector2d map(double data_x, double data_y) const {
    return {box.x0 + (data_x - x.lo) / x.length() * box.width(), box.y1 - (data_y - y.lo) / y.length() * box.height()};
  }
  double mm_per_unit_x() const { return box.width() / x.length(); }
};

struct AxesStyle {
  std::string x_label, y_label;  // with their units: "Reference DBH (cm)"
  int x_ticks = 6, y_ticks = 6;  // about so many
  bool grid = true;
  bool frame = false;  // a box all around instead of the left and lower axis
  bool x_axis = true;  // ticks and numbers below
  double size_pt = 7.5;
};

// Grid first: call it before the data is drawn.
void draw_grid(Canvas& canvas, const Frame& frame, const AxesStyle& style);
void draw_axes(Canvas& canvas, const Frame& frame, const AxesStyle& style);

// Space that draw_axes() needs outside the frame's box, for its labels.
inline constexpr double axis_space_left_mm = 14.5;
inline constexpr double axis_space_below_mm = 10.5;

}  // namespace bole::render
