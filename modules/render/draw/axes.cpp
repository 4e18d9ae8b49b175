#include "render/draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bole::render {
namespace {

constexpr double tick_mm = 1.1;
const Stroke axis_stroke{ink::axis, 0.22};
const Stroke grid_stroke{ink::grid, 0.15};

int decimals_of(double step) { return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9); }

}  // namespace

double nice_step(double length, int about) {
  if (!(length > 0) || !std::isfinite(length)) return 1;
  const double raw = length / std::max(about, 1);
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power * 1.0000001) return factor * power;
  return 10 * power;
}

Ticks nice_ticks(const Interval& range, int about) {
  Ticks ticks;
  ticks.step = nice_step(range.length(), about);
  const int decimals = decimals_of(ticks.step);
  for (double k = std::ceil(range.lo / ticks.step - 1e-6);
       k * ticks.step <= range.hi + 1e-6 * ticks.step && ticks.at.size() < 1000; ++k) {
    ticks.at.push_back(k * ticks.step);
    ticks.text.push_back(fixed(k * ticks.step, decimals));
  }
  return ticks;
}

Interval nice_interval(const Interval& range, int about) {
  if (!(std::isfinite(range.lo) && std::isfinite(range.hi))) return {0, 1};
  if (!(range.length() > 0)) return nice_interval({range.lo - 0.5, range.lo + 0.5}, about);
  const double step = nice_step(range.length(), about);
  return {std::floor(range.lo / step + 1e-9) * step, std::ceil(range.hi / step - 1e-9) * step};
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "\u2013";
  auto text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return value < 0 && !zero ? "\u2212" + text : text;
}

void draw_grid(Canvas& canvas, const Frame& frame, const AxesStyle& style) {
  if (style.x_axis)
    for (const double x : nice_ticks(frame.x, style.x_ticks).at)
      canvas.line(frame.map(x, frame.y.lo), frame.map(x, frame.y.hi), grid_stroke);
  for (const double y : nice_ticks(frame.y, style.y_ticks).at)
    canvas.line(frame.map(frame.x.lo, y), frame.map(frame.x.hi, y), grid_stroke);
}

void draw_axes(Canvas& canvas, const Frame& frame, const AxesStyle& style) {
  const Box& box = frame.box;
  if (style.frame) {
    canvas.rectangle(box, {}, axis_stroke);
  } else {
    canvas.line({box.x0, box.y0}, {box.x0, box.y1}, axis_stroke);
    canvas.line({box.x0, box.y1}, {box.x1, box.y1}, axis_stroke);
  }
  TextStyle number{style.size_pt, ink::text};
  if (style.x_axis) {
    const auto ticks = nice_ticks(frame.x, style.x_ticks);
    for (std::size_t i = 0; i < ticks.at.size(); ++i) {
      const auto p = frame.map(ticks.at[i], frame.y.lo);
      canvas.line(p, {p.x(), p.y() + tick_mm}, axis_stroke);
      canvas.text({p.x(), p.y() + tick_mm + 0.9}, ticks.text[i], number.aligned(HAlign::centre, VAlign::top));
    }
  }
  const auto ticks = nice_ticks(frame.y, style.y_ticks);
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const auto p = frame.map(frame.x.lo, ticks.at[i]);
    canvas.line(p, {p.x() - tick_mm, p.y()}, axis_stroke);
    canvas.text({p.x() - tick_mm - 0.8, p.y()}, ticks.text[i], number.aligned(HAlign::right, VAlign::middle));
  }
  TextStyle label{style.size_pt + 0.5, ink::text};
  canvas.text({box.centre().x(), box.y1 + 6.6}, style.x_label, label.aligned(HAlign::centre, VAlign::top));
  label.angle_rad = std::numbers::pi / 2;
  canvas.text({box.x0 - 11.2, box.centre().y()}, style.y_label, label.aligned(HAlign::centre, VAlign::baseline));
}

}  // namespace bole::render
