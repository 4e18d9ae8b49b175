#include "report/core/tally_page.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/angles.h"
#include "base/markup.h"
#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/look_list.h"
#include "report/core/page_resources.h"
#include "report/core/plan.h"

namespace bole::report {
namespace {

constexpr int empty_rows = 6;  // for trees that the survey does not have

struct Place {
  std::string first, second;
};

// Distance and bearing from the centre of the plot, else coordinates.
Place place_of(const SurveyData& d, double x, double y) {
  if (d.rule.area.shape == PlotArea::Shape::none) return {render::fixed(x, 2), render::fixed(y, 2)};
  const Eigen::Vector2d from_centre = Eigen::Vector2d(x, y) - d.rule.area.centre;
  double bearing_deg = degrees(std::atan2(from_centre.x(), from_centre.y()));
  if (bearing_deg < 0) bearing_deg += 360;
  return {render::fixed(from_centre.norm(), 1), render::fixed(bearing_deg, 0)};
}

HtmlTable rows_of(const SurveyData& d) {
  const Table stems = d.stems_in_plot();
  const bool polar = d.rule.area.shape != PlotArea::Shape::none;
  HtmlTable table{{{"Tree", true},
                   {polar ? "Distance (m)" : "x (m)", true},
                   {polar ? (d.north_known() ? "Bearing (°)" : "Angle from y (°)") : "y (m)", true},
                   {"Species"},
                   {"DBH by tape (cm)"},
                   {"Height (m)"},
                   {"Remarks"}},
                  {},
                  false};
  const auto x = numbers_or_nan(stems, "x_m"), y = numbers_or_nan(stems, "y_m"), id = numbers_or_nan(stems, "tree_id");
  std::vector<std::size_t> order(stems.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  const auto species = texts_or_empty(stems, "species");
  for (const auto i : order) {
    const auto place = place_of(d, x[i], y[i]);
    table.rows.push_back({tree_name(stems, i), place.first, place.second, species[i], "", "", ""});
  }
  for (int i = 0; i < empty_rows; ++i) table.rows.emplace_back(table.columns.size());
  return table;
}

}  // namespace

std::string tally_html(const std::string& title, const std::vector<std::pair<std::string, std::string>>& facts,
                       const SurveyData& d) {
  std::string out = page_head("Tally sheet: " + title, "page.css") +
                    "<main class=\"tally\">\n<h1>Tally sheet: " + escaped(title) + "</h1>\n<dl class=\"facts\">\n";
  for (const auto& [name, value] : facts)
    if (name == "Input" || name == "Recorded" || name == "Plot")
      out += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  out += "</dl>\n";
  const HtmlTable crew{{{"Crew"}, {"Date"}, {"Instruments"}}, {{"", "", ""}}, false};
  out += crew.html() + plan_html(d);
  const bool polar = d.rule.area.shape != PlotArea::Shape::none;
  out += paragraph(std::string("Print this page and fill it in. ") +
                       (polar ? "Distances and directions are horizontal, from the centre of the plot" +
                                    std::string(d.north_known() ? ", clockwise from grid north. " : ". ")
                              : "Coordinates are those of the stem table. ") +
                       "Diameters of the survey are left out so that the tape is read without them. The empty rows at "
                       "the end are for trees that the survey does not have. The filled table, typed into a file with "
                       "tree, x, y and dbh, can be compared with the survey (reference_trees.file).",
                   "note");
  return out + rows_of(d).html() + "</main>\n</body>\n</html>\n";
}

}  // namespace bole::report
