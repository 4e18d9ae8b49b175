#include "survey/core/plot_options.h"

#include <fmt/format.h>

#include <vector>

#include "base/angles.h"

namespace bole::survey {

namespace {
void check_together(const PlotOptions& o);
}

const OptionTable& option_table(const PlotOptions*) {
  using S = PlotOptions;
  static const OptionTable table = make_option_table<S>(
      {
          Option<S, PlotShape>{
              "shape", &S::shape, Tier::basic,
              "Boundary of the plot. auto: a circle where a radius is given, a rectangle where a width, "
              "length or bearing is, the polygon where vertices are connected, the usual rectangle where "
              "the map lies in plot axes (targets were found), else none."},
          Option<S, std::optional<double>>{
              "width",
              &S::width,
              Unit::metre,
              {1, 10000},
              "auto",
              Tier::basic,
              "Extent of a rectangle in x (east; across its bearing), horizontal. auto: the "
              "length, or 32 m where that is open too."},
          Option<S, std::optional<double>>{
              "length",
              &S::length,
              Unit::metre,
              {1, 10000},
              "auto",
              Tier::basic,
              "Extent of a rectangle in y (north; along its bearing), horizontal. auto: the "
              "width, or 32 m where that is open too."},
          Option<S, std::optional<double>>{"radius",
                                           &S::radius,
                                           Unit::metre,
                                           {1, 10000},
                                           "auto",
                                           Tier::basic,
                                           "Radius of a circle, horizontal. auto: 15 m."},
          Option<S, std::optional<double>>{
              "x",
              &S::x,
              Unit::metre,
              {-1e8, 1e8},
              "auto",
              Tier::advanced,
              "x of the centre of a rectangle or circle, in the axes of the stems. auto: the "
              "centre target where it was found, else the middle of what was scanned."},
          Option<S, std::optional<double>>{
              "y",
              &S::y,
              Unit::metre,
              {-1e8, 1e8},
              "auto",
              Tier::advanced,
              "y of the centre of a rectangle or circle, in the axes of the stems. auto: as x."},
          Option<S, std::optional<double>>{"bearing",
                                           &S::bearing_deg,
                                           Unit::degree,
                                           {-360, 360},
                                           "auto",
                                           Tier::advanced,
                                           "Direction of a rectangle's length, clockwise from y (north). auto: 0."},
          Option<S, double>{"min_dbh",
                            &S::min_dbh_cm,
                            Unit::centimetre,
                            {0, 200},
                            Tier::basic,
                            "Trees of this diameter at breast height and more count."},
          OnlyIf{"shape", {"auto", "rectangle"}, {"width", "length", "bearing"}},
          OnlyIf{"shape", {"auto", "circle"}, {"radius"}},
          OnlyIf{"shape", {"auto", "rectangle", "circle"}, {"x", "y"}},
      },
      check_together);
  return table;
}

namespace {

using Names = std::vector<std::string>;

// "width, length and x"
std::string listed(const Names& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return text;
}

struct GivenOptions {
  Names rectangle, circle, centre;
  explicit GivenOptions(const PlotOptions& o) {
    if (o.width) rectangle.emplace_back("width");
    if (o.length) rectangle.emplace_back("length");
    if (o.bearing_deg) rectangle.emplace_back("bearing");
    if (o.radius) circle.emplace_back("radius");
    if (o.x) centre.emplace_back("x");
    if (o.y) centre.emplace_back("y");
  }
};

void refuse(const Names& without_effect, const std::string& why) {
  if (without_effect.empty()) return;
  const bool one = without_effect.size() == 1;
  throw bad_input("plot option" + std::string(one ? " " : "s ") + listed(without_effect) + (one ? " is" : " are") +
                      " given and " + why,
                  "plot options that go together: shape circle with radius, x and y; shape rectangle with width, "
                  "length, bearing, x and y; shape polygon with vertices; shape none alone",
                  "Leave out " + listed(without_effect) + ", or give another shape");
}

PlotShape chosen_shape(const PlotOptions& o, const GivenOptions& given, Axes axes, const Table* vertices) {
  if (o.shape != PlotShape::automatic) return o.shape;
  if (!given.circle.empty() && !given.rectangle.empty()) {
    Names all = given.circle;
    all.insert(all.end(), given.rectangle.begin(), given.rectangle.end());
    refuse(all, "belong to different shapes, a circle and a rectangle");
  }
  if (vertices != nullptr) return PlotShape::polygon;
  if (!given.circle.empty()) return PlotShape::circle;
  if (!given.rectangle.empty() || axes == Axes::plot) return PlotShape::rectangle;
  refuse(given.centre, "the plot has no size");
  return PlotShape::none;
}

void check_effects(const GivenOptions& given, PlotShape shape) {
  const std::string name = "the plot is a " + std::string(choice_name(shape));
  if (shape == PlotShape::rectangle) return refuse(given.circle, name);
  if (shape == PlotShape::circle) return refuse(given.rectangle, name);
  Names all = given.rectangle;
  all.insert(all.end(), given.circle.begin(), given.circle.end());
  all.insert(all.end(), given.centre.begin(), given.centre.end());
  refuse(all, shape == PlotShape::polygon ? name + " whose vertices are connected" : "shape is none");
}

// What contradicts itself whatever was scanned is refused before anything runs.
void check_together(const PlotOptions& o) {
  const GivenOptions given(o);
  if (o.shape != PlotShape::automatic) return check_effects(given, o.shape);
  if (!given.circle.empty() && !given.rectangle.empty()) chosen_shape(o, given, Axes::unknown, nullptr);
}

PlotArea polygon_of(const Table* vertices) {
  if (vertices == nullptr)
    throw bad_input("shape is polygon and no vertices are connected", "a table of x_m and y_m",
                    "Connect the input 'vertices' to a stage io.read_table");
  const auto x = vertices->numbers("x_m"), y = vertices->numbers("y_m");
  std::vector<Eigen::Vector2d> outline;
  for (std::size_t i = 0; i < x.size(); ++i) outline.emplace_back(x[i], y[i]);
  return polygon_area(std::move(outline));
}

// The centre, and in `words` where it comes from.
Eigen::Vector2d centre_of(const PlotOptions& o, Axes axes, const PlotSite& site, std::string& words) {
  if (o.x && o.y) {
    words = "the options x and y";
    return {*o.x, *o.y};
  }
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  words = "the origin";
  if (axes == Axes::plot || site.target) {
    centre = axes == Axes::plot ? centre : *site.target;
    words = "the centre target";
  } else if (const auto middle = site.middle ? site.middle() : std::nullopt) {
    centre = *middle;
    words = "the middle of what was scanned";
  }
  if (o.x || o.y) words = std::string(o.x ? "option x and y of " : "option y and x of ") + words;
  return {o.x.value_or(centre.x()), o.y.value_or(centre.y())};
}

}  // namespace

PlacedPlot placed_plot(const PlotOptions& o, Axes axes, const Table* vertices, const PlotSite& site) {
  PlacedPlot plot;
  plot.rule.min_dbh_cm = o.min_dbh_cm;
  const GivenOptions given(o);
  const PlotShape shape = chosen_shape(o, given, axes, vertices);
  check_effects(given, shape);
  if (shape == PlotShape::polygon) plot.rule.area = polygon_of(vertices);
  if (shape == PlotShape::polygon || shape == PlotShape::none) return plot;

  const auto centre = centre_of(o, axes, site, plot.centre);
  if (shape == PlotShape::circle) {
    plot.rule.area = circle_area(centre, o.radius.value_or(usual_plot_radius_m));
    if (!o.radius) plot.assumed_size = fmt::format("a radius of {} m", usual_plot_radius_m);
  } else {
    const double width = o.width.value_or(o.length.value_or(usual_plot_width_m));
    plot.rule.area = rectangle_area(centre, width, o.length.value_or(width), radians(o.bearing_deg.value_or(0)));
    if (!o.width && !o.length) plot.assumed_size = fmt::format("{0} m x {0} m", usual_plot_width_m);
  }
  return plot;
}

std::string assumed_size_remedy(const Table& plot) {
  const auto it = plot.facts.find(assumed_size_fact);
  return it == plot.facts.end()
             ? std::string()
             : it->second + " is assumed for the plot (set plot.width or plot.radius where it is another): ";
}

CountingRule counting_rule_for(const PlotOptions& options, Axes axes, const Table* vertices, const PlotSite& site) {
  return placed_plot(options, axes, vertices, site).rule;
}

}  // namespace bole::survey
