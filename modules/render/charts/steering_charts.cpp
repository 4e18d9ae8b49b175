#include "render/charts/steering_charts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double run_panel_mm = 38, run_gap_mm = 6, run_legend_mm = 7;

using PassCurve = std::vector<Eigen::Vector2d>;  // metres along, centimetres beside

struct Panel {
  double speed_km_h = 0;
  std::map<std::int64_t, PassCurve> passes, receiver;  // by number of pass
};

// The first run of each speed.
std::vector<Panel> panels_of(const Table& errors, const char* column) {
  const auto speed = errors.numbers("speed_km_h"), along = errors.numbers("along_m"), value = errors.numbers(column),
             receiver = numbers_or_nan(errors, "receiver_m");
  const auto run = errors.integers("run"), pass = errors.integers("pass");
  std::map<double, std::pair<std::int64_t, Panel>> by_speed;
  for (std::size_t i = 0; i < errors.rows(); ++i) {
    auto& [first_run, panel] = by_speed.try_emplace(speed[i], run[i], Panel{speed[i], {}, {}}).first->second;
    if (run[i] != first_run) continue;
    if (std::isfinite(value[i])) panel.passes[pass[i]].emplace_back(along[i], 100 * value[i]);
    if (std::isfinite(receiver[i])) panel.receiver[pass[i]].emplace_back(along[i], 100 * receiver[i]);
  }
  std::vector<Panel> panels;
  for (auto& [s, entry] : by_speed)
    if (!entry.second.passes.empty()) panels.push_back(std::move(entry.second));
  return panels;
}

struct Style {
  std::string y_label;
  bool receiver = false;
};

struct SteeringExtent {
  Interval along, error;
};

SteeringExtent steering_extent(const std::vector<Panel>& panels, bool with_receiver) {
  double low = 1e300, high = -1e300, most = 1;
  for (const auto& p : panels)
    for (const auto* group : {&p.passes, &p.receiver}) {
      if (group == &p.receiver && !with_receiver) continue;
      for (const auto& [number, curve] : *group)
        for (const auto& q : curve) {
          low = std::min(low, q.x());
          high = std::max(high, q.x());
          most = std::max(most, std::abs(q.y()));
        }
    }
  if (low > high) low = 0, high = 1;
  return {{low, high}, nice_interval({-1.05 * most, 1.05 * most}, 4)};
}

Color pass_color(std::int64_t pass) {
  static constexpr Color inks[] = {ink::primary, ink::accent, ink::good, ink::fair};
  return inks[static_cast<std::size_t>(pass - 1) % std::size(inks)];
}

void draw_steering_panel(Canvas& canvas, const Panel& panel, const Frame& frame, const Style& style, bool last) {
  AxesStyle axes;
  axes.x_label = last ? "Way along the line (m)" : "";
  axes.y_label = style.y_label;
  axes.x_axis = last;
  axes.y_ticks = 4;
  draw_grid(canvas, frame, axes);
  canvas.line(frame.map(frame.x.lo, 0), frame.map(frame.x.hi, 0), Stroke{ink::muted, 0.2});
  const auto draw = [&](const PassCurve& curve, const Color& color, double width_mm) {
    PassCurve mapped;
    for (const auto& p : curve) mapped.push_back(frame.map(p.x(), p.y()));
    canvas.polyline(mapped, Stroke{color, width_mm});
  };
  {
    const auto clip = canvas.clip(frame.box);
    if (style.receiver)
      for (const auto& [number, curve] : panel.receiver) draw(curve, ink::muted.with_alpha(0.45), 0.15);
    for (const auto& [number, curve] : panel.passes) draw(curve, pass_color(number), 0.3);
  }
  draw_axes(canvas, frame, axes);
  TextStyle title{8, ink::text, true};
  title.halo_mm = 0.5;
  const bool whole = std::abs(panel.speed_km_h - std::round(panel.speed_km_h)) < 1e-9;
  canvas.text({frame.box.x0 + 1.5, frame.box.y0 + 1}, fixed(panel.speed_km_h, whole ? 0 : 1) + " km/h",
              title.aligned(HAlign::left, VAlign::top));
}

void draw_panels(Canvas& canvas, const std::vector<Panel>& panels, const Style& style) {
  const auto extent = steering_extent(panels, style.receiver);
  std::map<std::int64_t, bool> numbers;
  for (const auto& p : panels)
    for (const auto& [number, curve] : p.passes) numbers[number] = true;
  std::vector<LegendEntry> legend;
  for (const auto& [number, drawn] : numbers)
    legend.push_back({Symbol::line, pass_color(number), "pass " + std::to_string(number)});
  if (style.receiver) legend.push_back({Symbol::line, ink::muted, "receiver"});
  draw_legend_row(canvas, {axis_space_left_mm, 1}, canvas.width_mm() - axis_space_left_mm, legend, 7);
  double y = run_legend_mm;
  for (std::size_t i = 0; i < panels.size(); ++i, y += run_panel_mm + run_gap_mm)
    draw_steering_panel(canvas, panels[i],
                        {{axis_space_left_mm, y, canvas.width_mm() - 3, y + run_panel_mm}, extent.along, extent.error},
                        style, i + 1 == panels.size());
}

Figure curves(const Table& errors, const char* column, double width_mm, Style style) {
  auto panels = panels_of(errors, column);
  if (style.receiver)
    style.receiver = std::any_of(panels.begin(), panels.end(), [](const Panel& p) { return !p.receiver.empty(); });
  Figure figure;
  figure.width_mm = width_mm;
  const double n = static_cast<double>(std::max<std::size_t>(panels.size(), 1));
  figure.height_mm = run_legend_mm + n * run_panel_mm + (n - 1) * run_gap_mm + axis_space_below_mm + 1;
  figure.draw = [panels = std::move(panels), style](Canvas& canvas) { draw_panels(canvas, panels, style); };
  return figure;
}

}  // namespace

Figure tracking_error_curves(const Table& errors, double width_mm) {
  auto figure = curves(errors, "error_m", width_mm, {"Error (cm)", true});
  figure.name = "tracking_errors";
  figure.title = "Straight-line error";
  figure.caption =
      "True distance of the control point from its line along the way, positive to the left of the way driven, for the "
      "first run at each speed; grey: what the receiver contributes.";
  return figure;
}

Figure adjacent_error_curves(const Table& errors, double width_mm) {
  auto figure = curves(errors, "adjacent_m", width_mm, {"Error (cm)", false});
  figure.name = "adjacent_errors";
  figure.title = "Adjacent-row error";
  figure.caption =
      "Distance to the pass driven before minus the row width along the line: positive leaves a gap, negative an "
      "overlap. First run at each speed.";
  return figure;
}

}  // namespace bole::render
