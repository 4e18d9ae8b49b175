#include "render/charts/sample_charts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double sample_panel_mm = 52, sample_gap_mm = 16, sample_legend_mm = 7;

struct Point {
  double radius_m, bias, bias_half, sd, poisson;
};
using Lines = std::vector<std::pair<std::string, std::vector<Point>>>;  // by treatment of the edge, in their order

Lines lines_of(const Table& summary) {
  const std::string name = "basal_area_m2_per_ha";
  const auto radius = summary.numbers("radius_m"), bias = summary.numbers(name + "_bias_pct"),
             se = summary.numbers(name + "_bias_se_pct"), sd = summary.numbers(name + "_sd_pct"),
             poisson = summary.numbers(name + "_poisson_sd_pct");
  const auto& edge = summary.texts("edge");
  Lines lines;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    auto it = std::ranges::find(lines, edge[i], &Lines::value_type::first);
    if (it == lines.end()) it = lines.insert(lines.end(), {edge[i], {}});
    it->second.push_back({radius[i], bias[i], 1.96 * se[i], sd[i], poisson[i]});
  }
  for (auto& [name_of_edge, points] : lines) std::ranges::sort(points, {}, &Point::radius_m);
  return lines;
}

Color edge_color(std::size_t i) {
  static constexpr Color inks[] = {ink::accent, ink::fair, ink::good, ink::primary};
  return inks[i % std::size(inks)];
}

struct SampleExtent {
  Interval radius, bias, sd;
};

SampleExtent sample_extent(const Lines& lines) {
  double low = 1e300, high = 0, worst = 1, most = 1;
  for (const auto& [edge, points] : lines)
    for (const auto& p : points) {
      low = std::min(low, p.radius_m);
      high = std::max(high, p.radius_m);
      worst = std::max(worst, std::abs(p.bias) + p.bias_half);
      most = std::max({most, p.sd, p.poisson});
    }
  if (low > high) low = 0, high = 1;
  const double margin = 0.05 * std::max(high - low, 1.0);
  return {{low - margin, high + margin}, nice_interval({-worst, worst}, 6), nice_interval({0, most}, 6)};
}

void draw_bias(Canvas& canvas, const Lines& lines, const Frame& frame) {
  AxesStyle axes;
  axes.x_label = "Radius of the plots (m)";
  axes.y_label = "Bias of basal area (%)";
  draw_grid(canvas, frame, axes);
  canvas.line(frame.map(frame.x.lo, 0), frame.map(frame.x.hi, 0), Stroke{ink::muted, 0.2});
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<Eigen::Vector2d> curve;
    for (const auto& p : lines[k].second) {
      const double aside = p.radius_m + 0.006 * frame.x.length() * (static_cast<double>(k) - 1.5);
      canvas.line(frame.map(aside, p.bias - p.bias_half), frame.map(aside, p.bias + p.bias_half),
                  Stroke{edge_color(k).with_alpha(0.6), 0.25});
      curve.push_back(frame.map(aside, p.bias));
    }
    canvas.polyline(curve, Stroke{edge_color(k), 0.35});
  }
  draw_axes(canvas, frame, axes);
}

void draw_sample_scatter(Canvas& canvas, const Lines& lines, const Frame& frame) {
  AxesStyle axes;
  axes.x_label = "Radius of the plots (m)";
  axes.y_label = "SD of single plots (%)";
  draw_grid(canvas, frame, axes);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<Eigen::Vector2d> curve, random;
    for (const auto& p : lines[k].second) {
      curve.push_back(frame.map(p.radius_m, p.sd));
      random.push_back(frame.map(p.radius_m, p.poisson));
    }
    canvas.polyline(curve, Stroke{edge_color(k), 0.35});
    if (k == 0) canvas.polyline(random, Stroke{ink::muted, 0.3, {1.2, 0.8}});
  }
  draw_axes(canvas, frame, axes);
}

}  // namespace

Figure sample_curves(const Table& summary, double width_mm) {
  auto lines = lines_of(summary);
  Figure figure;
  figure.name = "sample_plots";
  figure.title = "Sample plots and the stand";
  figure.caption =
      "Left: mean of all sample plots minus the truth, with 95 % intervals. Right: standard deviation of single plots; "
      "dashed: of trees that stand at random.";
  figure.width_mm = width_mm;
  figure.height_mm = sample_legend_mm + sample_panel_mm + axis_space_below_mm + 1;
  figure.draw = [lines = std::move(lines)](Canvas& canvas) {
    std::vector<LegendEntry> legend;
    for (std::size_t k = 0; k < lines.size(); ++k) legend.push_back({Symbol::line, edge_color(k), lines[k].first});
    legend.push_back({Symbol::dashed_line, ink::muted, "trees at random"});
    draw_legend_row(canvas, {axis_space_left_mm, 1}, canvas.width_mm() - axis_space_left_mm, legend, 7);
    const auto extent = sample_extent(lines);
    const double width = (canvas.width_mm() - 2 * axis_space_left_mm - 3 - (sample_gap_mm - axis_space_left_mm)) / 2;
    const double left = axis_space_left_mm, right = left + width + sample_gap_mm;
    draw_bias(canvas, lines,
              {{left, sample_legend_mm, left + width, sample_legend_mm + sample_panel_mm}, extent.radius, extent.bias});
    draw_sample_scatter(
        canvas, lines,
        {{right, sample_legend_mm, right + width, sample_legend_mm + sample_panel_mm}, extent.radius, extent.sd});
  };
  return figure;
}

}  // namespace bole::render
