#include "render/maps/loop_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "render/maps/map_frame.h"
#include "render/maps/paths_on_cloud.h"

namespace bole::render {
namespace {

using Plan = std::vector<Eigen::Vector2d>;

constexpr double sheet_gap_mm = 4, sheet_title_mm = 5;

struct LoopRow {
  std::string name, note;
  Color color;
  Plan path;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> loops;
  Image map;
  Eigen::Vector2d map_lo, map_hi;
};

struct LoopSheet {
  std::vector<LoopRow> rows;
  Plan reference;
  MapWindow window;
  MapExtent extent;
};

Plan plan_view(const Trajectory& path) {
  Plan plan;
  for (const auto& pose : path.poses) plan.emplace_back(pose.T_target_sensor.translation().head<2>());
  return plan;
}

LoopRow row_of(const LoopRun& run) {
  LoopRow row{run.name, run.note, run.color, plan_view(run.path), {}, {}, run.map.corner, run.map.opposite()};
  if (run.map.width > 0) row.map = density_image(run.map, 20);
  const auto covered = [&](double t) {
    return t >= run.path.poses.front().time_s && t <= run.path.poses.back().time_s;
  };
  if (!run.path.poses.empty())
    for (const auto& [from, to] : run.loops)
      if (covered(from) && covered(to))
        row.loops.emplace_back(run.path.at(from).translation().head<2>(), run.path.at(to).translation().head<2>());
  return row;
}

void draw_line(Canvas& canvas, const Frame& frame, const Plan& plan, const Stroke& stroke) {
  Plan line;
  for (const auto& p : plan) line.push_back(frame.map(p.x(), p.y()));
  canvas.polyline(line, stroke);
}

void draw_title(Canvas& canvas, const Eigen::Vector2d& at, const std::string& letter, const std::string& text) {
  canvas.text(at, letter, TextStyle{8, ink::text, true});
  canvas.text(at + Eigen::Vector2d(4, 0), text, TextStyle{7.5, ink::text});
}

void draw_path_panel(Canvas& canvas, const LoopSheet& sheet, const LoopRow& row, const Box& box) {
  const Frame frame = fitted_frame(sheet.extent, box);
  auto axes = map_axes();
  axes.x_ticks = axes.y_ticks = 6;
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    draw_line(canvas, frame, sheet.reference, Stroke{ink::muted.with_alpha(0.5), 1.0});
    draw_line(canvas, frame, row.path, Stroke{row.color, 0.35});
    for (const auto& [from, to] : row.loops) {
      const auto a = frame.map(from.x(), from.y()), b = frame.map(to.x(), to.y());
      canvas.line(a, b, Stroke{ink::good.with_alpha(0.8), 0.35});
      canvas.circle(b, 0.45, ink::good);
    }
    const auto a = frame.map(sheet.window.lo().x(), sheet.window.hi().y()),
               b = frame.map(sheet.window.hi().x(), sheet.window.lo().y());
    canvas.rectangle({a.x(), a.y(), b.x(), b.y()}, {}, Stroke{ink::text, 0.3});
  }
  draw_axes(canvas, frame, axes);
}

void draw_map_panel(Canvas& canvas, const LoopSheet& sheet, const LoopRow& row, const Box& box) {
  const auto lo = sheet.window.lo(), hi = sheet.window.hi();
  const Frame frame{box, {lo.x(), hi.x()}, {lo.y(), hi.y()}};
  auto axes = map_axes();
  axes.x_ticks = axes.y_ticks = 5;
  {
    const auto clip = canvas.clip(frame.box);
    const auto a = frame.map(row.map_lo.x(), row.map_hi.y()), b = frame.map(row.map_hi.x(), row.map_lo.y());
    if (row.map.width > 0) canvas.image(row.map, {a.x(), a.y(), b.x(), b.y()});
    draw_line(canvas, frame, sheet.reference, Stroke{ink::muted.with_alpha(0.6), 0.8});
    draw_line(canvas, frame, row.path, Stroke{row.color, 0.35});
  }
  draw_axes(canvas, frame, axes);
}

}  // namespace

MapWindow loop_window(const Trajectory& first, const Trajectory& second) {
  const auto apart = furthest_apart(first, second);
  constexpr double min_reach_m = 2.5, max_reach_m = 8, times = 4;
  return {apart.place, std::clamp(times * apart.distance_m, min_reach_m, max_reach_m)};
}

Figure loop_sheet(const std::vector<LoopRun>& runs, const Trajectory& reference, const MapWindow& window,
                  double width_mm) {
  if (runs.empty()) throw bad_input("there is no run to draw", "the trajectory of a run");
  LoopSheet sheet;
  sheet.window = window;
  sheet.reference = plan_view(reference);
  for (const auto& run : runs) sheet.rows.push_back(row_of(run));
  for (const auto& p : sheet.reference) sheet.extent.include(p);
  for (const auto& row : sheet.rows)
    for (const auto& p : row.path) sheet.extent.include(p);
  sheet.extent.lo.array() -= 1;
  sheet.extent.hi.array() += 1;
  const double side_mm = (width_mm - 2 * axis_space_left_mm - sheet_gap_mm - 2) / 2,
               row_mm = sheet_title_mm + side_mm + axis_space_below_mm + sheet_gap_mm;
  Figure figure;
  figure.name = "loop_closure";
  figure.title = "Path and map with their loop closures";
  figure.caption = fmt::format(
      "Left: the path of each run from above{}; green lines join the two places of each loop closure. Right: the map "
      "of "
      "the run in the square of the left panel, {:.1f} m wide, where the paths of the first two runs are furthest "
      "apart; "
      "the darker, the more points between 0.5 and 2.5 m above the ground (all points where heights are not known).",
      sheet.reference.empty() ? "" : " over the reference (grey)", 2 * window.reach_m);
  figure.width_mm = width_mm;
  figure.height_mm = row_mm * static_cast<double>(sheet.rows.size()) + 5;
  figure.draw = [sheet = std::move(sheet), side_mm, row_mm](Canvas& canvas) {
    for (std::size_t k = 0; k < sheet.rows.size(); ++k) {
      const auto& row = sheet.rows[k];
      const double y = static_cast<double>(k) * row_mm, left = axis_space_left_mm,
                   right = 2 * axis_space_left_mm + side_mm + sheet_gap_mm, top = y + sheet_title_mm;
      draw_title(canvas, {left - 10, y + 3.2}, std::string(1, static_cast<char>('a' + 2 * k)),
                 row.name + (row.note.empty() ? "" : ": " + row.note));
      draw_title(canvas, {right - 10, y + 3.2}, std::string(1, static_cast<char>('b' + 2 * k)), "its map");
      draw_path_panel(canvas, sheet, row, {left, top, left + side_mm, top + side_mm});
      draw_map_panel(canvas, sheet, row, {right, top, right + side_mm, top + side_mm});
    }
    std::vector<LegendEntry> entries{{Symbol::line, ink::good, "loop closure"}};
    if (!sheet.reference.empty()) entries.push_back({Symbol::line, ink::muted, "reference path"});
    for (const auto& row : sheet.rows) entries.push_back({Symbol::line, row.color, row.name});
    draw_legend_row(canvas, {axis_space_left_mm - 1.5, row_mm * static_cast<double>(sheet.rows.size())},
                    canvas.width_mm() - axis_space_left_mm, entries);
  };
  return figure;
}

}  // namespace bole::render
