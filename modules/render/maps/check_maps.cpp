#include "render/maps/check_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "base/option_text.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

using Points = std::vector<Eigen::Vector2d>;

struct Measure {
  const char *column, *title, *unit;
  bool many_is_good;  // else few
  double max = 0;     // of the colours; 0: the 98th of 100 values
};
constexpr std::array<Measure, 6> cell_measures{{{"ground_points", "Ground points per cell", "", true},
                                                {"directions", "Directions of view (of 16)", "", true, 16},
                                                {"view_span_deg", "Span of the directions of view", "deg", true, 360},
                                                {"walk_m", "Distance from the walk", "m", false},
                                                {"ground_thickness_cm", "Scatter of the ground", "cm", false},
                                                {"pass_spread_cm", "Ground: distance of passes", "cm", false}}};
constexpr std::array<Measure, 2> stem_measures{
    {{"wall_cm", "Scatter about the bark", "cm", false}, {"pass_spread_cm", "Stems: distance of passes", "cm", false}}};

struct Panel {
  Measure measure;
  bool of_stems = false;
  Points at;
  std::vector<double> values;
  Interval range;
};

struct Mark {
  Eigen::Vector2d at;
  std::string number;
  Color color;
};

struct Sheet {
  std::vector<Panel> panels;
  Points outline, walk, stems;
  std::vector<Mark> marks;
  double cell_m = 1;
  Interval x, y;
  bool north_known = true;
};

std::optional<Panel> panel_of(const Table* table, const Measure& measure, bool of_stems) {
  if (table == nullptr) return std::nullopt;
  Panel panel{measure, of_stems, {}, numbers_or_nan(*table, measure.column), {}};
  const auto x = numbers_or_nan(*table, "x_m"), y = numbers_or_nan(*table, "y_m");
  std::vector<double> known;
  for (std::size_t i = 0; i < x.size(); ++i) {
    panel.at.emplace_back(x[i], y[i]);
    if (std::isfinite(panel.values[i])) known.push_back(panel.values[i]);
  }
  if (known.empty()) return std::nullopt;
  const auto high = known.begin() + std::lround(0.98 * static_cast<double>(known.size() - 1));
  std::ranges::nth_element(known, high);
  panel.range = {0, measure.max > 0 ? measure.max : std::max(*high, 1e-3)};
  return panel;
}

Points points_if_any(const Table* table) {
  Points points;
  if (table == nullptr) return points;
  const auto x = numbers_or_nan(*table, "x_m"), y = numbers_or_nan(*table, "y_m");
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return points;
}

std::vector<Mark> finding_marks(const Table* findings) {
  std::vector<Mark> marks;
  if (findings == nullptr) return marks;
  const auto at = points_if_any(findings);
  const auto severity = texts_or_empty(*findings, "severity");
  for (std::size_t i = 0; i < at.size(); ++i)
    if (at[i].allFinite())
      marks.push_back({at[i], std::to_string(i + 1), severity[i] == "note" ? ink::muted : ink::accent});
  return marks;
}

Sheet check_sheet(const CheckMapsData& data) {
  Sheet s;
  s.north_known = data.north_known;
  for (const auto& m : cell_measures)
    if (auto panel = panel_of(data.cells, m, false)) s.panels.push_back(std::move(*panel));
  for (const auto& m : stem_measures)
    if (auto panel = panel_of(data.stems, m, true)) s.panels.push_back(std::move(*panel));
  const auto cells = points_if_any(data.cells);
  if (cells.empty() || s.panels.empty()) throw bad_input("the check has no cell with a measure", "one at least");
  if (const auto it = data.cells->facts.find("cell_m"); it != data.cells->facts.end())
    s.cell_m = number_from_text(it->second).value_or(1);
  Eigen::Vector2d low = cells.front(), high = low;
  for (const auto& p : cells) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const double margin = 0.03 * (high - low).maxCoeff() + s.cell_m / 2;
  s.x = {low.x() - margin, high.x() + margin};
  s.y = {low.y() - margin, high.y() + margin};
  s.outline = data.area.outline();
  s.stems = points_if_any(data.stems);
  s.marks = finding_marks(data.findings);
  if (data.trajectory != nullptr)
    for (const auto& pose : data.trajectory->poses)
      if (const Eigen::Vector2d p = pose.T_target_sensor.translation().head<2>();
          s.walk.empty() || (p - s.walk.back()).norm() > 0.1)
        s.walk.push_back(p);
  return s;
}

constexpr double title_mm = 6, gap_mm = 3, bar_mm = 14;
constexpr std::size_t per_row = 2;

