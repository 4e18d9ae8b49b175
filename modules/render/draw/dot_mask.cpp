#include "render/draw/dot_mask.h"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace bole::render {
namespace {

constexpr int steps = 8;          // places within a pixel, each way
constexpr int samples = 8;        // of a pixel, each way, of which a dot covers some
constexpr double max_radius = 8;  // pixels; larger dots are few

// The share of each pixel that a dot covers whose centre is at one of steps x steps places in the middle pixel.
class DotStamps {
 public:
  explicit DotStamps(double radius) : reach_(static_cast<int>(std::ceil(radius))), side_(2 * reach_ + 1) {
    for (int v = 0; v < steps; ++v)
      for (int u = 0; u < steps; ++u) add((u + 0.5) / steps, (v + 0.5) / steps, radius);
  }
  int reach() const { return reach_; }
  const std::uint8_t* at(int u, int v) const {
    return covers_.data() + static_cast<std::ptrdiff_t>(v * steps + u) * side_ * side_;
  }

 private:
  void add(double x, double y, double radius) {
    for (int row = -reach_; row <= reach_; ++row)
      for (int column = -reach_; column <= reach_; ++column) {
        int inside = 0;
        for (int j = 0; j < samples; ++j)
          for (int i = 0; i < samples; ++i) {
            const double dx = column + (i + 0.5) / samples - x, dy = row + (j + 0.5) / samples - y;
            inside += dx * dx + dy * dy <= radius * radius ? 1 : 0;
          }
        covers_.push_back(static_cast<std::uint8_t>(255 * inside / (samples * samples)));
      }
  }

  int reach_, side_;
  std::vector<std::uint8_t> covers_;
};

// The pixels of the target that may be drawn to: x, y, and one beyond.
std::array<int, 4> drawn_pixels(cairo_t* cairo) {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  cairo_clip_extents(cairo, &x0, &y0, &x1, &y1);
  cairo_user_to_device(cairo, &x0, &y0);
  cairo_user_to_device(cairo, &x1, &y1);
  return {static_cast<int>(std::floor(x0)), static_cast<int>(std::floor(y0)), static_cast<int>(std::ceil(x1)),
          static_cast<int>(std::ceil(y1))};
}

}  // namespace

bool draw_dot_mask(cairo_t* cairo, std::span<const Eigen::Vector2d> centres, double diameter, const Color& color) {
  if (cairo_surface_get_type(cairo_get_group_target(cairo)) != CAIRO_SURFACE_TYPE_IMAGE) return false;
  cairo_matrix_t m;
  cairo_get_matrix(cairo, &m);
  const double radius = diameter * m.xx / 2;
  if (m.xy != 0 || m.yx != 0 || m.xx != m.yy || !(radius > 0 && radius <= max_radius)) return false;
  const auto [left, top, right, bottom] = drawn_pixels(cairo);
  const int width = right - left, height = bottom - top;
  if (width <= 0 || height <= 0) return true;
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> mask(
      cairo_image_surface_create(CAIRO_FORMAT_A8, width, height), cairo_surface_destroy);
  if (cairo_surface_status(mask.get()) != CAIRO_STATUS_SUCCESS) return false;
  cairo_surface_flush(mask.get());
  auto* pixels = cairo_image_surface_get_data(mask.get());
  const auto stride = static_cast<std::ptrdiff_t>(cairo_image_surface_get_stride(mask.get()));
  const DotStamps stamps(radius);
  for (const auto& centre : centres) {
    const double x = centre.x() * m.xx + m.x0 - left, y = centre.y() * m.yy + m.y0 - top;
    const int reach = stamps.reach();
    if (!(x > -reach && y > -reach && x < width + reach && y < height + reach)) continue;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const auto* cover = stamps.at(static_cast<int>((x - column) * steps), static_cast<int>((y - row) * steps));
    for (int v = row - reach; v <= row + reach; ++v)
      for (int u = column - reach; u <= column + reach; ++u, ++cover) {
        if (u < 0 || v < 0 || u >= width || v >= height || *cover == 0) continue;
        auto& pixel = pixels[v * stride + u];
        pixel = static_cast<std::uint8_t>(pixel + *cover - pixel * *cover / 255);
      }
  }
  cairo_surface_mark_dirty(mask.get());
  cairo_save(cairo);
  cairo_identity_matrix(cairo);
  cairo_set_source_rgba(cairo, color.r, color.g, color.b, color.a);
  cairo_mask_surface(cairo, mask.get(), left, top);
  cairo_restore(cairo);
  return true;
}

}  // namespace bole::render
