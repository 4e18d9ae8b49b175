#include "render/charts/steering_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole {
namespace {

constexpr double panel_mm = 34, gap_mm = 3, legend_mm = 7;
constexpr double shown_share = 0.93;  // of the errors that the panels hold

// In order of station, so that a way back is drawn from left to right too.
std::vector<std::size_t> by_station(const ErrorCurve& c) {
  std::vector<std::size_t> order(c.station_m.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return c.station_m[a] < c.station_m[b]; });
  return order;
}

void draw_curve(Canvas& canvas, const Frame& frame, const ErrorCurve& c, const std::vector<double>& cm,
                const Stroke& stroke) {
  std::vector<Eigen::Vector2d> run;
  const auto flush = [&] {
    if (run.size() > 1) canvas.polyline(run, stroke);
    run.clear();
  };
  for (const auto i : by_station(c)) {
    if (i >= cm.size() || !std::isfinite(cm[i]) || !std::isfinite(c.station_m[i])) {
      flush();
      continue;
    }
    run.push_back(frame.map(c.station_m[i], 100 * cm[i]));
  }
  flush();
}

void draw(Canvas& canvas, const std::vector<ErrorCurve>& curves, const std::string& error_label,
          const std::string& second_label) {
  std::vector<double> sizes;
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  for (const auto& c : curves) {
    for (const auto* values : {&c.error_m, &c.second_m})
      for (const double e : *values)
        if (std::isfinite(e)) sizes.push_back(100 * std::abs(e));
    for (const double s : c.station_m)
      if (std::isfinite(s)) lo = std::min(lo, s), hi = std::max(hi, s);
  }
  // The way onto the line would flatten what follows: it may leave the panel.
  double most = 1;
  if (!sizes.empty()) {
    const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(shown_share * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), rank, sizes.end());
    most = std::max(most, 1.4 * *rank);
  }
  const Interval x = nice_interval({lo, hi}, 8), y{-most, most};
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const double top = legend_mm + static_cast<double>(k) * (panel_mm + gap_mm);
    const Frame frame{{axis_space_left_mm, top, canvas.width_mm() - 3, top + panel_mm}, x, y};
    AxesStyle style;
    style.x_label = k + 1 == curves.size() ? "Way along the line (m)" : "";
    style.y_label = "Error (cm)", style.x_ticks = 8, style.y_ticks = 5, style.x_axis = k + 1 == curves.size();
    draw_grid(canvas, frame, style);
    canvas.line(frame.map(x.lo, 0), frame.map(x.hi, 0), Stroke{ink::muted, 0.2});
    {
      const auto clip = canvas.clip(frame.box);
      draw_curve(canvas, frame, curves[k], curves[k].second_m, Stroke{ink::fair.with_alpha(0.8), 0.2});
      draw_curve(canvas, frame, curves[k], curves[k].error_m, Stroke{ink::primary, 0.35});
    }
    draw_axes(canvas, frame, style);
    TextStyle text{8};
    text.bold = true, text.halo_mm = 0.5;
    canvas.text({frame.box.x0 + 2, frame.box.y0 + 1.5}, curves[k].label, text.aligned(HAlign::left, VAlign::top));
  }
  std::vector<LegendEntry> legend{{Symbol::line, ink::primary, error_label}};
  if (!second_label.empty()) legend.push_back({Symbol::line, ink::fair, second_label});
  draw_legend_row(canvas, {axis_space_left_mm, 1}, canvas.width_mm() - axis_space_left_mm, legend, 7);
}

}  // namespace

Figure error_curves(const std::string& name, const std::string& title, const std::vector<ErrorCurve>& curves,
                    const std::string& error_label, const std::string& second_label, double width_mm) {
  Figure figure;
  figure.name = name, figure.title = title;
  figure.caption =
      "Distance from the line over the way along it, left of the line positive. Larger errors than most leave the "
      "panel.";
  figure.width_mm = width_mm;
  figure.height_mm = legend_mm + static_cast<double>(std::max<std::size_t>(curves.size(), 1)) * (panel_mm + gap_mm) +
                     axis_space_below_mm;
  figure.draw = [=](Canvas& canvas) { draw(canvas, curves, error_label, second_label); };
  return figure;
}

}  // namespace bole
