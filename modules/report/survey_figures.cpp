#include "report/survey_figures.h"

#include <algorithm>
#include <memory>

#include "cloud/stem_rows.h"
#include "render/charts/dbh_charts.h"
#include "render/charts/position_charts.h"
#include "render/charts/slice_sheet.h"
#include "render/charts/stand_charts.h"
#include "render/charts/trajectory_charts.h"
#include "render/maps/check_maps.h"
#include "render/maps/raster_map.h"
#include "render/maps/stem_map.h"
#include "render/scene/map_figure.h"

namespace bole::report {
namespace {

// Heights above this are cut away in the 3-D figures, so that crowns do not hide the stems.
constexpr double cut_height_m = 5;
constexpr double hero_width_mm = 240, hero_width_px = 1600, mm_per_inch = 25.4;

// The data of all maps; their points are chosen when the first of them is drawn.
class MapSource {
 public:
  MapSource(const SurveyData& d, const ReportOptions& o, const Run& run)
      : stems_(d.kept_stems()),
        data_{d.points, &stems_, d.sections, d.trajectory, d.rule.area, d.north_known(), nullptr},
        budget_(static_cast<std::size_t>(o.point_budget)),
        run_(run) {}

  const render::MapData& data() {
    if (data_.chosen == nullptr) {
      chosen_ = render::choose_map_points(data_, budget_, run_);
      data_.chosen = &chosen_;
    }
    run_.check_cancel();
    return data_;
  }

