#include "render/draw/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bole::render {
namespace {

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()};
}

std::array<Eigen::Vector2d, 10> star(const Eigen::Vector2d& centre, double radius) {
  std::array<Eigen::Vector2d, 10> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double angle = std::numbers::pi * (0.2 * static_cast<double>(i) - 0.5),
                 r = i % 2 == 0 ? radius : 0.42 * radius;
    points[i] = centre + r * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return points;
}

constexpr double symbol_mm = 2.2, symbol_column_mm = 5.0;

}  // namespace

void draw_north_arrow(Canvas& canvas, const Eigen::Vector2d& foot, double height_mm, double angle_rad, double halo_mm) {
  const double h = height_mm, w = 0.26 * h;
  const auto at = [&](double x, double y) -> Eigen::Vector2d { return foot + turned({x, -y}, angle_rad); };
  const std::array<Eigen::Vector2d, 4> whole{at(0, 0.72 * h), at(w, 0), at(0, 0.2 * h), at(-w, 0)};
  const std::array<Eigen::Vector2d, 3> east{at(0, 0.72 * h), at(w, 0), at(0, 0.2 * h)};
  if (halo_mm > 0) canvas.polygon(whole, {}, Stroke{ink::paper.with_alpha(0.85), 2 * halo_mm});
  canvas.polygon(whole, ink::paper, Stroke{ink::text, 0.2});
  canvas.polygon(east, ink::text, Stroke{ink::text, 0.2});
  TextStyle letter{h * 0.75, ink::text, true};
  letter.halo_mm = halo_mm;
  canvas.text(at(0, 0.76 * h + 0.13 * h), "N", letter.aligned(HAlign::centre, VAlign::middle));
}

double scale_bar_length_m(double mm_per_metre, double max_mm) {
  const double max_m = max_mm / mm_per_metre;
  const double power = std::pow(10, std::floor(std::log10(max_m)));
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power <= max_m * 1.0000001) return factor * power;
  return power;
}

double draw_scale_bar(Canvas& canvas, const Eigen::Vector2d& at, double mm_per_metre, double max_mm, double halo_mm) {
  const double metres = scale_bar_length_m(mm_per_metre, max_mm), length = metres * mm_per_metre, thickness = 0.9;
  const Box bar{at.x(), at.y() - thickness, at.x() + length, at.y()};
  if (halo_mm > 0) canvas.rectangle(bar.grown(halo_mm), ink::paper.with_alpha(0.85), {}, halo_mm);
  canvas.rectangle(bar, ink::paper, Stroke{ink::text, 0.18});
  canvas.rectangle({bar.x0, bar.y0, bar.centre().x(), bar.y1}, ink::text);
  TextStyle number{7, ink::text};
  number.halo_mm = halo_mm;
  const int decimals = metres < 1 ? 1 : 0;
  canvas.text({bar.x0, bar.y0 - 1}, "0", number.aligned(HAlign::centre, VAlign::baseline));
  canvas.text({bar.x1, bar.y0 - 1}, fixed(metres, decimals) + " m", number.aligned(HAlign::centre, VAlign::baseline));
  return length;
}

void draw_symbol(Canvas& canvas, Symbol symbol, const Eigen::Vector2d& centre, double size_mm, const Color& color) {
  const double r = size_mm / 2;
  switch (symbol) {
    case Symbol::disc:
      canvas.circle(centre, r, color);
      break;
    case Symbol::ring:
      canvas.circle(centre, r, {}, Stroke{color, 0.3});
      break;
    case Symbol::cross:
      canvas.cross(centre, 0.8 * r, Stroke{color, 0.4});
      break;
    case Symbol::line:
      canvas.line(centre - Eigen::Vector2d(1.4 * r, 0), centre + Eigen::Vector2d(1.4 * r, 0), Stroke{color, 0.4});
      break;
    case Symbol::dashed_line:
      canvas.line(centre - Eigen::Vector2d(1.6 * r, 0), centre + Eigen::Vector2d(1.6 * r, 0),
                  Stroke{color, 0.3, {0.9, 0.7}});
      break;
    case Symbol::square:
      canvas.rectangle({centre.x() - 0.9 * r, centre.y() - 0.9 * r, centre.x() + 0.9 * r, centre.y() + 0.9 * r}, color);
      break;
    case Symbol::triangle: {
      const std::array<Eigen::Vector2d, 3> corners{Eigen::Vector2d(centre.x(), centre.y() - r),
                                                   Eigen::Vector2d(centre.x() + r, centre.y() + 0.8 * r),
                                                   Eigen::Vector2d(centre.x() - r, centre.y() + 0.8 * r)};
      canvas.polygon(corners, color, Stroke{ink::paper, 0.2});
      break;
    }
    case Symbol::star:
      canvas.polygon(star(centre, 1.25 * r), color, Stroke{ink::paper, 0.15});
      break;
  }
}

