#include "survey/core/plot_options.h"

#include "base/angles.h"

namespace bole::survey {

const OptionTable& option_table(const PlotOptions*) {
  using S = PlotOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, PlotShape>{"shape", &S::shape, Tier::basic,
                           "Boundary of the plot. auto: the polygon where vertices are connected, the rectangle where "
                           "the map lies in plot axes (targets were found), else none."},
      Option<S, double>{"width",
                        &S::width,
                        Unit::metre,
                        {1, 10000},
                        Tier::basic,
                        "Extent of a rectangle in x (east; across its bearing), horizontal."},
      Option<S, double>{"length",
                        &S::length,
                        Unit::metre,
                        {1, 10000},
                        Tier::basic,
                        "Extent of a rectangle in y (north; along its bearing), horizontal."},
      Option<S, double>{"radius", &S::radius, Unit::metre, {1, 10000}, Tier::basic, "Radius of a circle, horizontal."},
      Option<S, double>{"x",
                        &S::x,
                        Unit::metre,
                        {-1e8, 1e8},
                        Tier::advanced,
                        "x of the centre of a rectangle or circle, in the axes of the stems."},
      Option<S, double>{"y",
                        &S::y,
                        Unit::metre,
                        {-1e8, 1e8},
                        Tier::advanced,
                        "y of the centre of a rectangle or circle, in the axes of the stems."},
      Option<S, double>{"bearing",
                        &S::bearing_deg,
                        Unit::degree,
                        {-360, 360},
                        Tier::advanced,
                        "Direction of a rectangle's length, clockwise from y (north)."},
      Option<S, double>{"min_dbh",
                        &S::min_dbh_cm,
                        Unit::centimetre,
                        {0, 200},
                        Tier::basic,
                        "Trees of this diameter at breast height and more count."},
      OnlyIf{"shape", {"auto", "rectangle"}, {"width", "length", "bearing"}},
      OnlyIf{"shape", {"circle"}, {"radius"}},
      OnlyIf{"shape", {"auto", "rectangle", "circle"}, {"x", "y"}},
  });
  return table;
}

CountingRule counting_rule_for(const PlotOptions& options, Axes axes, const Table* vertices) {
  CountingRule rule;
  rule.min_dbh_cm = options.min_dbh_cm;
  PlotShape shape = options.shape;
  if (shape == PlotShape::automatic)
    shape = vertices != nullptr ? PlotShape::polygon : axes == Axes::plot ? PlotShape::rectangle : PlotShape::none;
  if (shape == PlotShape::rectangle)
    rule.area = rectangle_area({options.x, options.y}, options.width, options.length, radians(options.bearing_deg));
  if (shape == PlotShape::circle) rule.area = circle_area({options.x, options.y}, options.radius);
  if (shape == PlotShape::polygon) {
    if (vertices == nullptr)
      throw bad_input("shape is polygon and no vertices are connected", "a table of x_m and y_m",
                      "Connect the input 'vertices' to a stage io.read_table");
    const auto x = vertices->numbers("x_m"), y = vertices->numbers("y_m");
    std::vector<Eigen::Vector2d> outline;
    for (std::size_t i = 0; i < x.size(); ++i) outline.emplace_back(x[i], y[i]);
    rule.area = polygon_area(std::move(outline));
  }
  return rule;
}

}  // namespace bole::survey
