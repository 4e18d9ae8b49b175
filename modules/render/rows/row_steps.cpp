#include "render/rows/row_steps.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "base/error.h"
#include "render/rows/plant_cloud.h"
#include "render/rows/row_plan.h"

namespace bole::render {
namespace {

constexpr std::size_t max_panel_points = 6000;
constexpr double gap_mm = 4, title_space_mm = 5.5, dot_size_mm = 0.4;
constexpr double space_shape = 0.7, plan_shape = 0.86;  // height over width of panels in space, and beside plans

struct SpacePanel {
  std::string title;
  PlantCloud cloud;
};

struct PlanPanel {
  std::string title;
  std::vector<ViewedPoint> trunk_points{};
  std::vector<Eigen::Vector2d> plants{};
  std::vector<PlannedRow> rows{};
};

struct StepsSheet {
  std::array<SpacePanel, 4> space;
  std::array<PlanPanel, 2> plan;
  bool north_known = true;
};

StepsSheet sheet_of(const RowSteps& s) {
  auto whole = box_of(*s.region, false), about = box_of(*s.clusters, true);
  whole.round(0);
  about.round(0.1);
  StepsSheet sheet;
  sheet.north_known = s.north_known;
  sheet.space[0] = {fmt::format("Region of interest ({} points)", s.region->size()),
                    height_cloud(*s.region, whole, max_panel_points)};
  sheet.space[1] = {fmt::format("Without ground and lone points ({})", s.cleaned->size()),
                    height_cloud(*s.cleaned, about, max_panel_points)};
  sheet.space[2] = {fmt::format("Clusters ({})", plants_in(*s.clusters)),
                    plant_cloud(*s.clusters, about, max_panel_points)};
  auto trunks = plant_cloud(*s.trunks, about, max_panel_points);
  PointCloud others = *s.cleaned;
  if (others.has("plant")) others.remove_column("plant");  // grey behind the trunks
  sheet.plan[0] = {"Trunk points and their centres", trunks.points, standing_plants(*s.centres)};
  const auto behind = plant_cloud(others, about, max_panel_points);
  trunks.points.insert(trunks.points.begin(), behind.points.begin(), behind.points.end());
  sheet.space[3] = {fmt::format("Trunks ({})", plants_in(*s.trunks)), std::move(trunks)};
  auto rows = planned_rows(*s.lines);
  sheet.plan[1] = {fmt::format("Rows by least squares ({})", rows.size()), {}, standing_plants(*s.plants), rows};
  return sheet;
}

void draw_space(Canvas& canvas, const SpacePanel& panel, const Box& box) {
  const ObliqueView view(panel.cloud.lo, panel.cloud.hi, box);
  view.draw_axes(canvas);
  view.draw_points(canvas, panel.cloud.points, dot_size_mm);
}

void draw_plan(Canvas& canvas, const PlanPanel& panel, const Box& box, bool north_known) {
  auto all = panel.plants;
  for (const auto& p : panel.trunk_points) all.emplace_back(p.at.head<2>());
  const Box inner{box.x0 + axis_space_left_mm, box.y0 + 1, box.x1 - 1, box.y1 - axis_space_below_mm};
  const Frame frame = fitted_frame(extent_of_rows(panel.rows, all), inner);
  const auto axes = row_axes(north_known);
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    for (const auto& p : panel.trunk_points) canvas.circle(frame.map(p.at.x(), p.at.y()), 0.2, p.color);
    draw_planned_rows(canvas, frame, panel.rows, {ink::primary});
    for (const auto& p : panel.plants) canvas.cross(frame.map(p.x(), p.y()), 0.9, Stroke{ink::text, 0.35});
  }
  draw_axes(canvas, frame, axes);
}

}  // namespace

Figure row_steps_sheet(const RowSteps& steps, double width_mm) {
  if (!steps.complete())
    throw bad_input("a step from the frame to the rows is not connected",
                    "region, cleaned, clusters, trunk points, centres, plants and lines");
  const double panel_mm = (width_mm - 2 * gap_mm) / 3, upper_mm = space_shape * panel_mm,
               lower_mm = plan_shape * panel_mm;
  Figure figure;
  figure.name = "row_steps";
  figure.title = "From the frame to the rows";
  figure.caption =
      "a: the region of the levelled frame, coloured by height; b: without ground and lone points; c: clusters of "
      "mean shift, a colour per plant; d: points of the trunks (grey: the other points); e: trunk points in the plan "
      "with the centre of each plant; f: least-squares lines of the rows through the centres. a to e in the axes of "
      "the frame (x right, y ahead, z up), f in those of the rows. At most 6000 points of each panel are drawn.";
  figure.width_mm = width_mm;
  figure.height_mm = upper_mm + lower_mm + 2 * title_space_mm + gap_mm;
  figure.draw = [sheet = sheet_of(steps), panel_mm, upper_mm, lower_mm](Canvas& canvas) {
    for (std::size_t k = 0; k < 6; ++k) {
      const double x = static_cast<double>(k % 3) * (panel_mm + gap_mm),
                   y = k < 3 ? 0 : upper_mm + title_space_mm + gap_mm;
      const auto& title = k < 4 ? sheet.space[k].title : sheet.plan[k - 4].title;
      const double top = y + draw_panel_title(canvas, {x, y}, std::string(1, static_cast<char>('a' + k)), title);
      const Box box{x, top, x + panel_mm, top + (k < 3 ? upper_mm : lower_mm)};
      if (k < 4)
        draw_space(canvas, sheet.space[k], box);
      else
        draw_plan(canvas, sheet.plan[k - 4], box, k == 5 && sheet.north_known);
    }
  };
  return figure;
}

}  // namespace bole::render
