#include "render/maps/map_frame.h"

#include <algorithm>
#include <cmath>

namespace bole::render {
namespace {

void make_visible(MapExtent& extent) {
  if (!extent.empty()) return;
  extent.include({-1, -1});
  extent.include({1, 1});
}

}  // namespace

Frame map_frame(MapExtent extent, const Eigen::Vector2d& corner, double width_mm) {
  make_visible(extent);
  const double margin = 0.03 * std::max((extent.hi - extent.lo).maxCoeff(), 1.0) + 0.3;
  const Eigen::Vector2d lo = extent.lo.array() - margin, size = (extent.hi - extent.lo).array() + 2 * margin;
  const double height_mm = width_mm * std::clamp(size.y() / size.x(), 0.4, 1.4);
  const double mm_per_m = std::min(width_mm / size.x(), height_mm / size.y());
  const Eigen::Vector2d middle = lo + size / 2, half(width_mm / mm_per_m / 2, height_mm / mm_per_m / 2);
  return {{corner.x(), corner.y(), corner.x() + width_mm, corner.y() + height_mm},
          {middle.x() - half.x(), middle.x() + half.x()},
          {middle.y() - half.y(), middle.y() + half.y()}};
}

Frame fitted_frame(MapExtent extent, const Box& box) {
  make_visible(extent);
  const Eigen::Vector2d size = (extent.hi - extent.lo).cwiseMax(0.1), middle = (extent.lo + extent.hi) / 2;
  const double mm_per_m = std::min(box.width() / size.x(), box.height() / size.y());
  const Eigen::Vector2d half(box.width() / mm_per_m / 2, box.height() / mm_per_m / 2);
  return {box, {middle.x() - half.x(), middle.x() + half.x()}, {middle.y() - half.y(), middle.y() + half.y()}};
}

AxesStyle map_axes() {
  AxesStyle axes{"x (m)", "y (m)"};
  axes.frame = true;
  axes.x_ticks = axes.y_ticks = 8;
  return axes;
}

void draw_below(Canvas& canvas, const Frame& frame, const std::vector<LegendEntry>& entries) {
  const double y = frame.box.y1 + 16.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 30);
  draw_legend_row(canvas, {frame.box.x0 + bar_mm + 14, y - 2.6}, frame.box.width() - bar_mm - 14, entries);
}

}  // namespace bole::render
