#include "render/draw/canvas.h"

#include <cairo.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "render/draw/dot_mask.h"
#include "render/draw/screen_look.h"

namespace bole::render {
namespace {

constexpr double mm_per_pt = 25.4 / 72;
constexpr double full_turn = 2 * std::numbers::pi;

Color shown(cairo_t* cairo, const Color& color) {
  const auto* look = look_of(cairo);
  return look != nullptr && look->dark ? on_dark(color) : color;
}

void set_color(cairo_t* cairo, const Color& color) {
  const Color c = shown(cairo, color);
  cairo_set_source_rgba(cairo, c.r, c.g, c.b, c.a);
}

void set_stroke(cairo_t* cairo, const Stroke& stroke) {
  set_color(cairo, stroke.color);
  cairo_set_line_width(cairo, stroke.width_mm);
  cairo_set_dash(cairo, stroke.dash_mm.data(), static_cast<int>(stroke.dash_mm.size()), 0);
}

std::string shown(cairo_t* cairo, std::string_view utf8) {
  const auto* look = look_of(cairo);
  return look != nullptr && look->words ? look->words(utf8) : std::string(utf8);
}

// Part of a text that one font has the characters of.
struct TextRun {
  std::string text;
  bool wide = false;  // Chinese, Japanese, Korean and what follows them in Unicode
};

// One run, unless the look has a font for wide characters: that need not have the Latin ones.
std::vector<TextRun> runs_of(cairo_t* cairo, const std::string& utf8) {
  const auto* look = look_of(cairo);
  if (look == nullptr || look->wide_font.empty()) return {{utf8, false}};
  std::vector<TextRun> runs{{}};
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    const bool first = (byte & 0xc0) != 0x80, wide = byte >= 0xe3;  // of a character; from U+3000
    if (first && wide != runs.back().wide) runs.push_back({{}, wide});
    runs.back().text += c;
  }
  return runs;
}

void use_wide_font(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, look_of(cairo)->wide_font.c_str(), CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
}

}  // namespace

Color Image::pixel(int x, int y) const {
  const auto* p =
      rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0, p[3] / 255.0};
}

Canvas::Canvas(cairo_t* cairo, double width_mm, double height_mm)
    : cairo_(cairo), width_mm_(width_mm), height_mm_(height_mm) {
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_BUTT);
  // Glyphs laid out without regard to pixels: the same figure at any resolution.
  auto* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(cairo_, options);
  cairo_font_options_destroy(options);
}

void Canvas::paint_path(const std::optional<Color>& fill, const std::optional<Stroke>& stroke) {
  if (fill) {
    set_color(cairo_, *fill);
    stroke ? cairo_fill_preserve(cairo_) : cairo_fill(cairo_);
  }
  if (stroke) {
    set_stroke(cairo_, *stroke);
    cairo_stroke(cairo_);
  }
  cairo_new_path(cairo_);
}

void Canvas::line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Stroke& stroke) {
  cairo_move_to(cairo_, a.x(), a.y());
  cairo_line_to(cairo_, b.x(), b.y());
  paint_path({}, stroke);
}

void Canvas::polyline(std::span<const Eigen::Vector2d> points, const Stroke& stroke) {
  for (const auto& p : points) cairo_line_to(cairo_, p.x(), p.y());
  paint_path({}, stroke);
}

void Canvas::polygon(std::span<const Eigen::Vector2d> points, std::optional<Color> fill,
                     const std::optional<Stroke>& stroke) {
  for (const auto& p : points) cairo_line_to(cairo_, p.x(), p.y());
  cairo_close_path(cairo_);
  paint_path(fill, stroke);
}

void Canvas::rectangle(const Box& box, std::optional<Color> fill, const std::optional<Stroke>& stroke,
                       double radius_mm) {
  if (radius_mm <= 0) {
    cairo_rectangle(cairo_, box.x0, box.y0, box.width(), box.height());
  } else {
    const double r = radius_mm, quarter = full_turn / 4;
    cairo_arc(cairo_, box.x1 - r, box.y0 + r, r, -quarter, 0);
    cairo_arc(cairo_, box.x1 - r, box.y1 - r, r, 0, quarter);
    cairo_arc(cairo_, box.x0 + r, box.y1 - r, r, quarter, 2 * quarter);
    cairo_arc(cairo_, box.x0 + r, box.y0 + r, r, 2 * quarter, 3 * quarter);
    cairo_close_path(cairo_);
  }
  paint_path(fill, stroke);
}

void Canvas::circle(const Eigen::Vector2d& centre, double radius_mm, std::optional<Color> fill,
                    const std::optional<Stroke>& stroke) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x(), centre.y(), radius_mm, 0, full_turn);
  cairo_close_path(cairo_);
  paint_path(fill, stroke);
}

void Canvas::ring(const Eigen::Vector2d& centre, double inner_mm, double outer_mm, const Color& fill) {
  cairo_new_sub_path(cairo_);
  cairo_arc(cairo_, centre.x(), centre.y(), outer_mm, 0, full_turn);
  cairo_close_path(cairo_);
  if (inner_mm > 0) {
    cairo_new_sub_path(cairo_);
    cairo_arc_negative(cairo_, centre.x(), centre.y(), inner_mm, full_turn, 0);
    cairo_close_path(cairo_);
  }
  paint_path(fill, {});
}

