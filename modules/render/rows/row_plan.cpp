#include "render/rows/row_plan.h"

#include <algorithm>

#include "render/charts/columns.h"

namespace bole::render {

std::vector<PlannedRow> planned_rows(const Table& lines) {
  const auto x = lines.numbers("x_m"), y = lines.numbers("y_m");
  std::vector<PlannedRow> rows;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto id = lines.text("row_id", i, 0);
    if (rows.empty() || rows.back().id != id) rows.push_back({id, {}});
    rows.back().vertices.emplace_back(x[i], y[i]);
  }
  return rows;
}

std::vector<Eigen::Vector2d> standing_plants(const Table& plants) {
  const auto x = plants.numbers("x_m"), y = plants.numbers("y_m");
  const auto state = texts_or_empty(plants, "state");
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (state[i] != "missing" && std::isfinite(x[i] + y[i])) points.emplace_back(x[i], y[i]);
  return points;
}

void draw_planned_rows(Canvas& canvas, const Frame& frame, const std::vector<PlannedRow>& rows, const RowLook& look) {
  TextStyle style{6.5, look.color};
  style.halo_mm = 0.3;
  for (const auto& row : rows) {
    std::vector<Eigen::Vector2d> line;
    for (const auto& p : row.vertices) line.push_back(frame.map(p.x(), p.y()));
    Stroke stroke{look.color, look.width_mm};
    if (look.dashed) stroke.dash_mm = {1.4, 0.9};
    canvas.polyline(line, stroke);
    if (!look.ids || line.size() < 2 || (line[0] - line[1]).norm() < 1e-9) continue;
    canvas.text(line[0] + 2.6 * (line[0] - line[1]).normalized(), row.id,
                style.aligned(HAlign::centre, VAlign::middle));
  }
}

MapExtent extent_of_rows(const std::vector<PlannedRow>& rows, const std::vector<Eigen::Vector2d>& plants) {
  MapExtent extent;
  for (const auto& p : plants) extent.include(p);
  for (const auto& row : rows)
    for (const auto& p : row.vertices) extent.include(p);
  if (extent.empty()) return extent;
  const double pad = 0.1 * std::max((extent.hi - extent.lo).maxCoeff(), 0.5);
  extent.lo.array() -= pad;
  extent.hi.array() += pad;
  return extent;
}

AxesStyle row_axes(bool north_known) {
  AxesStyle axes;
  axes.x_label = north_known ? "East (m)" : "x (m)";
  axes.y_label = north_known ? "North (m)" : "y (m)";
  axes.frame = true;
  axes.x_ticks = axes.y_ticks = 5;
  return axes;
}

double draw_panel_title(Canvas& canvas, const Eigen::Vector2d& corner, const std::string& letter,
                        const std::string& title) {
  const TextStyle bold{8, ink::text, true}, plain{7.5, ink::text};
  canvas.text(corner + Eigen::Vector2d(0, 3), letter, bold);
  canvas.text(corner + Eigen::Vector2d(4, 3), title, plain);
  return 4.5;
}

}  // namespace bole::render