Frame panel_frame(const Sheet& s, std::size_t i, double width_mm) {
  const double column = width_mm / per_row, w = column - axis_space_left_mm - bar_mm - gap_mm;
  const double h = w * std::clamp(s.y.length() / s.x.length(), 0.3, 1.6);
  const std::size_t row = i / per_row;
  const double x = static_cast<double>(i % per_row) * column + axis_space_left_mm,
               y = static_cast<double>(row) * (title_mm + h + axis_space_below_mm + gap_mm) + title_mm;
  return {{x, y, x + w, y + h}, s.x, s.y};
}

void draw_panel(Canvas& canvas, const Sheet& s, const Panel& panel, const Frame& frame) {
  // Dark is what is to be looked at: few points, far from the walk.
  const ColorMap& map = ColorMap::viridis();
  const auto color = [&](double v) {
    const double t = std::clamp((v - panel.range.lo) / panel.range.length(), 0.0, 1.0);
    return map.at(panel.measure.many_is_good ? t : 1 - t);
  };
  canvas.text({frame.box.x0, frame.box.y0 - 2}, panel.measure.title, {7.5, ink::text, true});
  {
    const auto clip = canvas.clip(frame.box);
    const double half = s.cell_m / 2;
    for (std::size_t i = 0; i < panel.at.size(); ++i) {
      if (panel.of_stems || !std::isfinite(panel.values[i])) continue;
      const auto a = frame.map(panel.at[i].x() - half, panel.at[i].y() + half),
                 b = frame.map(panel.at[i].x() + half, panel.at[i].y() - half);
      canvas.rectangle({a.x(), a.y(), b.x() + 0.03, b.y() + 0.03}, color(panel.values[i]));
    }
    const auto on_sheet = [&](const Points& points) {
      Points mapped;
      for (const auto& p : points) mapped.push_back(frame.map(p.x(), p.y()));
      return mapped;
    };
    canvas.polyline(on_sheet(s.walk), Stroke{ink::path.with_alpha(0.7), 0.15});
    if (panel.of_stems) {
      const auto at = on_sheet(panel.at);
      for (std::size_t i = 0; i < at.size(); ++i)
        canvas.circle(at[i], 0.9, std::isfinite(panel.values[i]) ? color(panel.values[i]) : ink::grid,
                      Stroke{ink::text, 0.1});
    } else {
      canvas.dots(on_sheet(s.stems), 0.7, ink::paper);
      canvas.dots(on_sheet(s.stems), 0.5, ink::text);
    }
    const auto outline = on_sheet(s.outline);
    if (!outline.empty()) canvas.polygon(outline, {}, Stroke{ink::text, 0.3, {1.6, 1.0}});
    for (const auto& m : s.marks) {
      const auto at = frame.map(m.at.x(), m.at.y());
      canvas.circle(at, 1.6, {}, Stroke{m.color, 0.4});
      TextStyle style{6, m.color, true};
      style.halo_mm = 0.4;
      canvas.text(at + Eigen::Vector2d(2, -1), m.number, style);
    }
  }
  AxesStyle axes{s.north_known ? "East (m)" : "x (m)", s.north_known ? "North (m)" : "y (m)", 5, 5};
  axes.frame = true;
  axes.grid = false;
  draw_axes(canvas, frame, axes);
  std::vector<Color> colors;
  constexpr int steps = 16;
  for (int i = 0; i <= steps; ++i) colors.push_back(color(panel.range.lo + panel.range.length() * i / steps));
  const double x = frame.box.x1 + 2.5, bar = std::min(28.0, frame.box.height() - 8);
  draw_color_bar(canvas, {x, frame.box.y0 + 5, x + 2.5, frame.box.y0 + 5 + bar}, ColorMap(colors), panel.range,
                 panel.measure.unit, 6);
}

}  // namespace

Figure check_maps(const CheckMapsData& data, double width_mm) {
  auto sheet = check_sheet(data);
  const auto last = panel_frame(sheet, sheet.panels.size() - 1, width_mm);
  Figure figure{"check_maps",
                check_maps_title,
                "One map per measure; dark is what to look at, white was not measured. Blue line: the walk; dots: "
                "stems; rings: findings, by their numbers in check.html.",
                width_mm,
                last.box.y1 + axis_space_below_mm + 1,
                true,
                {}};
  figure.draw = [sheet = std::move(sheet), width_mm](Canvas& canvas) {
    for (std::size_t i = 0; i < sheet.panels.size(); ++i)
      draw_panel(canvas, sheet, sheet.panels[i], panel_frame(sheet, i, width_mm));
  };
  return figure;
}

}  // namespace bole::render