 private:
  Table stems_;
  render::MapData data_;
  std::size_t budget_;
  const Run& run_;
  render::MapPoints chosen_;
};

void add_maps(const SurveyData& d, const ReportOptions& o, const Run& run, std::vector<FigurePlan>& plans) {
  const auto source = std::make_shared<MapSource>(d, o, run);
  const auto add = [&](const char* name, render::PointColor color, render::MapView view, bool on_page = false) {
    render::MapOptions map;
    map.color = color;
    map.view = view;
    map.dpi = o.dpi;
    map.max_height_m = cut_height_m;
    map.point_budget = static_cast<std::size_t>(o.point_budget);
    plans.push_back({.name = name,
                     .make =
                         [source, map, width = o.figure_width] {
                           return std::vector<render::Figure>{render::map_figure(source->data(), map, width)};
                         },
                     .kind = FigureKind::map,
                     .on_page = on_page});
  };
  add("map by height", render::PointColor::height, render::MapView::oblique, true);
  if (d.points->has(arrays::tree_id)) add("map by tree", render::PointColor::tree, render::MapView::oblique);
  if (d.points->has(arrays::intensity))
    add("map by intensity", render::PointColor::intensity, render::MapView::oblique);
  add("map from above", render::PointColor::height, render::MapView::top);
  if (!o.hero) return;
  constexpr double dpi = hero_width_px / hero_width_mm * mm_per_inch;
  plans.push_back(
      {.name = "hero",
       .make =
           [source] { return std::vector<render::Figure>{render::hero_figure(source->data(), hero_width_mm, dpi)}; },
       .kind = FigureKind::map,
       .on_page = false,
       .dpi = dpi,
       .asked_for = true});
}

bool has_matches(const SurveyData& d) {
  if (d.matches == nullptr || !d.matches->has("kind")) return false;
  const auto& kind = d.matches->texts("kind");
  return std::find(kind.begin(), kind.end(), "matched") != kind.end();
}

bool compares_walks(const SurveyData& d) {
  return d.trajectory != nullptr && d.reference_trajectory != nullptr && d.trajectory->poses.size() > 1 &&
         d.reference_trajectory->poses.size() > 1;
}

using AddFigure =
    std::function<void(const char* name, bool wide, std::function<render::Figure()> make, bool on_page, FigureKind)>;

void add_stand_charts(const SurveyData& d, double width_mm, const AddFigure& add) {
  const Table stems = d.stems_in_plot();
  if (render::has_heights(stems))
    add(
        "heights over diameters", false,
        [&d, width_mm] { return render::height_diameter(d.stems_in_plot(), d.height_curve, width_mm); }, true,
        FigureKind::chart);
  if (d.sections != nullptr && render::has_stem_curves(stems, *d.sections))
    add(
        "taper", false, [&d, width_mm] { return render::taper_curves(d.stems_in_plot(), *d.sections, width_mm); }, true,
        FigureKind::chart);
}

void add_rasters(const SurveyData& d, double width_mm, const AddFigure& add) {
  const auto add_one = [&](const char* name, const Raster* raster, render::RasterKind kind) {
    if (raster == nullptr || raster->values.empty()) return;
    add(
        name, false,
        [&d, raster, kind, width_mm] {
          const Table stems = d.kept_stems();
          return render::raster_map({raster, &stems, d.rule.area, d.north_known()}, kind, width_mm);
        },
        true, FigureKind::sheet);
  };
  add_one("terrain", d.dem, render::RasterKind::terrain);
  add_one("canopy height", d.canopy, render::RasterKind::canopy);
}

// Both paths laid over each other first, as the errors of the evaluation are stated.
render::Figure comparison_figure(const SurveyData& d,
                                 const std::function<render::Figure(const render::TrajectoryComparison&, double)>& draw,
                                 double width_mm) {
  const auto aligned = render::aligned_to(*d.trajectory, *d.reference_trajectory);
  auto figure = draw({&aligned, d.reference_trajectory, d.loops}, width_mm);
  figure.caption += " Both were first laid over each other as well as a shift and a turn allow.";
  return figure;
}

}  // namespace

double FigurePlan::share() const {
  switch (kind) {
    case FigureKind::map:
      return 20;
    case FigureKind::sheet:
      return 5;
    case FigureKind::chart:
      return 1;
  }
  return 1;
}

std::vector<FigurePlan> survey_figures(const SurveyData& d, const ReportOptions& o, const Run& run) {
  std::vector<FigurePlan> plans;
  const double wide = o.figure_width, half = 0.47 * o.figure_width;
  const auto add = [&](const char* name, bool is_wide, std::function<render::Figure()> make, bool on_page = true,
                       FigureKind kind = FigureKind::chart) {
    plans.push_back({.name = name,
                     .make = [make = std::move(make)] { return std::vector<render::Figure>{make()}; },
                     .kind = kind,
                     .wide = is_wide,
                     .on_page = on_page});
  };
  const bool has_stems = d.kept_stems().rows() > 0;
  if (d.points != nullptr && !d.points->empty()) add_maps(d, o, run, plans);
  if (has_stems) {
    add(
        "stem map", true,
        [&d, wide] {
          const Table stems = d.kept_stems();
          return render::stem_map({&stems, d.rule.area, d.targets, d.trajectory, d.matches, d.north_known()}, wide);
        },
        false);  // the page has a plan of its own
    add("diameter distribution", false, [&d, half, width = d.class_width_cm()] {
      return render::dbh_histogram(d.stems->subset(counted_rows(*d.stems, d.rule)).numbers("dbh_cm"), half, width);
    });
    add_stand_charts(d, half, add);
  }
  add_rasters(d, half, add);
  if (d.check != nullptr && d.check_cells != nullptr && d.check_cells->rows() > 0)
    add(
        "check of the map", true,
        [&d, wide] {
          return render::check_maps({d.check_cells, d.check_stems, d.check, d.trajectory, d.rule.area, d.north_known()},
                                    wide);
        },
        true, FigureKind::sheet);
  if (has_matches(d)) {
    add("estimated against reference diameter", false, [&d, half] { return render::dbh_scatter(*d.matches, half); });
    add("diameter errors", false,
        [&d, half, width = d.class_width_cm()] { return render::dbh_error_boxes(*d.matches, half, width); });
    add("position errors", false, [&d, half] { return render::position_errors(*d.matches, half); });
  }
  if (d.trajectory != nullptr && d.trajectory->poses.size() > 1)
    add("walk", true, [&d, wide] {
      return compares_walks(d) ? render::trajectory_plan(render::aligned_to(*d.trajectory, *d.reference_trajectory),
                                                         d.reference_trajectory, wide)
                               : render::trajectory_plan(*d.trajectory, nullptr, wide);
    });
  if (compares_walks(d)) {
    add("walk and reference", true, [&d, wide] { return comparison_figure(d, render::trajectory_overlay, wide); });
    add("errors of the walk", true, [&d, wide] {
      return comparison_figure(
          d, [](const auto& both, double width) { return render::trajectory_error_chart(both, width); }, wide);
    });
  }
  if (has_stems && d.slice != nullptr)
    plans.push_back({.name = "breast-height slices",
                     .make = [&d, wide] { return render::slice_sheets(d.stems_in_plot(), *d.slice, wide); },
                     .kind = FigureKind::sheet,
                     .on_page = false});  // the page has the slices as drawings that can be selected
  return plans;
}

}  // namespace bole::report
