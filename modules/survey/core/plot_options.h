// Options of the plot: which trees count.
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"

namespace bole::survey {

enum class PlotShape { automatic, rectangle, circle, polygon, none };
constexpr std::array<std::string_view, 5> choice_names(PlotShape) {
  return {"auto", "rectangle", "circle", "polygon", "none"};
}

struct PlotOptions {
  PlotShape shape = PlotShape::automatic;
  double width = 32, length = 32;
  double radius = 15;
  double x = 0, y = 0;
  double bearing_deg = 0;
  double min_dbh_cm = 7.5;
};

const OptionTable& option_table(const PlotOptions*);

// What the options ask for. `axes` are those of the stems; `vertices` (columns x_m, y_m, in these axes) make the
// polygon, null when there are none. "auto": the polygon where vertices are given; else the rectangle in plot axes,
// whose origin is the centre target, and no boundary in all others. A plot's size is a design value: the measured
// distance of the targets does not set it. Throws Error{bad_input} for a polygon without vertices.
CountingRule counting_rule_for(const PlotOptions& options, Axes axes, const Table* vertices);

}  // namespace bole::survey
