#include "render/beside/distance_bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

using Of = DistanceBars::Of;

constexpr double words_line_mm = 3.9, pad_mm = 2;
const Stroke median_line{ink::accent, 0.45};
const Stroke p95_line{ink::muted, 0.35, {1.4, 1.0}};

// Millimetres; finer where bins are.
std::string distance_text(const DistanceBars& bars, double m) { return fixed(m, bars.bin_m < 0.001 ? 4 : 3); }

std::string share_text(const DistanceBars& bars, std::size_t points) {
  const double share = 100 * static_cast<double>(points) / static_cast<double>(bars.compared);
  return share < 0.095 ? "< 0.1 %" : fixed(share, 1) + " %";
}

std::string median_words(const DistanceBars& bars) {
  if (std::isfinite(bars.median_m)) return "median " + distance_text(bars, bars.median_m) + " m";
  return "median beyond " + fixed(bars.within_m, 2) + " m";
}

std::string p95_words(const DistanceBars& bars) {
  if (bars.of == Of::height)
    return "95 % from " + distance_text(bars, bars.lo95_m) + " to " + distance_text(bars, bars.hi95_m) + " m";
  if (std::isfinite(bars.hi95_m)) return "95 % below " + distance_text(bars, bars.hi95_m) + " m";
  return "95 % reach beyond " + fixed(bars.within_m, 2) + " m";
}

// What the bars do not show.
std::vector<std::string> left_out(const DistanceBars& bars) {
  std::vector<std::string> lines;
  if (bars.below > 0)
    lines.push_back(share_text(bars, bars.below) + " below " + distance_text(bars, bars.lo_m) + " m, not drawn");
  if (bars.above > 0)
    lines.push_back(share_text(bars, bars.above) + " above " + distance_text(bars, bars.hi_m()) + " m, not drawn");
  if (bars.unmatched > 0)
    lines.push_back(share_text(bars, bars.unmatched) + " have nothing within " + fixed(bars.within_m, 2) + " m");
  return lines;
}

std::string x_label(Of of) {
  switch (of) {
    case Of::nearest_point:
      return "Distance (m), unsigned";
    case Of::surface:
      return "Distance from surface (m), unsigned";
    case Of::height:
      break;
  }
  return "Height difference (m), signed: + is higher";
}

// Heading, marks and what is left out, line by line. Returns where the bars may begin.
double draw_words(Canvas& canvas, const DistanceBars& bars) {
  double y = pad_mm;
  const double x = axis_space_left_mm, width = canvas.width_mm() - x - pad_mm;
  const auto line = [&](const std::string& text, const TextStyle& style) {
    canvas.text({x, y}, text, style.aligned(HAlign::left, VAlign::top));
    y += words_line_mm;
  };
  if (!bars.cloud.empty()) {
    line(bars.cloud, TextStyle{8, ink::text, true});
    line("compared with " + bars.from, TextStyle{7.5, ink::muted});
    line(fmt::format("{} points, bins of {} m", bars.compared, distance_text(bars, bars.bin_m)),
         TextStyle{7.5, ink::muted});
  }
  y += draw_legend_row(
      canvas, {x, y}, width,
      {{Symbol::line, median_line.color, median_words(bars)}, {Symbol::dashed_line, p95_line.color, p95_words(bars)}});
  y += 0.8;
  for (const auto& text : left_out(bars)) line(text, TextStyle{7, ink::muted});
  return y + 1;
}

void draw_mark(Canvas& canvas, const Frame& frame, double at_m, const Stroke& stroke) {
  if (at_m >= frame.x.lo && at_m <= frame.x.hi) canvas.line(frame.map(at_m, 0), frame.map(at_m, frame.y.hi), stroke);
}

void draw_bars(Canvas& canvas, const DistanceBars& bars) {
  const double top = draw_words(canvas, bars), all = static_cast<double>(bars.compared) / 100;
  const double most = static_cast<double>(std::ranges::max(bars.counts)) / all;
  const Frame frame{{axis_space_left_mm, top, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm},
                    {bars.lo_m, bars.hi_m()},
                    {0, nice_interval({0, 1.03 * most}, 4).hi}};
  AxesStyle axes{x_label(bars.of), "Points (%)"};
  axes.x_ticks = frame.box.width() < 70 ? 4 : 6;
  axes.y_ticks = 4;
  draw_grid(canvas, frame, axes);
  for (std::size_t k = 0; k < bars.counts.size(); ++k) {
    if (bars.counts[k] == 0) continue;
    const double x = bars.lo_m + bars.bin_m * static_cast<double>(k);
    const auto a = frame.map(x, static_cast<double>(bars.counts[k]) / all), b = frame.map(x + bars.bin_m, 0);
    canvas.rectangle({a.x(), a.y(), b.x(), b.y()}, mix(ink::paper, ink::primary, 0.6));
  }
  draw_mark(canvas, frame, bars.median_m, median_line);
  if (bars.of == Of::height) draw_mark(canvas, frame, bars.lo95_m, p95_line);
  draw_mark(canvas, frame, bars.hi95_m, p95_line);
  draw_axes(canvas, frame, axes);
}

}  // namespace

Figure distance_histogram(const DistanceBars& bars, const ChartSize& size) {
  Figure figure;
  figure.name = bars.of == Of::height ? "height_difference_histogram" : "distance_histogram";
  figure.title = "Distances of a cloud";
  figure.caption =
      "Points per bin in percent of all that were compared; solid: the median; dashed: where 95 % of them lie.";
  figure.width_mm = size.width_mm;
  figure.height_mm = size.height_mm;
  figure.draw = [bars](Canvas& canvas) {
    if (!bars.counts.empty()) return draw_bars(canvas, bars);
    canvas.text(canvas.sheet().centre(), "No point has anything within " + fixed(bars.within_m, 2) + " m",
                TextStyle{8, ink::muted}.aligned(HAlign::centre, VAlign::middle));
  };
  return figure;
}

}  // namespace bole::render