double draw_legend_row(Canvas& canvas, const Eigen::Vector2d& top_left, double width_mm,
                       const std::vector<LegendEntry>& entries, double size_pt) {
  const TextStyle style{size_pt, ink::text};
  const double line_mm = 4.2;
  double x = top_left.x(), y = top_left.y() + line_mm / 2;
  for (const auto& entry : entries) {
    const double width = symbol_column_mm + canvas.text_size(entry.text, style).x() + 4;
    if (x > top_left.x() && x + width - 4 > top_left.x() + width_mm) x = top_left.x(), y += line_mm;
    draw_symbol(canvas, entry.symbol, {x + symbol_column_mm / 2, y}, symbol_mm, entry.color);
    canvas.text({x + symbol_column_mm, y}, entry.text, style.aligned(HAlign::left, VAlign::middle));
    x += width;
  }
  return entries.empty() ? 0 : y + line_mm / 2 - top_left.y();
}

Box draw_legend_box(Canvas& canvas, const Eigen::Vector2d& at, HAlign h, VAlign v,
                    const std::vector<LegendEntry>& entries, double size_pt) {
  const TextStyle style{size_pt, ink::text};
  const double line_mm = 3.9, pad = 1.2;
  double widest = 0;
  for (const auto& entry : entries) widest = std::max(widest, canvas.text_size(entry.text, style).x());
  const double width = symbol_column_mm + widest + 2 * pad,
               height = line_mm * static_cast<double>(entries.size()) + 2 * pad;
  const double x0 = h == HAlign::left ? at.x() : h == HAlign::centre ? at.x() - width / 2 : at.x() - width;
  const double y0 = v == VAlign::top ? at.y() : v == VAlign::middle ? at.y() - height / 2 : at.y() - height;
  const Box box{x0, y0, x0 + width, y0 + height};
  canvas.rectangle(box, ink::paper.with_alpha(0.88), Stroke{ink::grid, 0.2}, 0.6);
  double y = y0 + pad + line_mm / 2;
  for (const auto& entry : entries) {
    draw_symbol(canvas, entry.symbol, {x0 + pad + symbol_column_mm / 2 - 0.4, y}, symbol_mm, entry.color);
    canvas.text({x0 + pad + symbol_column_mm, y}, entry.text, style.aligned(HAlign::left, VAlign::middle));
    y += line_mm;
  }
  return box;
}

void draw_color_bar(Canvas& canvas, const Box& bar, const ColorMap& map, const Interval& range,
                    const std::string& title, double size_pt) {
  Image strip{1, 256, {}};
  for (int i = 0; i < strip.height; ++i) {
    const Color c = map.at(1 - (i + 0.5) / strip.height);
    for (const double v : {c.r, c.g, c.b, 1.0}) strip.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * v)));
  }
  canvas.image(strip, bar);
  canvas.rectangle(bar, {}, Stroke{ink::axis, 0.18});
  const TextStyle style{size_pt, ink::text};
  const auto ticks = nice_ticks(range, std::max(2, static_cast<int>(bar.height() / 9)));
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    const double y = bar.y1 - (ticks.at[i] - range.lo) / range.length() * bar.height();
    canvas.line({bar.x1, y}, {bar.x1 + 0.9, y}, Stroke{ink::axis, 0.18});
    canvas.text({bar.x1 + 1.6, y}, ticks.text[i], style.aligned(HAlign::left, VAlign::middle));
  }
  canvas.text({bar.x0, bar.y0 - 1.8}, title, style.aligned(HAlign::left, VAlign::baseline));
}

}  // namespace bole::render
