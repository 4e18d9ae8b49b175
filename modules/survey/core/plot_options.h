// Options of the plot: which trees count.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"

namespace bole::survey {

enum class PlotShape { automatic, rectangle, circle, polygon, none };
constexpr std::array<std::string_view, 5> choice_names(PlotShape) {
  return {"auto", "rectangle", "circle", "polygon", "none"};
}

// What is left open follows from the shape, from the other options, and from where the plot lies (PlotSite).
struct PlotOptions {
  PlotShape shape = PlotShape::automatic;
  std::optional<double> width, length, radius, x, y, bearing_deg;
  double min_dbh_cm = 7.5;
};

inline constexpr double usual_plot_width_m = 32, usual_plot_radius_m = 15;

// The fact of a table of the plot that holds PlacedPlot::assumed_size, and the remedy in words: "32 m x 32 m is assumed
// for the plot (set plot.width or plot.radius where it is another): "; empty without the fact.
inline constexpr const char* assumed_size_fact = "assumed_size";
std::string assumed_size_remedy(const Table& plot);

const OptionTable& option_table(const PlotOptions*);

// Where a plot may be centred that the options do not place, in the axes of the stems.
struct PlotSite {
  std::optional<Eigen::Vector2d> target;                        // the centre target, where it was found
  std::function<std::optional<Eigen::Vector2d>()> middle = {};  // of what was scanned; only asked for when needed
};

struct PlacedPlot {
  CountingRule rule;
  std::string centre;        // where the centre comes from, in words; empty without a boundary and for a polygon
  std::string assumed_size;  // "32 m x 32 m" where no option gives the size; empty where one does
};

// What the options ask for. `axes` are those of the stems; `vertices` (columns x_m, y_m, in these axes) make the
// polygon, null when there are none. Shape "auto": a circle where a radius is given, a rectangle where a width, length
// or bearing is, the polygon where vertices are given; else the usual rectangle in plot axes, whose origin is the
// centre target, and no boundary in all others. A plot's size is a design value: the measured distance of the targets
// does not set it. The centre is x and y where given, else the target, else the middle of what was scanned, else the
// origin. Throws Error{bad_input} that names the options which contradict one another or would have no effect, and for
// a polygon without vertices.
PlacedPlot placed_plot(const PlotOptions& options, Axes axes, const Table* vertices, const PlotSite& site = {});

// The same without the words.
CountingRule counting_rule_for(const PlotOptions& options, Axes axes, const Table* vertices, const PlotSite& site = {});

}  // namespace bole::survey
