#include "report/report_options.h"

namespace bole::report {

const OptionTable& option_table(const ReportOptions*) {
  using S = ReportOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, std::string>{"title", &S::title, TextKind::plain, {}, Tier::basic, "Title of the report."},
      Option<S, double>{"figure_width",
                        &S::figure_width,
                        Unit::millimetre,
                        {60, 800},
                        Tier::basic,
                        "Width of the large figures; charts are a little less than half as wide."},
      Option<S, double>{
          "dpi", &S::dpi, Unit::dot_per_inch, {50, 1200}, Tier::basic, "Resolution of the PNG figures for printing."},
      Option<S, int>{"point_budget",
                     &S::point_budget,
                     Unit::none,
                     {1000, 50000000},
                     Tier::advanced,
                     "Points drawn at most in each map; the cloud is thinned evenly in space."},
      Option<S, std::string>{"backend",
                             &S::backend,
                             TextKind::choice,
                             {"auto", "osmesa", "egl", "glx"},
                             Tier::expert,
                             "What draws the 3-D maps: osmesa in memory, egl on a graphics card, glx on an X display."},
      Option<S, bool>{"tables", &S::tables, Tier::basic,
                      "Write stems.csv and the other tables, trajectory.tum, dem.tif and plot.gpkg."},
      Option<S, bool>{"cloud", &S::cloud, Tier::basic, "Write the map with all its columns: cloud.laz."},
      Option<S, CloudFormat>{"cloud_format", &S::cloud_format, Tier::advanced,
                             "laz: cloud.laz, compressed. las: cloud.las, for programs that do not read LAZ. copc: "
                             "cloud.copc.laz, an octree of which programs load the part they show."},
      Option<S, bool>{"figures", &S::figures, Tier::basic, "Draw the figures."},
      Option<S, FigureSet>{
          "figure_set", &S::figure_set, Tier::basic,
          "page: the figures of report.html; all: also other views of the map and the slice sheet, each "
          "figure as PNG, SVG and PDF for printing (takes much longer)."},
      Option<S, bool>{"hero", &S::hero, Tier::expert,
                      "Draw figures/hero.png too, a picture for a title page: the fitted stems and the walk on a dark "
                      "ground, 1600 pixels wide."},
      Option<S, bool>{"vector_figures", &S::vector_figures, Tier::advanced,
                      "Write charts and plans as SVG and PDF too."},
      Option<S, bool>{"page", &S::page, Tier::basic, "Write report.html."},
      OnlyIf{"cloud", {"true"}, {"cloud_format"}},
      OnlyIf{"figures", {"true"}, {"figure_set", "figure_width", "backend", "hero"}},
      OnlyIf{"figure_set", {"all"}, {"dpi", "point_budget", "vector_figures"}},
  });
  return table;
}

}  // namespace bole::report
