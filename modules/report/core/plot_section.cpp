#include "report/core/plot_section.h"

#include <algorithm>
#include <cmath>

#include "base/markup.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/value_rows.h"

namespace bole::report {
namespace {

std::string classes_html(const Table& classes, bool per_ha, bool with_heights) {
  const auto lo = classes.numbers("min_dbh_cm"), hi = classes.numbers("max_dbh_cm"), stems = classes.numbers("stems"),
             stems_per_ha = classes.numbers("stems_per_ha"), area = classes.numbers("basal_area_m2"),
             area_per_ha = classes.numbers("basal_area_m2_per_ha"), height = classes.numbers("mean_height_m");
  if (lo.empty()) return {};
  HtmlTable table{{{"DBH class (cm)"}, {"Stems", true}}, {}, false};
  if (per_ha) table.columns.push_back({"1/ha", true});
  table.columns.push_back({per_ha ? "Basal area (m²/ha)" : "Basal area (m²)", true});
  if (with_heights) table.columns.push_back({"Mean height of tops seen (m)", true});
  const auto whole = [](double v) { return v == std::round(v); };
  const int decimals = std::ranges::all_of(lo, whole) && std::ranges::all_of(hi, whole) ? 0 : 1;
  for (std::size_t i = 0; i < lo.size(); ++i) {
    std::vector<std::string> row{render::fixed(lo[i], decimals) + "–" + render::fixed(hi[i], decimals),
                                 render::fixed(stems[i], 0)};
    if (per_ha) row.push_back(render::fixed(stems_per_ha[i], 0));
    row.push_back(per_ha ? render::fixed(area_per_ha[i], 2) : render::fixed(area[i], 3));
    if (with_heights) row.push_back(render::fixed(height[i], 1));
    table.rows.push_back(std::move(row));
  }
  return "<h3>By diameter class</h3>\n" + table.html();
}

}  // namespace

std::string plot_section(const SurveyData& data) {
  if (data.plot_values == nullptr)
    return section("plot", "The plot",
                   paragraph("There are no values of the plot: the stage inventory.plot_values is not part of this "
                             "pipeline. Add it and connect its plot_values, diameter_classes and height_curve to the "
                             "report, or start from one of the pipelines that come with Bole.",
                             "note"));
  const PlotValues values(*data.plot_values);
  const bool bounded = values.given("area");
  HtmlTable table{{{"Measure"}, {"Value", true}, {"Unit"}, {"How"}}, {}, false};
  for (const auto& row : value_rows(values, data.height_curve))
    table.rows.push_back({row.name, row.value, row.unit, row.how});
  std::string body;
  if (!bounded)
    body = paragraph(
        "No plot boundary is set, so there are no values per hectare. Where the plot is known, give its shape and its "
        "width and length, or its radius (stage survey.plot: plot.shape=circle plot.radius=...).",
        "note");
  body += table.html();
  if (data.diameter_classes != nullptr)
    body += classes_html(*data.diameter_classes, bounded, values.given("mean_height"));
  return section("plot", "The plot", body);
}

}  // namespace bole::report
