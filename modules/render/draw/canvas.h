// A sheet of paper to draw on: millimetres from the top left corner, x right, y down. Whatever is drawn comes out alike
// as pixels, SVG and PDF.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "render/draw/color.h"

typedef struct _cairo cairo_t;  // NOLINT(clang-diagnostic-reserved-identifier): the library's name

namespace bole::render {

// A rectangle on the sheet in millimetres: x0 left, y0 top.
struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  double width() const { return x1 - x0; }
  double height() const { return y1 - y0; }
  Eigen::Vector2d centre() const { return {(x0 + x1) / 2, (y0 + y1) / 2}; }
  Box grown(double by) const { return {x0 - by, y0 - by, x1 + by, y1 + by}; }
  bool overlaps(const Box& other) const { return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1; }
  bool contains(const Box& other) const { return other.x0 >= x0 && other.x1 <= x1 && other.y0 >= y0 && other.y1 <= y1; }
  bool contains(const Eigen::Vector2d& p) const { return p.x() >= x0 && p.x() <= x1 && p.y() >= y0 && p.y() <= y1; }
};

// Rows from the top, 4 bytes per pixel: red, green, blue, opacity.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  Color pixel(int x, int y) const;
};

struct Stroke {
  Color color = ink::axis;
  double width_mm = 0.2;
  std::vector<double> dash_mm{};
};

enum class HAlign { left, centre, right };
enum class VAlign { top, middle, baseline, bottom };

struct TextStyle {
  double size_pt = 8;
  Color color = ink::text;
  bool bold = false;
  bool italic = false;
  HAlign h = HAlign::left;
  VAlign v = VAlign::baseline;
  double angle_rad = 0;  // counter-clockwise
  double halo_mm = 0;    // a rim of paper colour that keeps text readable over a picture
  TextStyle aligned(HAlign horizontal, VAlign vertical) const {
    TextStyle copy = *this;
    copy.h = horizontal, copy.v = vertical;
    return copy;
  }
};

class Canvas {
 public:
  // Draws through `cairo`, whose user space is in millimetres; keeps no ownership.
  Canvas(cairo_t* cairo, double width_mm, double height_mm);

  double width_mm() const { return width_mm_; }
  double height_mm() const { return height_mm_; }
  Box sheet() const { return {0, 0, width_mm_, height_mm_}; }

  void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Stroke& stroke);
  void polyline(std::span<const Eigen::Vector2d> points, const Stroke& stroke);
  void polygon(std::span<const Eigen::Vector2d> points, std::optional<Color> fill,
               const std::optional<Stroke>& stroke = {});
  void rectangle(const Box& box, std::optional<Color> fill, const std::optional<Stroke>& stroke = {},
                 double radius_mm = 0);
  void circle(const Eigen::Vector2d& centre, double radius_mm, std::optional<Color> fill,
              const std::optional<Stroke>& stroke = {});
  // The area between two circles.
  void ring(const Eigen::Vector2d& centre, double inner_mm, double outer_mm, const Color& fill);
  // An ellipse with half axes a, b; a points `angle_rad` counter-clockwise from right.
  void ellipse(const Eigen::Vector2d& centre, double a_mm, double b_mm, double angle_rad, std::optional<Color> fill,
               const std::optional<Stroke>& stroke = {});
  // Many round dots of one colour.
  void dots(std::span<const Eigen::Vector2d> centres, double diameter_mm, const Color& color);
  void cross(const Eigen::Vector2d& centre, double half_mm, const Stroke& stroke);
  void image(const Image& picture, const Box& box);

  void text(const Eigen::Vector2d& at, std::string_view utf8, const TextStyle& style = {});
  // Advance width and line height (ascent plus descent) in millimetres, before any rotation.
  Eigen::Vector2d text_size(std::string_view utf8, const TextStyle& style = {}) const;

  // Until the returned object goes, drawing is confined to the box.
  class Clip {
   public:
    Clip(cairo_t* cairo, const Box& box);
    ~Clip();
    Clip(const Clip&) = delete;
    Clip& operator=(const Clip&) = delete;

   private:
    cairo_t* cairo_;
  };
  [[nodiscard]] Clip clip(const Box& box) { return {cairo_, box}; }

 private:
  void paint_path(const std::optional<Color>& fill, const std::optional<Stroke>& stroke);
  void set_font(const TextStyle& style) const;
  cairo_t* cairo_;
  double width_mm_, height_mm_;
};

}  // namespace bole::render
