#include "report/place/place_section.h"

#include <cmath>

#include "cloud/table_columns.h"
#include "render/draw/axes.h"
#include "report/core/html.h"
#include "report/core/survey_facts.h"

namespace bole::report {
namespace {

std::string number_or_dash(double value, int decimals) {
  return std::isfinite(value) ? render::fixed(value, decimals) : "–";
}

const Report* said(const RunRecord* record) {
  if (record == nullptr) return nullptr;
  for (const auto& stage : record->stages)
    if (stage.type == "survey.georeference") return &stage.report;
  return nullptr;
}

std::string residuals(const Table& control) {
  const auto names = texts_or_empty(control, "name"), notes = texts_or_empty(control, "note");
  const auto easting = numbers_or_nan(control, "easting_m"), northing = numbers_or_nan(control, "northing_m"),
             height = numbers_or_nan(control, "height_m"), east = numbers_or_nan(control, "residual_east_m"),
             north = numbers_or_nan(control, "residual_north_m"), up = numbers_or_nan(control, "residual_height_m"),
             misfit = numbers_or_nan(control, "misfit_m"), limit = numbers_or_nan(control, "misfit_limit_m"),
             used = numbers_or_nan(control, "used");
  HtmlTable table{{{"Control point"},
                   {"Easting (m)", true},
                   {"Northing (m)", true},
                   {"Height (m)", true},
                   {"Residual east (cm)", true},
                   {"north (cm)", true},
                   {"height (cm)", true},
                   {"Off the others (cm)", true},
                   {"Limit (cm)", true},
                   {""}},
                  {},
                  false};
  for (std::size_t i = 0; i < control.rows(); ++i) {
    const std::string note = !notes[i].empty() ? notes[i] : used[i] > 0 ? "" : "not used";
    table.rows.push_back({names[i], number_or_dash(easting[i], 3), number_or_dash(northing[i], 3),
                          number_or_dash(height[i], 3), number_or_dash(100 * east[i], 1),
                          number_or_dash(100 * north[i], 1), number_or_dash(100 * up[i], 1),
                          number_or_dash(100 * misfit[i], 1), number_or_dash(100 * limit[i], 1), note});
  }
  return table.html();
}

}  // namespace

std::string place_section(const SurveyData& d, const RunRecord* record) {
  if (!d.place) return {};
  std::string body = paragraph("The files of this run (cloud, plot.gpkg, dem.tif and the other grids) are in " +
                               crs_name(d.place->crs_wkt) +
                               "; x and y of tables stay those of the plot, beside easting and northing.");
  if (const auto* report = said(record)) body += paragraph(report->message);
  if (!d.place->heights_known)
    body += paragraph("Heights are those of the plot: no control heights were given.", "note");
  if (d.control != nullptr && d.control->rows() > 0)
    body += residuals(*d.control) +
            paragraph(
                "Residual: given minus adjusted. Off the others: distance from where the other points put it; "
                "beyond its limit lies one good point in a thousand.",
                "note");
  return section("place", "Place on the earth", body);
}

}  // namespace bole::report
