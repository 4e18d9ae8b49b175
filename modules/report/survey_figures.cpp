#include "report/survey_figures.h"

#include <algorithm>

#include "render/charts/dbh_charts.h"
#include "render/charts/position_charts.h"
#include "render/charts/slice_sheet.h"
#include "render/charts/stem_map.h"
#include "render/scene/map_figure.h"
#include "report/core/plot_metrics.h"

namespace bole {
namespace {

MapData map_data(const SurveyData& d) { return {d.points, d.stems, d.sections, d.trajectory, d.area, d.north_known()}; }

void add_maps(const SurveyData& d, const ReportOptions& o, std::vector<FigurePlan>& plans) {
  const auto add = [&](const char* name, PointColor color, MapView view) {
    MapOptions map;
    map.color = color, map.view = view, map.dpi = o.dpi, map.point_budget = static_cast<std::size_t>(o.point_budget);
    plans.push_back({name, [&d, map, width = o.figure_width] { return std::vector<Figure>{map_figure(map_data(d), map, width)}; }, true, true, 20});
  };
  add("map by height", PointColor::height, MapView::oblique);
  if (d.points->has(arrays::tree_id)) add("map by tree", PointColor::tree, MapView::oblique);
  if (d.points->has(arrays::intensity)) add("map by intensity", PointColor::intensity, MapView::oblique);
  add("map from above", PointColor::height, MapView::top);
}

bool has_matches(const SurveyData& d) {
  if (d.matches == nullptr || !d.matches->has("kind")) return false;
  const auto& kind = d.matches->texts("kind");
  return std::find(kind.begin(), kind.end(), "matched") != kind.end();
}

}  // namespace

std::vector<FigurePlan> survey_figures(const SurveyData& d, const ReportOptions& o) {
  std::vector<FigurePlan> plans;
  const double wide = o.figure_width, half = 0.47 * o.figure_width;
  const auto add = [&](const char* name, bool is_wide, std::function<Figure()> make) { plans.push_back({name, [make = std::move(make)] { return std::vector<Figure>{make()}; }, is_wide, false, 1}); };
  const bool has_stems = d.stems->rows() > 0;
  if (d.points != nullptr && !d.points->empty()) add_maps(d, o, plans);
  if (has_stems) {
    add("stem map", true, [&d, wide] { return stem_map({d.stems, d.area, d.targets, d.trajectory, d.matches, d.north_known()}, wide); });
    add("diameter distribution", false, [&d, half, min_dbh = o.min_dbh, width = o.class_width] { return dbh_histogram(d.stems->subset(counted_stems(*d.stems, d.area, min_dbh)).numbers("dbh_cm"), half, width); });
  }
  if (has_matches(d)) {
    add("estimated against reference diameter", false, [&d, half] { return dbh_scatter(*d.matches, half); });
    add("diameter errors", false, [&d, half, width = o.class_width] { return dbh_error_boxes(*d.matches, half, width); });
    add("position errors", false, [&d, half] { return position_errors(*d.matches, half); });
  }
  if (d.trajectory != nullptr && d.trajectory->poses.size() > 1) add("walk", true, [&d, wide] { return trajectory_plan(*d.trajectory, d.reference_trajectory, wide); });
  if (has_stems && d.slice != nullptr) plans.push_back({"breast-height slices", [&d, wide] { return slice_sheets(*d.stems, *d.slice, wide); }, true, true, 5});
  return plans;
}

}  // namespace bole