void Canvas::ellipse(const Eigen::Vector2d& centre, double a_mm, double b_mm, double angle_rad,
                     std::optional<Color> fill, const std::optional<Stroke>& stroke) {
  std::vector<Eigen::Vector2d> outline;
  constexpr int steps = 90;
  for (int i = 0; i < steps; ++i) {
    const double t = full_turn * i / steps;
    const double u = a_mm * std::cos(t), v = b_mm * std::sin(t);
    outline.emplace_back(centre.x() + u * std::cos(angle_rad) - v * std::sin(angle_rad),
                         centre.y() - u * std::sin(angle_rad) - v * std::cos(angle_rad));
  }
  polygon(outline, fill, stroke);
}

void Canvas::dots(std::span<const Eigen::Vector2d> centres, double diameter_mm, const Color& color) {
  if (draw_dot_mask(cairo_, centres, diameter_mm, shown(cairo_, color))) return;
  // A stroke of no length with round caps is a dot: far cheaper than a circle, and one path element in the vector
  // files.
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  for (const auto& p : centres) {
    cairo_move_to(cairo_, p.x(), p.y());
    cairo_close_path(cairo_);
  }
  paint_path({}, Stroke{color, diameter_mm});
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_BUTT);
}

void Canvas::cross(const Eigen::Vector2d& centre, double half_mm, const Stroke& stroke) {
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector2d d(half_mm, sign * half_mm);
    line(centre - d, centre + d, stroke);
  }
}

void Canvas::image(const Image& picture, const Box& box) {
  if (picture.width <= 0 || picture.height <= 0) return;
  auto* surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, picture.width, picture.height);
  cairo_surface_flush(surface);
  auto* target = cairo_image_surface_get_data(surface);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(target + y * stride);
    const auto* source = picture.rgba.data() + 4 * y * static_cast<std::size_t>(picture.width);
    for (std::size_t x = 0; x < static_cast<std::size_t>(picture.width); ++x, source += 4) {
      const std::uint32_t a = source[3];
      const auto pre = [a](std::uint32_t v) { return (v * a + 127) / 255; };
      row[x] = a << 24 | pre(source[0]) << 16 | pre(source[1]) << 8 | pre(source[2]);
    }
  }
  cairo_surface_mark_dirty(surface);
  cairo_save(cairo_);
  cairo_translate(cairo_, box.x0, box.y0);
  cairo_scale(cairo_, box.width() / picture.width, box.height() / picture.height);
  cairo_set_source_surface(cairo_, surface, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo_), CAIRO_FILTER_GOOD);
  cairo_pattern_set_extend(cairo_get_source(cairo_), CAIRO_EXTEND_PAD);
  cairo_rectangle(cairo_, 0, 0, picture.width, picture.height);
  cairo_fill(cairo_);
  cairo_restore(cairo_);
  cairo_surface_destroy(surface);
}

void Canvas::set_font(const TextStyle& style) const {
  cairo_select_font_face(cairo_, "Liberation Sans", style.italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_, style.size_pt * mm_per_pt);
}

Eigen::Vector2d Canvas::text_size(std::string_view utf8, const TextStyle& style) const {
  double advance = 0;
  for (const auto& run : runs_of(cairo_, shown(cairo_, utf8))) {
    set_font(style);
    if (run.wide) use_wide_font(cairo_, style);
    cairo_text_extents_t extents{};
    cairo_text_extents(cairo_, run.text.c_str(), &extents);
    advance += extents.x_advance;
  }
  set_font(style);
  cairo_font_extents_t font{};
  cairo_font_extents(cairo_, &font);
  return {advance, font.ascent + font.descent};
}

void Canvas::text(const Eigen::Vector2d& at, std::string_view utf8, const TextStyle& style) {
  if (utf8.empty()) return;
  const auto runs = runs_of(cairo_, shown(cairo_, utf8));
  const double advance = text_size(utf8, style).x();
  cairo_font_extents_t font{};
  cairo_font_extents(cairo_, &font);
  const double dx = style.h == HAlign::left ? 0 : style.h == HAlign::centre ? -advance / 2 : -advance;
  // "middle" centres the capitals, which is what the eye takes for the height of a line.
  const double capital = 0.716 * style.size_pt * mm_per_pt;
  const double dy = style.v == VAlign::top      ? capital
                    : style.v == VAlign::middle ? capital / 2
                    : style.v == VAlign::bottom ? -font.descent
                                                : 0;
  const auto draw = [&](void (*put)(cairo_t*, const char*)) {
    cairo_move_to(cairo_, dx, dy);
    for (const auto& run : runs) {  // each leaves the pen behind itself
      set_font(style);
      if (run.wide) use_wide_font(cairo_, style);
      put(cairo_, run.text.c_str());
    }
  };
  cairo_save(cairo_);
  cairo_translate(cairo_, at.x(), at.y());
  cairo_rotate(cairo_, -style.angle_rad);
  if (style.halo_mm > 0) {
    draw(cairo_text_path);
    set_stroke(cairo_, Stroke{ink::paper.with_alpha(0.85), 2 * style.halo_mm});
    cairo_stroke(cairo_);
  }
  set_color(cairo_, style.color);
  draw(cairo_show_text);
  cairo_restore(cairo_);
  cairo_new_path(cairo_);
}

Canvas::Clip::Clip(cairo_t* cairo, const Box& box) : cairo_(cairo) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, box.x0, box.y0, box.width(), box.height());
  cairo_clip(cairo_);
}

Canvas::Clip::~Clip() { cairo_restore(cairo_); }

}  // namespace bole::render
